// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "language/language.h"

namespace palmer {

/// Round steps: 1-2-5 for values, 1-2-2.5-5 for lengths along an axis, for angles in degrees
/// 1-2-5-10-15-30-45-60-90-180 and 360 · 1-2-5.
enum class TickSteps { values, lengths, angles };

/// Returns the smallest round step that divides `span` into at most `most` parts. span > 0, most ≥ 1.
[[nodiscard]] double roundStep(double span, double most, TickSteps steps);

/// Sets range, step and ticks of an axis; from < to. Labels have the decimals that the step needs, and no −0.
void setRange(FigureAxis &axis, double from, double to, double mostParts, TickSteps steps,
              const Language &language);

/// Returns the end of a scale from 0 that contains `size`: 1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8 or 10 times a
/// power of ten; 1 if size ≤ 0.
[[nodiscard]] double scaleEnd(double size);

} // namespace palmer
