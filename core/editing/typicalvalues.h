// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "language/language.h"

#include <QString>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace palmer {

/// A value offered for a budget, and its source.
struct TypicalValue {
    QString value;  ///< "R(α) of the machine 3.4 µm/(m·°C)"
    QString source; ///< "the typical minimum of ISO 230-2"
    /// Paths in the test with values for withField.
    std::vector<std::pair<std::string, std::string>> fields;
};

/// Values offered for the budget inputs of a test, from the standard, the instruments of the test and its
/// drift tests. Never invented.
[[nodiscard]] std::vector<TypicalValue> typicalValues(const Document &document, const Test &test,
                                                      const Language &language);

/// Returns the document with such a value set in its test.
[[nodiscard]] Document withTypicalValue(Document document, std::size_t test, const TypicalValue &value);

/// The path of a test's field in the file.
[[nodiscard]] std::string pathInFile(std::size_t test, const std::string &field);

/// The drift tests that can provide E_VE of a test: those of the same kind of axis, and the one already
/// selected. In document order.
[[nodiscard]] std::vector<TestPointer> driftTestsFor(const Document &document, const Test &test);

/// Title of a drift test, or the name of its axis.
[[nodiscard]] QString driftTestName(const Test &drift, const Language &language);

} // namespace palmer
