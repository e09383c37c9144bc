// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/diagnosedtest.h"
#include "figures/circlefigure.h"
#include "language/language.h"

#include <QStringList>
#include <span>
#include <vector>

namespace palmer {

/// Sources of the prevailing parts (see prevailingParts): traced by default.
[[nodiscard]] std::vector<std::size_t> prevailingSources(const DiagnosedTest &test);

/// Figure of the measured paths about the fitted centre, as deviations from the fitted radius, overlaid by
/// the path that the chosen sources produce. `size`: drawing without its legend, mm; `synthetic`: legend
/// lines for the traced sources; `columns`: columns of the legend (1, 2 or 3).
struct DiagnosisFigureOptions {
    QSizeF size{112, 97};
    QStringList synthetic;
    int columns = 3;
};
[[nodiscard]] CircleFigure diagnosisFigure(const DiagnosedTest &test, std::span<const std::size_t> chosen,
                                           const Language &language, const DiagnosisFigureOptions &options);

/// The same with the prevailing sources, each named in the legend.
[[nodiscard]] CircleFigure diagnosisFigure(const DiagnosedTest &test, const Language &language);

/// Residual that no source explains over the angle (0 … 360°, axes marked), µm: one line per sense, split
/// where it passes 0°. `mostPoints`: number of parts of each line whose first, least, greatest and last point
/// are kept; 0: all points.
[[nodiscard]] LineFigure residualFigure(const DiagnosedTest &test, const Language &language,
                                        std::size_t mostPoints);

/// Amplitudes of the residual over the waves per turn, µm, one line per arc; the axis ends at the last wave
/// that is prominent. No lines for arcs with too few points. `mostPoints`: the visible part of each line is
/// thinned as above; 0: all points.
[[nodiscard]] LineFigure spectrumFigure(const DiagnosedTest &test, const Language &language,
                                        std::size_t mostPoints);

/// Circles of one plane at several feeds in one figure (figures B.6 and B.7), by increasing feed, each about
/// its own fitted centre as deviation from the nominal radius. Clockwise paths are thinner.
[[nodiscard]] std::vector<PathProfile> profilesAtFeeds(std::span<const DiagnosedTest> tests);
[[nodiscard]] CircleFigure feedsFigure(std::span<const DiagnosedTest> tests,
                                       std::span<const PathProfile> profiles, const Language &language,
                                       const CircleFigureOptions &options);

/// A source over the feed (mm/min), as the circle at each feed shows it, in the unit of the source: its
/// values, and the ends of their 95 % intervals as separate lines. Feeds that do not determine it are left
/// out. A lag, which only several feeds determine, is shown by what it looks like in each of them: radius or
/// scale mismatch.
[[nodiscard]] LineFigure overFeedFigure(std::span<const DiagnosedTest> tests, InfluenceId source,
                                        PlaneAxis axis, const Language &language);

} // namespace palmer
