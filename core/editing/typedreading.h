#pragma once

#include "editing/typednumber.h"
#include "kernel/measurement/axis.h"
#include "language/units.h"

namespace palmer {

/// What a typed text says of a reading: a deviation (mm, rotary: degrees), nothing, or why it is no number.
struct TypedReading {
    std::optional<double> deviation;
    Text problem; ///< empty: none

    [[nodiscard]] bool isEmpty() const { return !deviation && problem.empty(); }
};

/// Reads a deviation in the unit it is shown in; with a `target` an actual position in the unit positions are
/// shown in, of which the deviation is the distance from the target.
[[nodiscard]] TypedReading typedReading(QStringView text, const Axis &axis, const DisplayUnits &units,
                                        std::optional<double> target = std::nullopt);

/// The deviation of an actual position from its target, without the rounding errors of the difference: to a
/// millionth of a micrometre.
[[nodiscard]] double deviationFrom(double target, double position);

} // namespace palmer
