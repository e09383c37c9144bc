// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/axis.h"
#include "kernel/measurement/conditions.h"
#include "kernel/measurement/uncertaintyinputs.h"

#include <optional>
#include <string>
#include <vector>

namespace palmer {

/// Sense of contouring; counterclockwise leads from the first axis towards the second (ISO 230-4, 3.8).
enum class Sense { counterclockwise, clockwise };

/// Meaning of the angles of an arc: of the measured point (polar) or the programmed path (commanded).
enum class AngleReference { polar, commanded };

enum class SignalSource { external, feedback };
enum class Centring { leastSquares, instrument };
enum class ReferenceCircle { minimumZone, leastSquares };

/// Which property of a circle a result of ISO 230-4 describes: G and G(b), F, D, H.
enum class OfCircle { nothing, deviation, radialDeviation, meanRadialDeviation, hysteresis };

struct Plane {
    std::string first;
    std::string second;

    bool operator==(const Plane &) const = default;
};

struct ReferenceLength {
    std::optional<bool> calibrated;
    std::optional<double> expandedUncertainty; ///< µm
    double coverageFactor = 2;

    bool operator==(const ReferenceLength &) const = default;
};

/// One measured path in one sense. Angles in degrees from the first axis towards the second, unwrapped;
/// radial deviations in mm, positive outwards, one per angle.
struct Arc {
    Sense sense = Sense::counterclockwise;
    AngleReference angleReference = AngleReference::polar;
    std::vector<double> angles;
    std::vector<double> radialDeviations;
    std::optional<Interval> evaluated;    ///< unwrapped degrees; null: all, or the middle 360°
    std::optional<double> sampleInterval; ///< s
    std::string cutOff = {};              ///< range left out by `evaluated`: feed-in, overshoot

    bool operator==(const Arc &) const = default;
};

/// The circle as it was specified: ISO 230-4:2005, Annex C.
struct SpecifiedCircle {
    std::optional<double> diameter; ///< mm
    std::optional<double> feed;     ///< mm/min

    bool operator==(const SpecifiedCircle &) const = default;
};

/// A circular test as measured (ISO 230-4); arcs in chronological order.
struct CircularMeasurement {
    Plane plane;
    std::string positionFeedback;
    double nominalRadius = 0;   ///< mm
    std::optional<double> feed; ///< mm/min
    SpecifiedCircle specified;
    SignalSource source = SignalSource::external;
    Centring centring = Centring::leastSquares;
    ReferenceCircle referenceCircle = ReferenceCircle::minimumZone;
    ReferenceLength referenceLength;
    std::vector<std::string> requiredResults; ///< quantities as in limits; empty: all
    std::vector<Arc> arcs;
    CircularConditions conditions;
    CircularUncertaintyInputs uncertainty;

    bool operator==(const CircularMeasurement &) const = default;
};

} // namespace palmer
