// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/circular.h"
#include "language/language.h"

#include <QString>
#include <cstddef>
#include <span>

namespace palmer::ui {

/// Units of the points of an arc: as columns of readings, or as coordinates.
enum class PointUnit { deviations, coordinates, lengths };

/// "anticlockwise, XY": the displayed sense of an arc, with its index.
[[nodiscard]] QString senseWord(Sense sense);
[[nodiscard]] QString arcName(const CircularMeasurement &measurement, std::size_t arc);

/// Decimals that show every number of an arc as entered, at most `most`; of many points only a sample counts.
[[nodiscard]] int decimalsOf(std::span<const double> values, Quantity quantity, int most);

/// "anticlockwise, point 1: 0.1° · −2.211 µm": the reading at a point.
[[nodiscard]] QString pointText(const CircularMeasurement &measurement, std::size_t arc, std::size_t point,
                                const Language &language);

} // namespace palmer::ui
