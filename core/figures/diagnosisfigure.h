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

/// The sources of the parts that prevail (see prevailingParts): what is traced where nobody chooses.
[[nodiscard]] std::vector<std::size_t> prevailingSources(const DiagnosedTest &test);

/// The measured paths about the fitted centre, as deviations from the fitted radius, and over them the path
/// that the chosen sources make. `size` is that of the drawing without its key, mm; `synthetic` the lines of
/// the legend that say what is traced, `columns` those of the legend (1, 2 or 3).
struct DiagnosisFigureOptions {
    QSizeF size{112, 97};
    QStringList synthetic;
    int columns = 3;
};
[[nodiscard]] CircleFigure diagnosisFigure(const DiagnosedTest &test, std::span<const std::size_t> chosen,
                                           const Language &language, const DiagnosisFigureOptions &options);

/// The same to stand alone: of the prevailing sources, each named in the legend.
[[nodiscard]] CircleFigure diagnosisFigure(const DiagnosedTest &test, const Language &language);

/// What no source explains over the angle (0 … 360°, marked at the axes), µm: a line each sense, in pieces
/// where it passes 0°. `mostPoints`: each line keeps first, least, greatest and last of so many parts; 0: all
/// points.
[[nodiscard]] LineFigure residualFigure(const DiagnosedTest &test, const Language &language,
                                        std::size_t mostPoints);

/// Amplitudes of what no source explains over the waves a turn, µm, a line each arc; the axis reaches as far
/// as something stands out. No lines where the points of an arc are too few.
/// `mostPoints`: of each line what the axis shows, thinned as above; 0: all.
[[nodiscard]] LineFigure spectrumFigure(const DiagnosedTest &test, const Language &language,
                                        std::size_t mostPoints);

/// Circles of one plane at several feeds over one another (figures B.6 and B.7), each about its own fitted
/// centre as deviation from the nominal radius: clockwise paths are the thinner ones. From slow to fast.
[[nodiscard]] std::vector<PathProfile> profilesAtFeeds(std::span<const DiagnosedTest> tests);
[[nodiscard]] CircleFigure feedsFigure(std::span<const DiagnosedTest> tests,
                                       std::span<const PathProfile> profiles, const Language &language,
                                       const CircleFigureOptions &options);

/// A source over the feed (mm/min), as the circle of each feed tells it by itself, in the unit of the source:
/// its values, and as lines of their own the ends of value ± 2 u. Feeds that do not tell it are left out.
/// What only several feeds tell, a lag, shows in what each of them takes it for: the radius, the scales.
[[nodiscard]] LineFigure overFeedFigure(std::span<const DiagnosedTest> tests, InfluenceId source,
                                        PlaneAxis axis, const Language &language);

} // namespace palmer
