// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/agreement.h"
#include "kernel/measurement/circular.h"
#include "kernel/measurement/drift.h"
#include "kernel/measurement/positioning.h"

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace palmer {

/// A result stated by the instrument's own software.
struct ImportedResult {
    std::string name;
    double value = 0;
    std::string unit;

    bool operator==(const ImportedResult &) const = default;
};

/// The file a measurement came from.
struct ImportedFile {
    std::string fileName;
    std::string sha256;
    std::optional<std::string> data; ///< base64, when the user keeps the bytes
    std::vector<ImportedResult> results;
    std::optional<bool> signAssumed; ///< actual − target was assumed, as the file states no sign

    bool operator==(const ImportedFile &) const = default;
};

enum class Purpose {
    notStated,
    type,
    acceptance,
    comparison,
    periodic,
    compensation,
    afterRepair,
    afterCollision,
    other
};

/// State of the machine in a test: before or after its adjustment.
enum class TestRole { notStated, asFound, asLeft };

/// Declaration by the laboratory, which owns the text of the edition, about requirements not checked here.
struct DeclaredAccordance {
    std::string by;                  ///< empty: nothing was declared
    std::optional<std::string> date; ///< YYYY-MM-DD
    std::string text;

    bool operator==(const DeclaredAccordance &) const = default;
};

/// An earlier test of the file that a test is compared with, see comparetests.h.
struct ComparedWith {
    std::string test;                     ///< its id
    std::optional<double> tolerance = {}; ///< agreed for a change, mm or degrees
    bool setUpUntouched = false;          ///< the instrument stood as it had been aligned

    bool operator==(const ComparedWith &) const = default;
};

/// In the order of the alternatives of Test::measurement.
enum class Kind { positioning, circular, drift };

/// One test of a report: the parts common to all kinds, and the measurement. `edition` is the word in the
/// file, echoed literally; drift tests have none. `extensions` is a JSON object kept as text.
struct Test {
    std::string id;
    std::string title;
    std::optional<std::string> date; ///< YYYY-MM-DD
    std::optional<std::string> time; ///< HH:MM
    std::vector<std::string> instruments;
    std::string edition;
    Purpose purpose = Purpose::notStated;
    TestRole role = TestRole::notStated;
    DeclaredAccordance declaredAccordance;
    std::optional<double> duration; ///< min
    std::optional<ComparedWith> comparedWith;
    std::vector<AgreedPoint> agreedPoints;
    Limits limits;
    DecisionRule decisionRule;
    std::vector<ImportedFile> imports;
    std::string remarks;
    std::string extensions = "{}";
    std::variant<PositioningMeasurement, CircularMeasurement, DriftMeasurement> measurement;

    bool operator==(const Test &) const = default;
};

/// As many as there are measurements.
inline constexpr auto allKinds = [] {
    std::array<Kind, std::variant_size_v<decltype(Test::measurement)>> kinds{};
    for (std::size_t i = 0; i < kinds.size(); ++i)
        kinds[i] = static_cast<Kind>(i);
    return kinds;
}();

/// Returns the kind of a test, given by its measurement.
[[nodiscard]] inline Kind kindOf(const Test &test) {
    return static_cast<Kind>(test.measurement.index());
}

} // namespace palmer
