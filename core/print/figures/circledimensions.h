// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/figures/circlelabels.h"

namespace palmer {

/// Draws the width of the envelope as a dimension, if the figure has one.
void drawDimension(CircleFrame &frame, CircleLabels &labels);

/// Draws the limit of a width to scale, centred between the circles it limits.
void drawLimitOfG(CircleFrame &frame, CircleLabels &labels);

} // namespace palmer
