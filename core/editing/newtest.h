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

/// What a new positioning test begins with.
struct NewPositioningTest {
    Axis axis;
    std::string edition = defaultEdition(Kind::positioning).word;
    std::optional<Cycle> cycle;  ///< null: not stated
    std::vector<double> targets; ///< mm, rotary: degrees; strictly ascending
    TargetChoice targetChoice;   ///< how they came about
    int runs = 5;                ///< a direction
    bool bothDirections = true;
};

/// What a new circular test begins with; its arcs come later.
struct NewCircularTest {
    Plane plane{"X", "Y"};
    double nominalRadius = 150; ///< mm
    std::optional<double> feed; ///< mm/min
    SignalSource source = SignalSource::external;
    std::string edition = defaultEdition(Kind::circular).word;
};

[[nodiscard]] Test newTest(const NewCircularTest &wanted);

/// A test with a place for every reading and no reading yet: ↑ and ↓ in turn.
[[nodiscard]] Test newTest(const NewPositioningTest &wanted);

/// A drift test of an axis without readings yet.
[[nodiscard]] Test newDriftTest(const Axis &axis);

/// `count` targets from `first` to `last` with equal intervals, rounded to whole steps of `resolution` (0:
/// not rounded); fewer where rounding makes two the same. Of count 1 the first; empty unless first < last.
[[nodiscard]] std::vector<double> evenTargets(double first, double last, std::size_t count,
                                              double resolution = 0);

/// The number of targets the standard asks for: 5 a metre, at least 5 (positioning tests of linear axes up to
/// 2 000 mm; beyond, one every 250 mm); of rotary axes 3 up to 90°, 5 up to 180°, 8 above, 8 a turn.
[[nodiscard]] std::size_t targetsWanted(const Axis &axis);

/// An id that no test of the document has: "x1", "x2", … after the name of the axis, "t1" without one.
[[nodiscard]] std::string freshId(const Document &document, const Test &test);

/// Puts a test behind `index` (the last for the number of tests), with an id of its own. Returns its index.
std::size_t insertTest(Document &document, std::size_t index, Test test);

/// A copy of a test behind it, with its title and, unless `withReadings`, without readings or arcs: the same
/// test again.
std::size_t duplicateTest(Document &document, std::size_t index, bool withReadings);

/// Removes a test. What other tests say of it (their drift test) goes with it: a file that names a test which
/// is not there could not be opened.
void removeTest(Document &document, std::size_t index);

} // namespace palmer
