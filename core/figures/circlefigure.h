// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "figures/pathprofile.h"
#include "kernel/evaluation/testevaluation.h"
#include "kernel/measurement/test.h"
#include "language/language.h"

#include <QSizeF>
#include <span>
#include <vector>

namespace palmer {

/// Maps deviations to distances from the centre of a figure.
struct CircleScale {
    double plotRadius = 0; ///< radius of the nominal circle, mm
    double magnification = 1;
};

/// Largest magnification 1, 2 or 5·10^k, at most 100 000, with which the deviations from … to (µm) and the
/// nominal circle lie between 0.15 and 1 times the radius of the figure (mm). The nominal circle lies at
/// 34/49 of it; if the paths are so one-sided that moving the circle allows five times the magnification or
/// more, it moves as far as needed. figureRadius > 0. `most`: that of another figure it is compared with.
[[nodiscard]] CircleScale circleScale(const Interval &deviations, double figureRadius, double most = 1e5);

struct CircleFigureOptions {
    CircleOf of = CircleOf::both; ///< both: one figure with all measured senses
    CircleSubject subject = CircleSubject::circularDeviation;
    QSizeF size{112, 105};          ///< drawing without its legend, mm; decides the magnification
    double mostMagnification = 1e5; ///< so that figures can be compared
    bool repetitions = false;       ///< also draw further arcs of a sense
    bool contacts = false;          ///< mark the points that determine the result
    bool limits = true;             ///< draw the limit of G or G(b) as a width, limits of F as circles
    bool fillFrame =
        false; ///< true: a short arc fills the drawing; false: the circle is centred in the drawing
    double pointStep = 0.1; ///< mm on the drawing; of points closer together only the extremes are kept

    bool operator==(const CircleFigureOptions &) const = default;
};

/// Figure of a circular test (ISO 230-4): paths with their deviations magnified about the nominal circle.
///
/// Centre: of G(b) for both senses, of the path's G for one (minimum zone or least squares circle, as the
/// test chooses); for radial deviations that of F: the least squares circle of the path, or the set-up. With
/// least squares each path has its own centre, so radial deviations of both senses show the path measured
/// first. If that circle does not exist, the figure is drawn about the programmed centre and has no envelope.
/// Deviation drawn: distance from the centre − nominal radius; for F with the correction to 20 °C.
///
/// Magnification: see circleScale. Limits of F affect it up to four times the deviation of the paths; larger
/// ones are not drawn, nor is a limit of G wider than the figure radius.
///
/// Points: see `decimated`. `test` holds a CircularMeasurement and `evaluation` is its evaluation; otherwise
/// throws std::bad_variant_access. A test without points gives axes and nominal circle.
[[nodiscard]] CircleFigure circleFigure(const Test &test, const TestEvaluation &evaluation,
                                        const Language &language, const CircleFigureOptions &options = {});

/// Paths only, about the centre of their profiles, on the scale of circleFigure(): axes, rings and traces,
/// without circle, marks, arrows, title and legend.
[[nodiscard]] CircleFigure pathsFigure(std::span<const PathProfile> profiles, const Plane &plane,
                                       const Language &language, const CircleFigureOptions &options);

/// Puts the legend below a figure, in 1, 2 or 3 columns, and reserves its height on paper.
void setLegend(CircleFigure &figure, std::vector<CircleLegendEntry> entries, int columns);

/// Options for the separate figures of the standard: G(b), G of each path, F of each path, if they have
/// values.
[[nodiscard]] std::vector<CircleFigureOptions> separateCircleFigures(const Test &test,
                                                                     const TestEvaluation &evaluation);

/// Printed size of a figure with its legend, mm.
[[nodiscard]] QSizeF printedSize(const CircleFigure &figure);

/// Points of a figure, computed once for many views of it: 10⁶ points take about 0.1 s.
[[nodiscard]] std::vector<PathProfile> pathProfiles(const Test &test, const TestEvaluation &evaluation,
                                                    const CircleFigureOptions &options = {});

/// Profiles of other points in place of those of the evaluated paths (one list per path of the results, one
/// point per point, mm about the programmed centre), about the centre of the figure.
[[nodiscard]] std::vector<PathProfile> profilesOfPaths(const Test &test, const TestEvaluation &evaluation,
                                                       const CircleFigureOptions &options,
                                                       std::span<const Points> paths);

/// The same about any centre, as deviations from any radius (mm).
[[nodiscard]] std::vector<PathProfile> profilesAbout(const CircularMeasurement &measurement,
                                                     const CircularResults &results,
                                                     std::span<const Points> paths, Point centre,
                                                     double radius);

/// A whole arc including its unevaluated parts, about the least squares centre of the paths of its sense (the
/// programmed centre if there is none), for the unwrapped curve over the angle. `arc` is an index of the
/// measurement.
[[nodiscard]] PathProfile wholeArc(const Test &test, const TestEvaluation &evaluation, std::size_t arc);

/// circleFigure() from profiles made earlier with the same test, evaluation and options (except size and
/// limits).
[[nodiscard]] CircleFigure circleFigure(const Test &test, const TestEvaluation &evaluation,
                                        std::span<const PathProfile> profiles, const Language &language,
                                        const CircleFigureOptions &options);

/// The same figure in another view, for zooming and panning in a window: points, rings and scale bar of the
/// visible part. `figure` was made from `profiles`, in any view; passing the previous view's figure is
/// fastest.
[[nodiscard]] CircleFigure withView(CircleFigure figure, std::span<const PathProfile> profiles,
                                    const CircleView &view, const Language &language);

} // namespace palmer
