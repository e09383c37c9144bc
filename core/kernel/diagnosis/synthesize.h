// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/diagnosis/influences.h"
#include "kernel/measurement/circular.h"
#include "kernel/measurement/drift.h"
#include "kernel/measurement/positioning.h"

#include <string_view>
#include <vector>

namespace palmer {

/// Noise of synthesized measurements, mm. `correlation` (0 … below 1) is that of consecutive readings;
/// readings are rounded to a multiple of `resolution` (0: not rounded).
struct SynthesizedNoise {
    double deviation = 0;
    double correlation = 0;
    double resolution = 0;
    long long seed = 1;
};

/// An influence to be added to a synthesized circle.
struct CircularSource {
    InfluenceId id = InfluenceId::squareness;
    PlaneAxis axis = PlaneAxis::none;
    double value = 0; ///< base unit: mm, rad, s
    double shape = 0; ///< pitch of a cyclic error, mm; width of a spike, degrees
    double phase = 0; ///< of a cyclic error at the centre, rad
};

/// A vibration between spindle and table as seen in the radius: A·sin(2πft), t from the start of each arc.
struct SynthesizedVibration {
    double amplitude = 0;  ///< A, mm
    double frequency = 10; ///< f, Hz
};

/// A circular test with known truth: the columns of the diagnosis, added up, plus noise. Points are those the
/// machine reaches at equal angles about its own centre, half a step from the ends of the arc.
struct CircularSynthesis {
    Plane plane{"X", "Y"};
    double radius = 150;                                                  ///< mm
    double feed = 1000;                                                   ///< mm/min
    std::vector<Sense> senses{Sense::counterclockwise, Sense::clockwise}; ///< in chronological order
    Interval arc{0, 360};                                                 ///< degrees
    std::size_t points = 1800;                                            ///< per sense
    double pause = 0;                                                     ///< between the arcs, turns
    std::vector<CircularSource> sources;
    SynthesizedVibration vibration;
    SynthesizedNoise noise;
};

[[nodiscard]] CircularMeasurement synthesizeCircular(const CircularSynthesis &asked);

/// A synthesized positioning test; lengths in mm, from the first target.
struct PositioningSynthesis {
    std::string axis = "X";
    std::vector<double> targets;
    int runs = 5;            ///< per direction
    double scale = 0;        ///< deviation per travel, mm/mm
    double cyclic = 0;       ///< amplitude of a periodic error, mm
    double pitch = 10;       ///< its period, mm
    double phase = 0;        ///< at the first target, rad
    double backlash = 0;     ///< lost motion, mm: negative approaches stop that much too far
    double reversal = 0;     ///< additional lost motion, mm: 0 at the first target, this value at the last
    double drift = 0;        ///< of the zero, from the first to the last reading, mm
    double temperature = 20; ///< of the machine, °C
    double expansion = 11.7; ///< of its scale, µm/(m·°C)
    SynthesizedNoise noise;
};

[[nodiscard]] PositioningMeasurement synthesizePositioning(const PositioningSynthesis &asked);

/// A channel of a synthesized drift test: x = k·y + b·t with τ·dy/dt = θ − y.
struct DriftChannelSynthesis {
    std::string name = "X";
    double perDegree = 0; ///< k, mm/°C
    double tau = 2400;    ///< s
    double slope = 0;     ///< b, mm/s
};

/// A synthesized drift test: the air swings about 20 °C, from the middle upwards; the machine was in balance
/// at the beginning.
struct DriftSynthesis {
    std::vector<DriftChannelSynthesis> channels;
    double length = 28'800; ///< s
    double step = 60;       ///< s
    double swing = 2;       ///< amplitude of the temperature, °C
    double period = 43'200; ///< s
    SynthesizedNoise noise;
};

[[nodiscard]] DriftMeasurement synthesizeDrift(const DriftSynthesis &asked);

} // namespace palmer
