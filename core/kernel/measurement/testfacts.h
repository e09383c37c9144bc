// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/test.h"
#include "kernel/words/quantity.h"
#include "kernel/words/text.h"

#include <cstddef>
#include <type_traits>

namespace palmer {

// Facts about a test of any kind, derived from the parts its measurement has: an axis or a plane, conditions,
// inputs of the uncertainty. A new kind with these parts needs no change here.

/// Returns `take` applied to the measurement (or results) of a test if that kind has the part `take` reads,
/// otherwise `otherwise`. `take` returns a decltype, so that it does not compile for kinds without the part.
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

/// Kinds that no edition judges have no conditions. What only judged kinds have needs one overload for all
/// others.
template <class Measurement>
concept Unjudged = !requires(Measurement & measurement) {
    measurement.conditions;
};

/// Properties of a kind of test.
struct KindOfTest {
    Text name;
    bool isJudged = false;   ///< has an edition, points to agree and limits
    bool isOfAxis = false;   ///< tests one axis, otherwise a plane
    bool hasTargets = false; ///< has readings in runs at target positions
};
[[nodiscard]] const KindOfTest &traitsOf(Kind kind);
[[nodiscard]] inline const KindOfTest &traitsOf(const Test &test) {
    return traitsOf(kindOf(test));
}

/// Returns an empty test of this kind.
[[nodiscard]] Test testOf(Kind kind);

/// Returns the axis of a test of one axis; null for a plane.
[[nodiscard]] const Axis *axisOf(const Test &test);

/// Returns rotary if the readings are angles.
[[nodiscard]] Motion motionOf(const Test &test);

/// Quantity of the deviations or the feed of a test: linear, or angular for a rotary axis; of a drift test
/// that of its main channel.
[[nodiscard]] Quantity deviationQuantity(const Test &test);
[[nodiscard]] Quantity deviationQuantity(const DriftMeasurement &measurement);
[[nodiscard]] Quantity deviationQuantity(const DriftChannel &channel);
[[nodiscard]] Quantity feedQuantity(const Test &test);

/// Returns "X", or "XY" for a plane; empty if none is stated.
[[nodiscard]] std::string axesOf(const Test &test);

/// Returns the stated conditions of a test; null for a drift test.
[[nodiscard]] Conditions *conditionsOf(Test &test);
[[nodiscard]] const Conditions *conditionsOf(const Test &test);

/// True if the test has an edition, points to agree and limits; false for drift tests.
[[nodiscard]] inline bool isJudged(const Test &test) {
    return traitsOf(test).isJudged;
}

/// True for a test of this kind. Not the same as “not judged” or “of a plane”, which other kinds may be, too.
[[nodiscard]] inline bool isDrift(const Test &test) {
    return kindOf(test) == Kind::drift;
}
[[nodiscard]] inline bool isCircle(const Test &test) {
    return kindOf(test) == Kind::circular;
}

/// Calls `use` with the uncertainty inputs of a test, for members common to all kinds (method, seed, …); does
/// nothing for kinds without a budget.
template <class AnyTest, class Use>
void withUncertainty(AnyTest &test, Use use) {
    std::visit(
        [&](auto &measurement) {
            if constexpr (requires { measurement.uncertainty; })
                use(measurement.uncertainty);
        },
        test.measurement);
}

/// Returns the selected uncertainty method; null if the kind of test has no budget.
[[nodiscard]] const UncertaintyMethod *methodOf(const Test &test);

/// Returns the id of the drift test that gives E_VE; null if none is named.
[[nodiscard]] const std::string *driftTestOf(const Test &test);

/// Returns the channels of a drift test; `deviations` are one with the name of the axis.
[[nodiscard]] std::vector<DriftChannel> channelsOf(const DriftMeasurement &measurement);

/// Returns the channel of a drift test named as its axis, otherwise its first; empty without readings.
[[nodiscard]] DriftChannel mainChannel(const DriftMeasurement &measurement);

/// Returns E_VE of the whole record: largest − smallest deviation at rest of the main channel, mm or degrees;
/// null without readings.
[[nodiscard]] std::optional<double> rangeOf(const DriftMeasurement &measurement);

/// True if the form shows the device's uncertainty per metre: a rotary axis has no metres, but a value read
/// from a file must be removable.
[[nodiscard]] bool asksPerMetre(const Test &test);

/// True for two judged tests of one kind on the same axis or plane.
[[nodiscard]] bool areOfSameAxis(const Test &a, const Test &b);

/// Returns the number of readings, missing ones included, or of points of circles.
[[nodiscard]] std::size_t readingsOf(const Test &test);

/// True for a positioning test without targets or runs, or with a missing reading that was not set aside.
[[nodiscard]] bool isUnfinished(const Test &test);

/// Returns `alike` of the two measurements; false for tests of different kinds.
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
