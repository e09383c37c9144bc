// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/parts/thermalparts.h"

#include "figures/curvefield.h"
#include "figures/ticks.h"
#include "kernel/measurement/testfacts.h"
#include "report/parts/parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

namespace palmer {

namespace {

constexpr double minute = 60;
constexpr double hour = 3600;
constexpr double longRecord = 2 * hour; ///< from which on times are in hours
constexpr double mostTimeTicks = 8;
constexpr double mostValueTicks = 5;
constexpr Text variationTitle = REPORT_TEXT("report", "Variation over the duration");
constexpr std::array channelRoles{LineRole::machine, LineRole::instrument, LineRole::air,
                                  LineRole::measuredDown};

Quantity quantityAt(std::size_t place, const std::vector<ThermalChannel> &channels) {
    return place < channels.size() ? deviationQuantity(channels[place].channel) : Quantity::deviation;
}

/// Decimals that show two digits of a half width.
int decimalsFor(double half) {
    constexpr int most = 4;
    return half > 0 ? std::clamp(1 - static_cast<int>(std::floor(std::log10(half))), 0, most) : 1;
}

struct TimeScale {
    double seconds = 1;
    QString unit;
};
TimeScale timeScale(const DriftMeasurement &drift) {
    const double lasts = drift.times.empty() ? 0 : drift.times.back() - drift.times.front();
    return lasts >= longRecord ? TimeScale{hour, QStringLiteral("h")}
                               : TimeScale{minute, QStringLiteral("min")};
}

/// Ranges and ticks of both axes from the lines.
LineFigure finished(LineFigure figure, const Language &language, bool fromZero = false) {
    Bounds x;
    Bounds y;
    for (const FigureLine &line : figure.lines) {
        for (const QPointF &point : line.points) {
            x.include(point.x());
            y.include(point.y());
        }
    }
    const Bounds values = y.widened(valueMargin, 0.2);
    if (!(x.lowest < x.highest))
        x = {0, 1};
    setRange(figure.x, x.lowest, x.highest, mostTimeTicks, TickSteps::values, language);
    setRange(figure.y, fromZero ? 0 : values.lowest, values.highest, mostValueTicks, TickSteps::values,
             language);
    return figure;
}

LineFigure overTime(const DriftMeasurement &drift, const Text &title, const Text &quantity,
                    const QString &unit, const Language &language) {
    LineFigure figure;
    figure.title = language.text(title);
    figure.x.quantity = language.text(REPORT_TEXT("report", "Time"));
    figure.x.unit = timeScale(drift).unit;
    figure.y.quantity = language.text(quantity);
    figure.y.unit = unit;
    return figure;
}

FigureBand bandOf(const DriftMeasurement &drift, const Variation &worst) {
    const double perSecond = 1 / timeScale(drift).seconds;
    return {worst.from * perSecond, worst.to * perSecond, {}};
}

std::vector<QPointF> pointsOf(const std::vector<double> &times,
                              const std::vector<std::optional<double>> &values, double perSecond,
                              double scale) {
    std::vector<QPointF> points;
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (values[i])
            points.emplace_back(times[i] * perSecond, *values[i] * scale);
    }
    return points;
}

/// "42 … 48", with an open end as "> 42" or "< 48".
QString intervalText(const Range &range, double scale, const Language &language) {
    const auto number = [&](double value) {
        const double half =
            range.low && range.high ? (*range.high - *range.low) / 2 * scale : value * scale / 10;
        return language.number(value * scale, Quantity::number, decimalsFor(half));
    };
    if (range.low && range.high)
        return number(*range.low) + QStringLiteral(" … ") + number(*range.high);
    if (range.low)
        return QStringLiteral(">\u00A0") + number(*range.low);
    return range.high ? QStringLiteral("<\u00A0") + number(*range.high) : QString();
}

QString valueText(double value, const Range &range, double scale, const Language &language) {
    const double half =
        range.low && range.high ? (*range.high - *range.low) / 2 * scale : std::abs(value * scale) / 10;
    return language.number(value * scale, Quantity::number, decimalsFor(half));
}

QString durationText(std::optional<double> seconds, const Language &language) {
    if (!seconds)
        return {};
    const bool isLong = *seconds >= longRecord;
    constexpr double hundredths = 100;
    const double rounded = std::round(*seconds / (isLong ? hour : minute) * hundredths) / hundredths;
    return language.number(rounded, Quantity::number, -1) +
           (isLong ? QStringLiteral("\u00A0h") : QStringLiteral("\u00A0min"));
}

QString caseName(const DriftCase &one, const Language &language) {
    const std::string lasts = durationText(one.lasts, language).toStdString();
    switch (one.kind) {
    case DriftCase::asTested:
        return lasts.empty()
                   ? language.text(REPORT_TEXT("report", "as recorded, duration of the test not stated"))
                   : language.sentence({REPORT_TEXT("report", "test of %1"), {lasts}, {}});
    case DriftCase::halved:
        return language.sentence({REPORT_TEXT("report", "half the duration, %1"), {lasts}, {}});
    case DriftCase::none:
        return language.text(REPORT_TEXT("report", "without drift"));
    case DriftCase::wholeRecord:
        return language.sentence({REPORT_TEXT("report", "whole record, %1"), {lasts}, {}});
    case DriftCase::held:
        break;
    }
    return language.sentence({REPORT_TEXT("report", "θ held to ± %1, at worst"),
                              {Number{one.hold, Quantity::temperature, 0}},
                              {}});
}

/// "≥" before a lower bound, "≤" before an upper one.
QString boundSign(const DriftCase &one) {
    if (one.isLowerBound)
        return QStringLiteral("≥\u00A0");
    return one.kind == DriftCase::held ? QStringLiteral("≤\u00A0") : QString();
}

/// The table of responses for half a page: the intervals below their values.
Table inHalf(Table table) {
    enum Place : std::size_t { channel, temperature, k, kInterval, tau, tauInterval, slope, residual };
    const auto &all = table.columns;
    Table half;
    half.columns = {flexibleColumn(all[channel].title, 16), all[k], all[tau], all[slope], all[residual]};
    half.columns[1].width = half.columns[2].width = 23; // mm, of an interval
    half.columns[3].width = half.columns[4].width = 13;
    for (std::vector<Cell> &row : table.rows) {
        const auto put = [&row](std::size_t cell, std::size_t note) {
            if (const QString text = row[note].text.plain(); !text.isEmpty())
                row[cell].extras.edit().notes.push_back({text});
        };
        if (const bool isRefused = row[temperature].extras->columns > 1; isRefused) {
            row[temperature].extras.edit().columns = half.columns.size() - 1;
            half.rows.push_back({std::move(row[channel]), std::move(row[temperature])});
            half.rows.back().resize(half.columns.size(), blankCell());
            continue;
        }
        put(channel, temperature);
        put(k, kInterval);
        put(tau, tauInterval);
        half.rows.push_back({row[channel], row[k], row[tau], row[slope], row[residual]});
    }
    return half;
}

} // namespace

