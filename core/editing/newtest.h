// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "kernel/evaluation/edition.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace palmer {

/// Parameters of a new positioning test.
struct NewPositioningTest {
    Axis axis;
    std::string edition = defaultEdition(Kind::positioning).word;
    std::optional<Cycle> cycle;  ///< null: not stated
    std::vector<double> targets; ///< mm, rotary: degrees; strictly ascending
    TargetChoice targetChoice;   ///< how they were chosen
    int runs = 5;                ///< per direction
    bool bothDirections = true;
};

/// Parameters of a new circular test, which has no arcs yet.
struct NewCircularTest {
    Plane plane{"X", "Y"};
    double nominalRadius = 150; ///< mm
    std::optional<double> feed; ///< mm/min
    SignalSource source = SignalSource::external;
    std::string edition = defaultEdition(Kind::circular).word;
};

[[nodiscard]] Test newTest(const NewCircularTest &wanted);

/// A test with a place for every reading but no readings; runs alternate ↑ and ↓.
[[nodiscard]] Test newTest(const NewPositioningTest &wanted);

/// A drift test of an axis, without readings.
[[nodiscard]] Test newDriftTest(const Axis &axis);

/// `count` targets from `first` to `last` at equal intervals, rounded to multiples of `resolution` (0: not
/// rounded); fewer if rounding makes two equal. For count 1 only the first; empty unless first < last.
[[nodiscard]] std::vector<double> evenTargets(double first, double last, std::size_t count,
                                              double resolution = 0);

/// An ID unused in the document: "x1", "x2", … from the name of the axis, "t1" without one.
[[nodiscard]] std::string freshId(const Document &document, const Test &test);

/// Inserts a test after test `index` (the number of tests: at the end) with a unique ID. Returns its index.
std::size_t insertTest(Document &document, std::size_t index, Test test);

/// Inserts a copy of a test after it, with its title and, unless `withReadings`, without readings or arcs, to
/// repeat the test.
std::size_t duplicateTest(Document &document, std::size_t index, bool withReadings);

/// Removes a test and references to it (as drift test of other tests), as a file that refers to a missing
/// test could not be opened.
void removeTest(Document &document, std::size_t index);

} // namespace palmer
