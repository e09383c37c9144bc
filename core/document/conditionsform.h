// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/testevaluation.h"
#include "kernel/measurement/test.h"
#include "kernel/words/text.h"

#include <string>
#include <string_view>
#include <vector>

namespace palmer {

/// A statement in the form of the conditions.
struct FormCell {
    std::string_view key;  ///< as in findings about its absence
    std::string_view part; ///< of a value with several parts: "kind"; empty: the whole
    int columns = 0;       ///< of twelve
    Text name = {};        ///< empty: that of the stated thing
};

/// Statements that belong together, under a common name.
struct FormGroup {
    Text name;
    std::vector<FormCell> cells;
    bool lacks = false; ///< something asked for in it is missing
};

/// The things that the conditions of a test are asked for.
struct ConditionsForm {
    std::vector<FormGroup> asked; ///< by the edition, with what the test needs to be known by
    std::vector<FormGroup> usual; ///< in practice only
    std::vector<FormGroup> other; ///< by nobody, but can be stated
};

/// Returns what kind, axis and edition of the test ask for, each statement once and in the order of the form;
/// empty for tests without conditions. An edition that asks for nothing by itself asks for what is usual.
[[nodiscard]] ConditionsForm conditionsForm(const Test &test, const TestEvaluation &evaluation);

/// The declarations that meet a requirement of the edition, in the order of the form.
[[nodiscard]] std::vector<std::string_view> declarationKeys();

/// Returns the clause of the edition that asks for a declaration; empty if it is not known.
[[nodiscard]] std::string clauseOfDeclaration(const Edition &edition, std::string_view key);

} // namespace palmer
