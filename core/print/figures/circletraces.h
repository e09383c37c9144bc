// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/figures/circleframe.h"

namespace palmer {

/// Draws the measured paths, further arcs below the first ones, and the synthetic path above them.
void drawTraces(CircleFrame &frame);

/// Draws the marks of starting points, of the points that determine the result, and of the centre.
void drawMarks(CircleFrame &frame);

/// Draws the sample of a legend entry.
void drawSample(CircleFrame &frame, const QRectF &box, const CircleLegendEntry &entry);

} // namespace palmer
