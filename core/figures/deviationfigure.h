// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "kernel/evaluation/testevaluation.h"
#include "kernel/measurement/test.h"
#include "language/language.h"

namespace palmer {

struct DeviationFigureOptions {
    bool readingMarks =
        true;               ///< single readings; omitted if a direction has a single run: they are its curve
    bool dimensions = true; ///< A, R, E, M, B
};

/// Figure of a positioning test as the editions print it: deviations (µm; rotary: arc seconds) over target
/// positions (mm; degrees). Shows the mean of each direction with its limits x̄ ± c·s (c of the edition), the
/// mean of both directions, readings, and A, R, E, M, B as dimensions if the edition has them and they have a
/// value; a test from one direction shows A, R, E of that direction. Tests over the whole travel of a long
/// axis (above 2 000 mm, 360°) show E, M, B and no limits. A target without a statistic breaks the curve. R
/// is in the gutter if the last target rules it, otherwise next to its target, like B. `test` holds a
/// PositioningMeasurement and `evaluation` is its evaluation; otherwise throws std::bad_variant_access.
[[nodiscard]] CurveFigure deviationFigure(const Test &test, const TestEvaluation &evaluation,
                                          const Language &language,
                                          const DeviationFigureOptions &options = {});

/// The same figure with other ranges, for zooming and panning in a window. from < to.
[[nodiscard]] CurveFigure withRanges(CurveFigure figure, const Interval &x, const Interval &y,
                                     const Language &language);

} // namespace palmer
