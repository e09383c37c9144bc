// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "figures/figure.h"
#include "kernel/evaluation/testevaluation.h"
#include "kernel/measurement/test.h"
#include "language/language.h"

#include <optional>

namespace palmer {

// Figures of a test over axes; circles have theirs in circlefigure.h and diagnosisfigure.h.

/// Main figure of a kind of test: deviations over the targets, both senses of a circle, drift over time.
/// `evaluation` is the evaluation of `test`.
[[nodiscard]] Figure figureOfTest(const Test &test, const TestEvaluation &evaluation,
                                  const Language &language);

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

/// Curve of a drift test: deviations at rest (µm; rotary: arc seconds) over time (s; from 10 minutes min,
/// from 10 hours h), with E_VE = max − min as a dimension between the two readings that define it: of the
/// main channel over the whole record, or as `taken` by a test. `test` holds a DriftMeasurement and
/// `evaluation` is its evaluation; otherwise throws std::bad_variant_access. Without readings an empty
/// figure.
[[nodiscard]] CurveFigure driftFigure(const Test &test, const TestEvaluation &evaluation,
                                      const Language &language,
                                      const std::optional<TakenVariation> &taken = {});

/// Temperatures of the sensors that have a series, over time (h, from the first of all values; °C). Several
/// sensors are numbered in the order of the test. No lines if no sensor has two values. Long series keep the
/// first, least, greatest and last value of each of 500 parts of the time.
[[nodiscard]] LineFigure temperatureFigure(const std::vector<Sensor> &sensors, const Language &language);

/// Means of each direction as measured, overlaid by the prediction after compensation. `before` and `after`
/// evaluate `test` and the same test with the compensation applied; both hold PositioningResults. Targets
/// without a mean are left out.
[[nodiscard]] LineFigure compensationFigure(const Test &test, const TestEvaluation &before,
                                            const TestEvaluation &after, const Language &language);

/// Contributions to the uncertainty of a test as bars, the largest first: U_i (k = 2) in µm (rotary: arc
/// seconds), and its share in the sum of squares. Unknown contributions come first and have no bar. No bars
/// if the method of the test needs no budget, nor for drift tests. `evaluation` is the evaluation of `test`.
[[nodiscard]] BarFigure budgetFigure(const Test &test, const TestEvaluation &evaluation,
                                     const Language &language);

/// Decimals of the U of a contribution, in the displayed unit.
inline constexpr int contributionDecimals = 2;

/// Name of a contribution, capitalised to begin a line.
[[nodiscard]] QString contributionName(const Contribution &contribution, const Language &language);

/// Percentage without the % sign: "54"; "< 1" if below 0.5 %.
[[nodiscard]] QString shareText(double share, const Language &language);

/// Simulated distribution of a parameter (µm; rotary: arc seconds): histogram, shortest interval that
/// contains 95.45 % of the values, their mean, and the value evaluated from the readings. The axis covers the
/// counted values and the evaluated one. Null if the parameter was not simulated. `resolution`: the finest of
/// the instruments (mm, rotary: degrees); numbers are printed as in the tables.
[[nodiscard]] std::optional<HistogramFigure>
histogramFigure(const Test &test, const TestEvaluation &evaluation, const Parameter &parameter,
                const Language &language, std::optional<double> resolution = {});

} // namespace palmer
