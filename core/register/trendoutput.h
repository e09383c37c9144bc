// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "language/language.h"
#include "register/machinetrend.h"
#include "report/blocks/report.h"

#include <QByteArray>

namespace palmer {

/// Returns the trend as one line of JSON; values in mm or degrees, `notBefore` a date, null for no statement.
[[nodiscard]] QByteArray trendJson(const ListedMachine &machine, const std::string &axis,
                                   const MachineTrend &trend);

/// Returns its points as rows for programs, with the line and its standard uncertainty if there is one.
[[nodiscard]] QByteArray trendCsv(const ListedMachine &machine, const std::string &axis,
                                  const std::vector<MachineTrend> &trends);

/// Returns a readable report: statements about the line, then its points.
[[nodiscard]] Report composeTrend(const ListedMachine &machine, const std::string &axis,
                                  const MachineTrend &trend, const Language &language);

/// Returns "not before March 2028", "no trend shown", "fewer than 4 tests since the last intervention", …
[[nodiscard]] QString trendStatement(const MachineTrend &trend, const Language &language);

/// The same for a small chart: "not before June 2029 *" if there is no statement beyond.
[[nodiscard]] QString shortTrendStatement(const MachineTrend &trend, const Language &language);

/// Returns how the line was computed, in a few sentences; `withFormula`: with the matrix.
[[nodiscard]] QString trendMethod(const MachineTrend &trend, const Language &language,
                                  bool withFormula = true);

/// Returns how a series differs from the first: "ISO 230-2:1988, feed 500 mm/min"; empty for the first.
[[nodiscard]] QString seriesName(const TrendSeries &series, bool angular, const Language &language);

/// Names all but the first series: "Another series: ISO 230-2:1988 · feed 500 mm/min"; empty without them.
/// Returns what the tests of a series have in common: edition, feed, travel, …
[[nodiscard]] QString seriesText(TrendSeries series, bool angular, const Language &language);

/// Returns the edition of the first series; empty without tests.
[[nodiscard]] QString editionOf(const MachineTrend &trend);

[[nodiscard]] QString otherSeries(const MachineTrend &trend, const Language &language);

/// Returns "repair", "collision".
[[nodiscard]] QString interventionName(InterventionKind kind, const Language &language);

/// Returns "March 2028", "mars 2028".
[[nodiscard]] QString monthText(const QDate &date, const Language &language);
/// For narrow places: "Nov 2026".
[[nodiscard]] QString shortMonthText(const QDate &date, const Language &language);

/// Returns since, tests, slope, level and scatter. Precondition: the trend has a line.
[[nodiscard]] std::vector<KeyValue> trendFacts(const MachineTrend &trend, const Language &language);

/// Returns the unit of the values for a heading: "µm", "arc second", because a sign alone is unclear there.
[[nodiscard]] QString unitInWords(const MachineTrend &trend, const Language &language);

/// Returns the quantity of the values: shown in µm or arc seconds.
[[nodiscard]] Quantity trendQuantity(const MachineTrend &trend);

} // namespace palmer
