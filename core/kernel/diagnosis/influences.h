// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/words/text.h"

#include <span>

namespace palmer {

/// An axis of the plane of a circle; none for the plane itself.
enum class PlaneAxis { none, first, second };

/// The data of a point of a circular path on which a deviation depends. θ is counted from the first axis
/// towards the second.
struct PathPosition {
    double cosine = 1; ///< of θ
    double sine = 0;
    double sense = 1;  ///< +1 counterclockwise, −1 clockwise
    double radius = 0; ///< R, mm
    double feed = 0;   ///< F, mm/s
    double turns = 0;  ///< turns from the middle of the test, over all arcs in order
};

/// Influences on a circle (ISO 230-4 Annex B): row of `influences()`.
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

/// One influence: its parameters, and the radial deviation per unit of each. The base units of parameters are
/// mm, rad (mm/mm) and s, and products of them.
struct Influence {
    /// Radial deviation (mm, positive outwards) per unit of the parameter. `shape`: pitch (mm) of cyclic
    /// errors, width (degrees) of reversal spikes; otherwise unused.
    using Column = double (*)(const PathPosition &, PlaneAxis, double shape);

    InfluenceId id = InfluenceId::centre;
    const char *word = nullptr; ///< key in files
    Text name;                  ///< "%1" is replaced by the axis or the plane
    bool ofAxis = false;        ///< one per axis; otherwise one per plane
    const char *unit = nullptr; ///< in which the parameter is shown
    double unitsPerBase = 0;
    Column column = nullptr;
    Column second = nullptr; ///< column of a further parameter of the same source: see the row
};

[[nodiscard]] std::span<const Influence> influences();
[[nodiscard]] const Influence &influence(InfluenceId id);
/// Returns the influence with this word, or null.
[[nodiscard]] const Influence *findInfluence(const char *word);

/// Returns the angle travelled since the last reversal of the axis, degrees, 0 … 180: the first axis reverses
/// at 0° and 180°, the second at 90° and 270°.
[[nodiscard]] double sinceReversal(const PathPosition &position, PlaneAxis axis);

/// Converts a parameter to the unit of its row. A common lag is shown as the time τ = √q (the model is linear
/// in its square q), with the sign of q.
[[nodiscard]] double shownParameter(InfluenceId id, double value);
/// Inverse of shownParameter().
[[nodiscard]] double baseParameter(InfluenceId id, double shown);

} // namespace palmer
