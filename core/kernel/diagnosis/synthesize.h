// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/diagnosis/influences.h"
#include "kernel/measurement/circular.h"
#include "kernel/measurement/positioning.h"

#include <string_view>
#include <vector>

namespace palmer {

/// Noise of made measurements, mm. Neighbours in time are correlated by `correlation` (0 … below 1); the
/// reading is rounded to a multiple of `resolution` (0: not).
struct SynthesizedNoise {
    double deviation = 0;
    double correlation = 0;
    double resolution = 0;
    long long seed = 1;
};

/// An influence that a made circle is to have.
struct CircularSource {
    InfluenceId id = InfluenceId::squareness;
    PlaneAxis axis = PlaneAxis::none;
    double value = 0; ///< base unit: mm, rad, s
    double shape = 0; ///< pitch of a cyclic error, mm; width of a spike, degrees
    double phase = 0; ///< of a cyclic error in the centre, rad
};

/// A vibration between spindle and table as it shows in the radius: A·sin(2πft), t from the start of each
/// arc.
struct SynthesizedVibration {
    double amplitude = 0;  ///< A, mm
    double frequency = 10; ///< f, Hz
};

/// A circular test with known truth: the columns of the diagnosis, added up, and noise. Points are as the
/// machine reaches them at equal angles about its own centre, half a step off the ends of the arc.
struct CircularSynthesis {
    Plane plane{"X", "Y"};
    double radius = 150;                                                  ///< mm
    double feed = 1000;                                                   ///< mm/min
    std::vector<Sense> senses{Sense::counterclockwise, Sense::clockwise}; ///< in the order of time
    Interval arc{0, 360};                                                 ///< degrees
    std::size_t points = 1800;                                            ///< each sense
    double pause = 0;                                                     ///< between the arcs, turns
    std::vector<CircularSource> sources;
    SynthesizedVibration vibration;
    SynthesizedNoise noise;
};

[[nodiscard]] CircularMeasurement synthesizeCircular(const CircularSynthesis &asked);

/// What a made positioning test is to have; lengths in mm, from the first target on.
struct PositioningSynthesis {
    std::string axis = "X";
    std::vector<double> targets;
    int runs = 5;            ///< each way
    double scale = 0;        ///< deviation by travel, mm/mm
    double cyclic = 0;       ///< amplitude of a periodic error, mm
    double pitch = 10;       ///< its period, mm
    double phase = 0;        ///< at the first target, rad
    double backlash = 0;     ///< lost motion, mm: what comes from above stands so much too far
    double reversal = 0;     ///< further lost motion, 0 at the first target and this at the last, mm
    double drift = 0;        ///< of the zero from the first reading to the last, mm
    double temperature = 20; ///< of the machine, °C
    double expansion = 11.7; ///< of its scale, µm/(m·°C)
    SynthesizedNoise noise;
};

[[nodiscard]] PositioningMeasurement synthesizePositioning(const PositioningSynthesis &asked);

} // namespace palmer