Text noResponseText(ResponseState state) {
    return inOrder(state, {Text(), REPORT_TEXT("report", "steps of time differ: no response"),
                           REPORT_TEXT("report", "gap in the temperature: no response"),
                           REPORT_TEXT("report", "too few values: no response"),
                           REPORT_TEXT("report", "no response proven"),
                           REPORT_TEXT("report", "not to be told from a straight drift"),
                           REPORT_TEXT("report", "temperature too noisy")});
}

std::string shownName(const DriftChannel &channel) {
    return channel.name.empty() ? "–" : channel.name;
}

Text thermalNature() {
    return REPORT_TEXT(
        "report", "Interpretation, not a result of ISO 230-2. Environmental variation error: largest range "
                  "over a duration T (public drafts of annex A).");
}

bool hasThermalPage(const Test &test) {
    const auto *drift = std::get_if<DriftMeasurement>(&test.measurement);
    return drift && (!drift->channels.empty() || !drift->temperatures.empty());
}

LineFigure channelFigure(const DriftMeasurement &drift, const std::vector<ThermalChannel> &channels,
                         std::size_t shown, const Language &language,
                         const std::optional<TakenVariation> &worst) {
    const Quantity quantity = quantityAt(shown, channels);
    LineFigure figure =
        overTime(drift, REPORT_TEXT("report", "Drift"), REPORT_TEXT("report", "Deviation at rest"),
                 language.unit(quantity), language);
    const double perSecond = 1 / timeScale(drift).seconds;
    const double scale = unitScale(quantity, language.units());
    for (std::size_t i = 0; i < channels.size(); ++i) {
        if (deviationQuantity(channels[i].channel) != quantity)
            continue;
        const QString name = QString::fromStdString(channels[i].channel.name);
        figure.lines.push_back({channelRoles.at(i % channelRoles.size()),
                                name,
                                {},
                                pointsOf(drift.times, channels[i].channel.values, perSecond, scale)});
    }
    if (shown < channels.size() && channels[shown].best) {
        const ThermalResponse &response = channels[shown].responses[*channels[shown].best];
        std::vector<QPointF> points;
        for (std::size_t i = 0; i < response.times.size(); ++i)
            points.emplace_back(response.times[i] * perSecond, response.fitted[i] * scale);
        figure.lines.push_back({LineRole::fitted,
                                {},
                                language.sentence({REPORT_TEXT("report", "response of %1 to “%2”"),
                                                   {shownName(channels[shown].channel),
                                                    drift.temperatures[*channels[shown].best].measures},
                                                   {}}),
                                std::move(points)});
    }
    if (worst && deviationQuantity(worst->channel) == quantity) {
        const Variation &most = worst->variation;
        figure.band = bandOf(drift, most);
        figure.band->label = language.sentence(
            {REPORT_TEXT("report", "the %1 in which %2 varies most"),
             {durationText(most.to - most.from, language).toStdString(), shownName(worst->channel)},
             {}});
        figure.span =
            FigureSpan{most.low * scale, most.high * scale,
                       language.number(most.value, quantity, 1) + QChar::Nbsp + language.unit(quantity)};
    }
    return finished(std::move(figure), language);
}

