// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "language/language.h"
#include "register/machinetrend.h"
#include "report/blocks/report.h"

#include <QByteArray>

namespace palmer {

/// The trend as one line of JSON; values in mm or degrees, `notBefore` a day, null where nothing is said.
[[nodiscard]] QByteArray trendJson(const ListedMachine &machine, const std::string &axis,
                                   const MachineTrend &trend);

/// Its points as rows for programs, with the line and its standard uncertainty where there is one.
[[nodiscard]] QByteArray trendCsv(const ListedMachine &machine, const std::string &axis,
                                  const std::vector<MachineTrend> &trends);

/// To be read: what is said of the line, then its points.
[[nodiscard]] Report composeTrend(const ListedMachine &machine, const std::string &axis,
                                  const MachineTrend &trend, const Language &language);

/// "not before March 2028", "no trend shown", "fewer than 4 tests since the last intervention", …
[[nodiscard]] QString trendStatement(const MachineTrend &trend, const Language &language);

/// The same for a small chart: "not before June 2029 *" where nothing is said beyond.
[[nodiscard]] QString shortTrendStatement(const MachineTrend &trend, const Language &language);

/// How the line was found, in a few sentences.
[[nodiscard]] QString trendMethod(const MachineTrend &trend, const Language &language);

/// "ISO 230-2:1988, feed 500 mm/min": in what a series is another than the first; empty for the first.
[[nodiscard]] QString seriesName(const TrendSeries &series, bool angular, const Language &language);

/// "repair", "collision".
[[nodiscard]] QString interventionName(InterventionKind kind, const Language &language);

/// "March 2028", "mars 2028".
[[nodiscard]] QString monthText(const QDate &date, const Language &language);
/// Where there is little room: "Nov 2026".
[[nodiscard]] QString shortMonthText(const QDate &date, const Language &language);

/// The facts beside a chart: since, tests, slope, level, scatter. Only of a trend with a line.
[[nodiscard]] std::vector<KeyValue> trendFacts(const MachineTrend &trend, const Language &language);

/// The unit values are shown in: µm or arc seconds.
[[nodiscard]] Quantity trendQuantity(const MachineTrend &trend);

} // namespace palmer
