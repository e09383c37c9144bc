// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/test.h"
#include "kernel/words/quantity.h"

#include <cstddef>
#include <type_traits>

namespace palmer {

// What a test says whatever its kind. A measurement answers by the parts it has: an axis or a plane,
// conditions, inputs of the uncertainty. A new kind that has them needs nothing here.

/// What `take` says of the measurement of a test, or of its results: of a part that not every kind has.
/// `otherwise` where they have none: where `take`, which returns a decltype, does not compile with them.
template <class Value, class Alternatives, class Take>
[[nodiscard]] Value partOr(Value otherwise, Alternatives &ofKinds, Take take) {
    return std::visit(
        [&](auto &ofKind) -> Value {
            if constexpr (requires { take(ofKind); })
                return take(ofKind);
            else
                return otherwise;
        },
        ofKinds);
}

/// What tests of a kind have.
struct KindOfTest {
    bool isJudged = false;   ///< held to an edition, its points to agree and its limits
    bool isOfAxis = false;   ///< of one axis; else of a plane
    bool hasTargets = false; ///< readings of runs at target positions
};
[[nodiscard]] const KindOfTest &traitsOf(Kind kind);
[[nodiscard]] inline const KindOfTest &traitsOf(const Test &test) {
    return traitsOf(kindOf(test));
}

/// A test of that kind that says nothing yet.
[[nodiscard]] Test testOf(Kind kind);

/// The axis of a test of one axis; null for a plane.
[[nodiscard]] const Axis *axisOf(const Test &test);

/// Rotary where the readings are angles.
[[nodiscard]] Motion motionOf(const Test &test);

/// What the deviations and the feed of a test are: lengths, or angles of a rotary axis.
[[nodiscard]] Quantity deviationQuantity(const Test &test);
[[nodiscard]] Quantity feedQuantity(const Test &test);

/// "X", or "XY" of a plane; empty where none is stated.
[[nodiscard]] std::string axesOf(const Test &test);

/// What a test states of its conditions; null for a drift test.
[[nodiscard]] Conditions *conditionsOf(Test &test);
[[nodiscard]] const Conditions *conditionsOf(const Test &test);

/// Held to an edition, its points to agree and its limits: drift tests are not.
[[nodiscard]] inline bool isJudged(const Test &test) {
    return traitsOf(test).isJudged;
}

/// The method, the seed, …: what the inputs of all budgets have. Calls `use` with those of the test, not at
/// all where its kind has no budget.
template <class AnyTest, class Use>
void withUncertainty(AnyTest &test, Use use) {
    std::visit(
        [&](auto &measurement) {
            if constexpr (requires { measurement.uncertainty; })
                use(measurement.uncertainty);
        },
        test.measurement);
}

/// The method that decides; null where the kind of test has no budget.
[[nodiscard]] const UncertaintyMethod *methodOf(const Test &test);

/// The id of the drift test that gives E_VE; null where none is named.
[[nodiscard]] const std::string *driftTestOf(const Test &test);

/// E_VE, the environmental variation error: the largest less the smallest deviation at rest, mm or degrees;
/// null without readings, and for a test of another kind.
[[nodiscard]] std::optional<double> rangeOf(const DriftMeasurement &measurement);
[[nodiscard]] std::optional<double> rangeAtRest(const Test &test);

/// Whether the device has an uncertainty per metre to state: a rotary axis has no metres, but what a file
/// says of them is there to be taken out.
[[nodiscard]] bool asksPerMetre(const Test &test);

/// Judged tests of one kind and of the same axis, or plane.
[[nodiscard]] bool areOfSameAxis(const Test &a, const Test &b);

/// Readings with the missing ones, points of circles.
[[nodiscard]] std::size_t readingsOf(const Test &test);

/// A positioning test without targets or runs, or with a reading that is missing and was not set aside.
[[nodiscard]] bool isUnfinished(const Test &test);

/// What `alike` says of the measurements of two tests of one kind; false for tests of two kinds.
template <class Alike>
[[nodiscard]] bool areOfOneKind(const Test &a, const Test &b, Alike alike) {
    return std::visit(
        [&](const auto &first) {
            const auto *second = std::get_if<std::remove_cvref_t<decltype(first)>>(&b.measurement);
            return second && alike(first, *second);
        },
        a.measurement);
}

} // namespace palmer