LineFigure temperatureFigure(const DriftMeasurement &drift, const Language &language,
                             const std::optional<TakenVariation> &worst) {
    LineFigure figure = overTime(drift, REPORT_TEXT("report", "Temperatures"),
                                 REPORT_TEXT("report", "Temperature"), QStringLiteral("°C"), language);
    for (std::size_t i = 0; i < drift.temperatures.size(); ++i) {
        const QString name = QString::fromStdString(drift.temperatures[i].measures);
        figure.lines.push_back(
            {channelRoles.at(i % channelRoles.size()),
             name,
             {},
             pointsOf(drift.times, drift.temperatures[i].values, 1 / timeScale(drift).seconds, 1)});
    }
    if (worst)
        figure.band = bandOf(drift, worst->variation);
    return finished(std::move(figure), language);
}

LineFigure variationFigure(const DriftMeasurement &drift, Quantity quantity, const Language &language) {
    constexpr int steps = 60;
    const std::vector<DriftChannel> channels = channelsOf(drift);
    LineFigure figure = overTime(drift, variationTitle, {}, language.unit(quantity), language);
    figure.x.quantity = language.text(REPORT_TEXT("report", "Duration of the window T"));
    figure.y.symbol = QStringLiteral("E");
    figure.y.subscript = QStringLiteral("VE");
    const double lasts = drift.times.empty() ? 0 : drift.times.back() - drift.times.front();
    for (std::size_t i = 0; i < channels.size(); ++i) {
        if (deviationQuantity(channels[i]) != quantity)
            continue;
        const QString name = QString::fromStdString(channels[i].name);
        FigureLine line{channelRoles.at(i % channelRoles.size()), name, {}, {}};
        for (int step = 1; step <= steps; ++step) {
            const double duration = lasts * step / steps;
            if (const auto found = variationOf(drift.times, channels[i].values, duration))
                line.points.emplace_back(duration / timeScale(drift).seconds,
                                         found->value * unitScale(quantity, language.units()));
        }
        figure.lines.push_back(std::move(line));
    }
    return finished(std::move(figure), language, true);
}

