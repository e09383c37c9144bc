// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/testevaluation.h"
#include "kernel/measurement/test.h"

#include <string_view>
#include <vector>

namespace palmer {

/// A statement that the rows of an edition ask of the conditions of a test, whether or not it is stated.
struct AskedStatement {
    std::string_view key; ///< last part of its path in the file: "travel" for "axis.travel"
    bool usual =
        true; ///< a laboratory states it; the edition, or its text as far as it is known, does not ask
};

/// Returns each key once, in the order of the rows that apply; empty for drift tests.
[[nodiscard]] std::vector<AskedStatement> askedStatements(const Test &test, const TestEvaluation &evaluation);

} // namespace palmer
