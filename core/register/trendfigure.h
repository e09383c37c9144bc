// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "language/language.h"
#include "register/machinetrend.h"

#include <QDate>
#include <QString>

namespace palmer {

/// The years shown in a panel: from the first test to today, or to the end of the line, with a margin.
struct TrendSpan {
    double from = 0; ///< calendar years
    double to = 1;
};
[[nodiscard]] TrendSpan trendSpan(const std::vector<MachineTrend> &trends, const QDate &today);

/// Returns the panel of a trend. The band shows the one-sided bounds, level ± t(0.95)·u of the line: "not
/// before" is on its edge.
[[nodiscard]] TrendPanel trendPanel(const MachineTrend &trend, const TrendSpan &span, const QDate &today,
                                    const Language &language, int mostTicks);

/// The same for a row of several panels.
[[nodiscard]] TrendPanel smallTrendPanel(const MachineTrend &trend, const TrendSpan &span, const QDate &today,
                                         const Language &language);

/// Returns the figure of a single trend, with names and legend.
[[nodiscard]] TrendFigure trendFigure(const QString &title, const MachineTrend &trend, const QDate &today,
                                      const Language &language);

/// Returns the legend of the signs that occur in these trends.
[[nodiscard]] std::vector<TrendLegendEntry> trendLegend(const Language &language,
                                                        const std::vector<MachineTrend> &trends);

/// Converts a date to a calendar year: 2024.29.
[[nodiscard]] double calendarYear(const QDate &date);

} // namespace palmer