Table responseTable(const DriftMeasurement &drift, const std::vector<ThermalChannel> &channels,
                    const Language &language) {
    constexpr double number = 20; // mm
    constexpr double interval = 28;
    const Writer write(language);
    const auto unitOf = [&](const ThermalChannel &one) {
        return language.unit(deviationQuantity(one.channel));
    };
    const bool mixed = std::ranges::any_of(
        channels, [&](const ThermalChannel &one) { return unitOf(one) != unitOf(channels.front()); });
    const QString unit = channels.empty() || mixed ? QString() : unitOf(channels.front());
    Table table;
    table.columns = {
        write.column(REPORT_TEXT_FOR("report", "Channel", "of a drift test"), 16),
        write.flexible(REPORT_TEXT("report", "Temperature"), 30),
        columnOf(QStringLiteral("k"), number, Alignment::decimal, unit + QStringLiteral("/°C")),
        write.column(REPORT_TEXT("report", "interval, 95 %"), interval),
        columnOf(QStringLiteral("τ"), number, Alignment::decimal, QStringLiteral("min")),
        write.column(REPORT_TEXT("report", "interval, 95 %"), interval),
        columnOf(QStringLiteral("b"), number - 3, Alignment::decimal, unit + QStringLiteral("/h")),
        columnOf(QStringLiteral("s"), number - 4, Alignment::decimal, unit)};
    for (const ThermalChannel &one : channels) {
        const QString name = QString::fromStdString(shownName(one.channel)) +
                             (mixed ? QStringLiteral(" (%1)").arg(unitOf(one)) : QString());
        const double scale = unitScale(deviationQuantity(one.channel), language.units());
        if (!one.best) {
            QStringList why;
            for (std::size_t i = 0; i < one.responses.size(); ++i)
                why << QString::fromStdString(drift.temperatures[i].measures) +
                           language.semicolon().replace(u';', u':') +
                           language.text(noResponseText(one.responses[i].state));
            Cell words(why.join(language.semicolon()));
            words.extras.edit().columns = table.columns.size() - 1;
            std::vector<Cell> row{boldCell(name), std::move(words)};
            row.resize(table.columns.size(), blankCell());
            table.rows.push_back(std::move(row));
            continue;
        }
        const ThermalResponse &response = one.responses[*one.best];
        table.rows.push_back({boldCell(name), QString::fromStdString(drift.temperatures[*one.best].measures),
                              boldCell(valueText(response.k, response.kRange, scale, language)),
                              intervalText(response.kRange, scale, language),
                              boldCell(valueText(response.tau, response.tauRange, 1 / minute, language)),
                              intervalText(response.tauRange, 1 / minute, language),
                              valueText(response.slope, response.slopeRange, scale * hour, language),
                              language.number(response.residual * scale, Quantity::number, 2)});
    }
    return table;
}

