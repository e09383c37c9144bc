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

/// A value that a budget may take, and where it comes from.
struct TypicalValue {
    QString value;  ///< "R(α) of the machine 3.4 µm/(m·°C)"
    QString source; ///< "the typical minimum of ISO 230-2"
    /// Paths in the test and what withField takes there.
    std::vector<std::pair<std::string, std::string>> fields;
};

/// What can be offered for the inputs of the budget of a test: what the standard gives, what the instruments
/// of the test and its drift tests say. Never invented ones.
[[nodiscard]] std::vector<TypicalValue> typicalValues(const Document &document, const Test &test,
                                                      const Language &language);

/// The document with such a value in its test.
[[nodiscard]] Document withTypicalValue(Document document, std::size_t test, const TypicalValue &value);

/// The path of a field of a test in its file.
[[nodiscard]] std::string pathInFile(std::size_t test, const std::string &field);

/// The drift tests of a document that E_VE of a test can be taken from: those of the same kind of axis, and
/// the one it names already. In the order of the document.
[[nodiscard]] std::vector<TestPointer> driftTestsFor(const Document &document, const Test &test);

/// Title of a drift test, or the name of its axis.
[[nodiscard]] QString driftTestName(const Test &drift, const Language &language);

} // namespace palmer
