// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/words/text.h"

#include <span>

namespace palmer {

/// An axis of the plane of a circle, or neither: what belongs to the plane.
enum class PlaneAxis { none, first, second };

/// A point of a circular path, as far as a deviation depends on it. θ is counted from the first axis towards
/// the second.
struct PathPosition {
    double cosine = 1; ///< of θ
    double sine = 0;
    double sense = 1;  ///< +1 counterclockwise, −1 clockwise
    double radius = 0; ///< R, mm
    double feed = 0;   ///< F, mm/s
    double turns = 0;  ///< turns from the middle of the test, through all arcs in order
};

/// What deviates a circle (ISO 230-4 Annex B): row of `influences()`.
enum class InfluenceId {
    centre,
    radius,
    scaleMismatch,
    squareness,
    servoMismatch,
    backlash,
    lateralPlay,
    straightness,
    reversalSpike,
    cyclic,
    commonLag,
    lagMismatch,
    radiusDrift,
};

/// One influence: its parameters, and the radial deviation that one unit of each makes. The base units of
/// parameters are mm, rad (mm/mm) and s, and products of them.
struct Influence {
    /// Radial deviation (mm, positive outwards) of one unit of the parameter. `shape`: pitch (mm) of cyclic
    /// errors, width (degrees) of reversal spikes; else not looked at.
    using Column = double (*)(const PathPosition &, PlaneAxis, double shape);

    InfluenceId id = InfluenceId::centre;
    const char *word = nullptr; ///< in files
    Text name;                  ///< "%1" stands for the axis or the plane
    bool ofAxis = false;        ///< one of each axis; else one of the plane
    const char *unit = nullptr; ///< the parameter is shown in
    double unitsPerBase = 0;
    Column column = nullptr;
    Column second = nullptr; ///< of a further parameter that shares the source: see the row
};

[[nodiscard]] std::span<const Influence> influences();
[[nodiscard]] const Influence &influence(InfluenceId id);
/// By its word; null for another.
[[nodiscard]] const Influence *findInfluence(const char *word);

/// Angle travelled since the axis last reversed, degrees, 0 … 180: the first axis reverses at 0° and 180°,
/// the second at 90° and 270°.
[[nodiscard]] double sinceReversal(const PathPosition &position, PlaneAxis axis);

/// A parameter in the unit of its row. A common lag is shown as the time τ = √q (its square q is what is
/// linear), with the sign of q.
[[nodiscard]] double shownParameter(InfluenceId id, double value);
/// The inverse.
[[nodiscard]] double baseParameter(InfluenceId id, double shown);

} // namespace palmer