Table driftCaseTable(const DriftCases &cases, bool angular, const Language &language) {
    constexpr double number = 20; // mm
    const Writer write(language);
    const Quantity quantity = angular ? Quantity::angularDeviation : Quantity::deviation;
    const QString unit = language.unit(quantity);
    Table table;
    table.columns = {
        write.flexible(REPORT_TEXT_FOR("report", "Case", "of drift"), 60),
        columnOf(Phrase({{QStringLiteral("E")}, {QStringLiteral("VE"), true}}), number, Alignment::decimal,
                 unit),
        columnOf(write.say(REPORT_TEXT("report", "Share of U²(%1)"),
                           {cases.parameters.empty() ? std::string() : cases.parameters.front()}),
                 24, Alignment::decimal, QStringLiteral("%"))};
    for (const std::string &parameter : cases.parameters)
        table.columns.push_back(columnOf(QStringLiteral("U(%1)").arg(QString::fromStdString(parameter)),
                                         number, Alignment::decimal, unit));
    table.columns.push_back(columnOf(QString(), 26));
    double largest = 0;
    for (const DriftCase &one : cases.cases) {
        if (one.kind != DriftCase::held && !one.expanded.empty())
            largest = std::max(largest, one.expanded.front().value_or(0));
    }
    for (const DriftCase &one : cases.cases) {
        const QString sign = boundSign(one);
        const auto shown = [&](std::optional<double> value) {
            return value ? sign + language.number(*value, quantity, 1) : QString();
        };
        Cell bar = blankCell();
        if (const double size = one.expanded.front().value_or(0); largest > 0 && size <= largest) {
            bar.blank = false;
            bar.extras.edit().bar = size / largest;
            bar.extras.edit().hollow = one.kind != DriftCase::asTested;
        }
        std::vector<Cell> row{caseName(one, language), shown(one.variation),
                              one.share ? sign + language.number(*one.share * percent, Quantity::number, 0)
                                        : QString()};
        for (const std::optional<double> &expanded : one.expanded)
            row.emplace_back(shown(expanded));
        row.push_back(std::move(bar));
        if (one.kind == DriftCase::asTested) {
            for (Cell &cell : row)
                cell.bold = true;
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

QString driftCaseNote(const DriftCases &cases, const Language &language) {
    QString note = language.text(REPORT_TEXT("report", "U of the budget (GUM) with that variation."));
    if (std::ranges::any_of(cases.cases, [](const DriftCase &one) { return one.kind == DriftCase::held; }))
        note += u' ' + language.text(REPORT_TEXT("report", "θ held to ± Δ: at most 2Δ·|k|·(1 − e^(−T/τ)) "
                                                           "plus the variation of x − k·y over T."));
    return note;
}

QString rangesOfChannels(const DriftMeasurement &drift, const Language &language) {
    QStringList ranges;
    for (const DriftChannel &channel : channelsOf(drift)) {
        if (const auto whole = variationOf(drift.times, channel.values, std::nullopt))
            ranges << QString::fromStdString(shownName(channel)) + u' ' +
                          language.quantity(whole->value, deviationQuantity(channel), 1);
    }
    return ranges.isEmpty() ? QString()
                            : language.sentence(REPORT_TEXT("report", "Ranges of the record: %1"),
                                                {ranges.join(language.semicolon()).toStdString()});
}

QStringList thermalNotes(const DriftMeasurement &drift, const std::vector<ThermalChannel> &channels,
                         const Language &language) {
    QStringList notes;
    if (std::ranges::none_of(channels, [](const ThermalChannel &one) { return one.best.has_value(); }))
        return notes;
    notes << language.text(
        REPORT_TEXT("report", "x = a + b·t + k·y; τ·dy/dt = θ − y: one time constant, a model of this "
                              "program. k and b by least squares, τ by a search; intervals of 95 % "
                              "(Student’s t, degrees of freedom by JCGM 100, G.4) for noise that may be "
                              "correlated, its spectrum taken from the residuals; shown by an F test. Of "
                              "several temperatures the one that explains most."));
    for (const ThermalChannel &one : channels) {
        if (!one.best)
            continue;
        const std::vector<double> temperatures = withGaps(drift.temperatures[*one.best].values);
        if (const auto end = one.responses[*one.best].warmUp(temperatures))
            notes << language.sentence(
                {REPORT_TEXT("report", "%1 was warm after %2: less than a tenth of the range of y was left."),
                 {shownName(one.channel), durationText(*end, language).toStdString()},
                 {}});
    }
    return notes;
}

namespace {

/// Variation within the test, its share of U² and its origin.
VerdictLine causeLine(const DriftMeasurement &drift, const ThermalChannel &channel, const DriftCases &cases,
                      bool angular, const Language &language) {
    const Writer write(language);
    const Quantity quantity = angular ? Quantity::angularDeviation : Quantity::deviation;
    const auto caseOf = [&](DriftCase::Kind kind) {
        return std::ranges::find(cases.cases, kind, &DriftCase::kind);
    };
    const auto tested = caseOf(DriftCase::asTested);
    VerdictLine line;
    line.interprets = true;
    if (tested == cases.cases.end())
        return line;
    line.label =
        tested->lasts
            ? write.say(REPORT_TEXT("report", "Variation of %1 in %2"),
                        {shownName(channel.channel), durationText(tested->lasts, language).toStdString()})
            : write.say(REPORT_TEXT("report", "Variation of %1, whole record"), {shownName(channel.channel)});
    const QString sign = boundSign(*tested);
    line.word = sign + write.quantity(tested->variation, quantity, 1);
    const std::string parameter = cases.parameters.empty() ? std::string() : cases.parameters.front();
    line.limits.label = write.text(REPORT_TEXT_FOR("report", "Share", "of the drift in an uncertainty"));
    if (tested->share && tested->expanded.front())
        line.limits.state =
            write.say(REPORT_TEXT("report", "%1 of U²(%2)"),
                      {(sign + write.quantity(*tested->share * percent, Quantity::percent, 0)).toStdString(),
                       parameter});
    QStringList expanded;
    if (tested->expanded.front())
        expanded << QStringLiteral("U(%1) ").arg(QString::fromStdString(parameter)) +
                        (tested->isLowerBound ? sign : QStringLiteral("= ")) +
                        write.quantity(*tested->expanded.front(), quantity, 1);
    if (const auto none = caseOf(DriftCase::none); none != cases.cases.end() && none->expanded.front())
        expanded << write.say(REPORT_TEXT("report", "without drift %1"),
                              {write.quantity(*none->expanded.front(), quantity, 1).toStdString()});
    line.limits.text = expanded.join(language.semicolon());
    line.accordance.label = write.text(REPORT_TEXT_FOR("report", "Cause", "of the drift"));
    const double scale = unitScale(quantity, language.units());
    if (!channel.best) {
        line.accordance.state =
            write.text(drift.temperatures.empty() ? REPORT_TEXT("report", "no temperature was recorded")
                                                  : noResponseText(channel.responses.front().state));
        return line;
    }
    const ThermalResponse &response = channel.responses[*channel.best];
    line.accordance.state = QString::fromStdString(drift.temperatures[*channel.best].measures) +
                            QStringLiteral(", ") + valueText(response.k, response.kRange, scale, language) +
                            QChar::Nbsp + language.unit(quantity) + QStringLiteral("/°C");
    line.accordance.text = QStringLiteral("(%1), τ = %2\u00A0min (%3)")
                               .arg(intervalText(response.kRange, scale, language),
                                    valueText(response.tau, response.tauRange, 1 / minute, language),
                                    intervalText(response.tauRange, 1 / minute, language));
    return line;
}

std::size_t placeOf(const DriftChannel &channel, const std::vector<ThermalChannel> &channels) {
    const auto found = std::ranges::find(channels, channel, &ThermalChannel::channel);
    return static_cast<std::size_t>(found == channels.end() ? 0 : found - channels.begin());
}

/// Lengths and angles have figures of their own: `shown` and the first channel of the other unit, if any.
std::vector<std::size_t> firstOfEachUnit(const std::vector<ThermalChannel> &channels, std::size_t shown) {
    std::vector<std::size_t> result{shown};
    const auto other = std::ranges::find_if(channels, [&](const ThermalChannel &one) {
        return one.channel.quantity != channels[shown].channel.quantity;
    });
    if (other != channels.end())
        result.push_back(static_cast<std::size_t>(other - channels.begin()));
    return result;
}

/// The record over its time, the temperatures below.
void addChannelFigures(std::vector<Block> &blocks, const DriftMeasurement &drift,
                       const std::vector<ThermalChannel> &channels,
                       const std::vector<std::size_t> &ofEachUnit, const std::optional<TakenVariation> &worst,
                       const Language &language) {
    constexpr double driftHeight = 40; // mm
    constexpr double leastDrift = 35;
    constexpr double temperatureHeight = 26;
    constexpr double leastTemperature = 23;
    const bool hasTemperatures = !drift.temperatures.empty();
    std::vector<LineFigure> drawn;
    QStringList fitted;
    for (const std::size_t one : ofEachUnit) {
        LineFigure &figure = drawn.emplace_back(channelFigure(drift, channels, one, language, worst));
        for (FigureLine &line : figure.lines) { // a legend would take a row
            if (line.role == LineRole::fitted)
                fitted << std::exchange(line.name, {});
        }
        if (hasTemperatures || one != ofEachUnit.back())
            figure.x.quantity.clear(); // the figure below has the same axis
    }
    addHeading(blocks,
               language.text(hasTemperatures ? REPORT_TEXT("report", "Drift and temperatures")
                                             : REPORT_TEXT("report", "Drift")),
               fitted.isEmpty() ? QString()
                                : language.sentence(REPORT_TEXT("report", "thin black line: %1"),
                                                    {fitted.join(language.semicolon()).toStdString()}));
    for (LineFigure &figure : drawn)
        blocks.emplace_back(FigureBlock{std::move(figure), textWidth, driftHeight, leastDrift});
    if (hasTemperatures)
        blocks.emplace_back(FigureBlock{temperatureFigure(drift, language, worst), textWidth,
                                        temperatureHeight, leastTemperature});
}

} // namespace

std::vector<Block> thermalBlocks(const EvaluatedDocument &evaluated, std::size_t test,
                                 const Language &language) {
    const Writer write(language);
    const auto &drift = std::get<DriftMeasurement>(evaluated.document->tests[test]->measurement);
    const std::vector<ThermalChannel> channels = thermalChannels(drift);
    std::vector<Block> blocks;
    constexpr double variationHeight = 40; // mm
    constexpr double half = 80;
    const bool hasTemperatures = !drift.temperatures.empty();
    const std::vector<std::size_t> users =
        testsTaking(*evaluated.document, evaluated.document->tests[test]->id);
    std::optional<TakenVariation> worst;
    if (!users.empty())
        worst = takenVariation(*evaluated.document, evaluated.document->tests[test]->id,
                               *evaluated.document->tests[users.front()]);
    const std::size_t shown = placeOf(worst ? worst->channel : mainChannel(drift), channels);
    if (worst) {
        const Test &taking = *evaluated.document->tests[users.front()];
        if (!taking.duration ||          // the window is the whole record
            worst->variation.value <= 0) // a reading that does not move varies nowhere most
            worst.reset();
        const DriftCases cases = driftCases(evaluated, users.front());
        if (!cases.cases.empty())
            blocks.emplace_back(
                causeLine(drift, channels[shown], cases, motionOf(taking) == Motion::rotary, language));
    }
    const std::vector<std::size_t> ofEachUnit = firstOfEachUnit(channels, shown);
    addChannelFigures(blocks, drift, channels, ofEachUnit, worst, language);
    std::vector<Part> left{Heading{2, write.text(variationTitle)}};
    for (const std::size_t one : ofEachUnit)
        left.emplace_back(FigureBlock{variationFigure(drift, quantityAt(one, channels), language), half,
                                      variationHeight, variationHeight});
    std::vector<Part> right;
    if (hasTemperatures) {
        right.emplace_back(Heading{2, write.text(REPORT_TEXT("report", "Response to the temperature")),
                                   QStringLiteral("95\u00A0%")});
        right.emplace_back(inHalf(responseTable(drift, channels, language)));
    }
    if (const QString ranges = rangesOfChannels(drift, language); !ranges.isEmpty())
        right.emplace_back(Paragraph{ranges, TextSize::small});
    blocks.emplace_back(SideBySide{std::move(left), std::move(right), half});
    QString caseNote;
    for (const std::size_t user : users) {
        const DriftCases cases = driftCases(evaluated, user);
        if (cases.cases.empty())
            continue;
        const Test &taking = *evaluated.document->tests[user];
        addHeading(blocks, write.text(REPORT_TEXT("report", "What the drift explains")),
                   joined({testName(write, taking), QString::fromStdString(taking.title)}));
        blocks.emplace_back(driftCaseTable(cases, motionOf(taking) == Motion::rotary, language));
        caseNote = driftCaseNote(cases, language);
    }
    QStringList notes = thermalNotes(drift, channels, language);
    if (!caseNote.isEmpty())
        notes.prepend(caseNote);
    if (!notes.isEmpty())
        blocks.emplace_back(Paragraph{notes.join(u' '), TextSize::small});
    return blocks;
}

void addThermalPages(std::vector<Block> &blocks, const EvaluatedDocument &evaluated, const Writer &write) {
    const Document &document = *evaluated.document;
    bool any = false;
    for (std::size_t i = 0; i < evaluated.tests.size(); ++i) {
        if (!hasThermalPage(*document.tests[i]))
            continue;
        any = true;
        TestHead head = thermalHead(write, evaluated, i);
        blocks.emplace_back(PageBreak{});
        blocks.emplace_back(
            RunningHead{head.laboratory, joined({head.title, head.subtitle}, QStringLiteral(" · "))});
        blocks.emplace_back(std::move(head));
        std::ranges::move(thermalBlocks(evaluated, i, write.language()), std::back_inserter(blocks));
    }
    if (any)
        blocks.emplace_back(RunningHead{QString::fromStdString(document.report.laboratory.name),
                                        reportTitle(write, document.report)});
}

} // namespace palmer
