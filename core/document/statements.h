// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "document/documenterror.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace palmer {

/// A value stated at a path of a test file, for outputs with a line for each: "conditions.expansion.machine".
struct Statement {
    std::string path;
    std::string value;                 ///< a JSON literal, or a text
    std::optional<double> number = {}; ///< a number that may have decimals; `value` is then empty
};

/// Returns all statements of a document about a test except its readings: paths of the test
/// ("conditions.feed"), of its machine and of the instruments used ("machine.name", "instruments[0].model").
/// Unstated values are omitted, except whether the readings are corrected to 20 °C. A named drift test is
/// replaced by its range. Texts fit on one line and show their control characters.
[[nodiscard]] std::vector<Statement> statementsOf(const Document &document, std::size_t index);

/// Returns the document given by such statements: one test, whose readings are JSON lists
/// ("runs[0].deviations"). Throws Error like readDocument, and for invalid paths.
[[nodiscard]] Document documentOf(std::span<const Statement> statements);

} // namespace palmer
