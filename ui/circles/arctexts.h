// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/circular.h"
#include "language/language.h"

#include <QString>
#include <cstddef>
#include <span>

namespace palmer::ui {

/// The points of an arc as columns show them, or the points as such.
enum class PointUnit { deviations, coordinates, lengths };

/// "anticlockwise, XY": the word for the sense of an arc, in the window's language, with its index.
[[nodiscard]] QString senseWord(Sense sense);
[[nodiscard]] QString arcName(const CircularMeasurement &measurement, std::size_t arc);

/// The digits after the point that show every number of an arc as it was entered, up to `most`; of many
/// points a sample is looked at.
[[nodiscard]] int decimalsOf(std::span<const double> values, Quantity quantity, int most);

/// "anticlockwise, point 1: 0.1° · −2.211 µm": what was read at a point.
[[nodiscard]] QString pointText(const CircularMeasurement &measurement, std::size_t arc, std::size_t point,
                                const Language &language);

} // namespace palmer::ui
