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

/// A value that a test file states at a path, for outputs that have a line for each:
/// "conditions.expansion.machine".
struct Statement {
    std::string path;
    std::string value;                 ///< a literal of JSON, or a text
    std::optional<double> number = {}; ///< a number that may have decimals; its value is empty
};

/// All that a document says of a test but its readings: paths of the test ("conditions.feed"), of its machine
/// and of the instruments it was made with ("machine.name", "instruments[0].model"). What is not stated is
/// left out, except whether the readings are corrected to 20 °C. A drift test that the test names is replaced
/// by its range. Texts fit on one line and show their control characters.
[[nodiscard]] std::vector<Statement> statementsOf(const Document &document, std::size_t index);

/// The document that such statements say: one test, with the readings among them as lists of JSON
/// ("runs[0].deviations"). Throws Error as readDocument, and for what is no path.
[[nodiscard]] Document documentOf(std::span<const Statement> statements);

} // namespace palmer
