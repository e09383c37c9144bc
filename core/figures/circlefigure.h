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

/// How deviations become distances from the centre of a figure.
struct CircleScale {
    double plotRadius = 0; ///< of the nominal circle, mm
    double magnification = 1;
};

/// The largest magnification 1, 2 or 5·10^k, at most 100 000, with which the deviations from … to (µm) and
/// the nominal circle lie between 0.15 of the radius of the figure (mm) and that radius. The nominal circle
/// stands at 34/49 of it; where paths lie so much on one side that another place of it allows five times the
/// magnification or more, it gives way as far as needed. figureRadius > 0.
[[nodiscard]] CircleScale circleScale(const Interval &deviations, double figureRadius);

struct CircleFigureOptions {
    CircleOf of = CircleOf::both; ///< both: one figure of all senses that were measured
    CircleSubject subject = CircleSubject::circularDeviation;
    QSizeF size{112, 105};    ///< of the drawing without its key, mm; decides the magnification
    bool repetitions = false; ///< further arcs of a sense
    bool contacts = false;    ///< the points that rule the result
    bool limits = true;       ///< limit of G or G(b) as a width, limits of F as circles
    bool fillFrame =
        false; ///< a short arc is drawn as large as it fits; else about the middle of the drawing
    double pointStep = 0.1; ///< mm of the drawing: of points closer together the extremes alone are kept

    bool operator==(const CircleFigureOptions &) const = default;
};

/// The figure of a circular test (ISO 230-4): paths with their deviations magnified about the nominal circle.
///
/// Centre: of G(b) for both senses, of the path's G for one (minimum zone or least squares circle, as the
/// test chooses); for radial deviations that of F: the least squares circle of the path, or the set-up. With
/// least squares each path has its own, so radial deviations of both senses show the path measured first.
/// Where that circle does not exist the figure is drawn about the programmed centre and has no envelope.
/// Deviation drawn: distance from the centre − nominal radius, of F with the correction to 20 °C applied
/// here.
///
/// Magnification: see circleScale. Limits of F count with the paths up to four times their deviation; larger
/// ones are not drawn, nor is a limit of G wider than the figure's radius.
///
/// Points: see `decimated`. `test` holds a CircularMeasurement and
/// `evaluation` is its evaluation; else std::bad_variant_access. A test without points gives axes and nominal
/// circle.
[[nodiscard]] CircleFigure circleFigure(const Test &test, const TestEvaluation &evaluation,
                                        const Language &language, const CircleFigureOptions &options = {});

/// Paths alone, about the centre their profiles are made about, on the scale that circleFigure() would take:
/// axes, rings and traces, without circle, marks, arrows, title and legend.
[[nodiscard]] CircleFigure pathsFigure(std::span<const PathProfile> profiles, const Plane &plane,
                                       const Language &language, const CircleFigureOptions &options);

/// Puts the legend below a figure, in 1, 2 or 3 columns, and makes room for it on paper.
void setLegend(CircleFigure &figure, std::vector<CircleLegendEntry> entries, int columns);

/// The figures of the standard one by one: G(b), G of each path, F of each path, as far as there are values.
[[nodiscard]] std::vector<CircleFigureOptions> separateCircleFigures(const Test &test,
                                                                     const TestEvaluation &evaluation);

/// Paper a figure needs with its key, mm.
[[nodiscard]] QSizeF printedSize(const CircleFigure &figure);

/// The points behind a figure, made once for many views of it: 10⁶ points take about 0.1 s.
[[nodiscard]] std::vector<PathProfile> pathProfiles(const Test &test, const TestEvaluation &evaluation,
                                                    const CircleFigureOptions &options = {});

/// Other points in the place of those of the evaluated paths (one list a path of the results, one point a
/// point, mm about the programmed centre), about the centre of the figure: to be drawn with its profiles.
[[nodiscard]] std::vector<PathProfile> profilesOfPaths(const Test &test, const TestEvaluation &evaluation,
                                                       const CircleFigureOptions &options,
                                                       std::span<const Points> paths);

/// The same about any centre, as deviations from any radius (mm).
[[nodiscard]] std::vector<PathProfile> profilesAbout(const CircularMeasurement &measurement,
                                                     const CircularResults &results,
                                                     std::span<const Points> paths, Point centre,
                                                     double radius);

/// A whole arc with what of it is not evaluated, about the least squares centre of the paths of its sense
/// (the programmed centre where there is none), as the unwrapped curve over the angle shows it. `arc` is an
/// index of the measurement.
[[nodiscard]] PathProfile wholeArc(const Test &test, const TestEvaluation &evaluation, std::size_t arc);

/// circleFigure() with profiles made before with the same test, evaluation and options (other than size and
/// limits).
[[nodiscard]] CircleFigure circleFigure(const Test &test, const TestEvaluation &evaluation,
                                        std::span<const PathProfile> profiles, const Language &language,
                                        const CircleFigureOptions &options);

/// The same figure seen otherwise, as zooming and panning in a window need it: points, rings and scale bar of
/// what is in view. `figure` was made from `profiles`, in any view; that of the picture before is the
/// quickest.
[[nodiscard]] CircleFigure withView(CircleFigure figure, std::span<const PathProfile> profiles,
                                    const CircleView &view, const Language &language);

} // namespace palmer
