// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/trendoutput.h"

#include "document/filewords.h"
#include "language/csvwriter.h"
#include "language/rounding.h"
#include "register/jsonline.h"
#include "register/listing.h"
#include "register/sincelast.h"
#include "report/parts/comparedtests.h"
#include "report/parts/testpart.h"
#include "report/tables/summary.h"
#include "report/words/wording.h"

#include <QLocale>
#include <algorithm>
#include <array>

namespace palmer {

namespace {

constexpr int slopeDecimals = 2;

std::string isoOf(double years) {
    return dateOfYears(years).toString(Qt::ISODate).toStdString();
}

const char *reachWord(NotBefore::State state) {
    constexpr std::array words{"noLimit", "beyond", "already", "date"};
    return words.at(static_cast<std::size_t>(state));
}

const char *interventionWord(InterventionKind kind) {
    constexpr std::array words{"adjustment", "compensation", "repair", "collision"};
    return words.at(static_cast<std::size_t>(kind));
}

bool saysDate(const MachineTrend &trend) {
    return trend.line && trend.notBefore.state == NotBefore::State::date;
}

/// Returns a number with its sign: "+1.29".
QString signedNumber(double value, Quantity quantity, int decimals, const Language &language) {
    return (value >= 0 ? QStringLiteral("+") : QString()) + language.number(value, quantity, decimals);
}

} // namespace

QString unitInWords(const MachineTrend &trend, const Language &language) {
    const QString unit = language.unit(trendQuantity(trend));
    return unit == QStringLiteral("″") ? language.text(REPORT_TEXT("report", "arc second")) : unit;
}

Quantity trendQuantity(const MachineTrend &trend) {
    return trend.angular ? Quantity::angularDeviation : Quantity::deviation;
}

QString monthText(const QDate &date, const Language &language) {
    return QLocale(language.code()).toString(date, QStringLiteral("MMMM yyyy"));
}

QString shortMonthText(const QDate &date, const Language &language) {
    return QLocale(language.code()).toString(date, QStringLiteral("MMM yyyy"));
}

QString interventionName(InterventionKind kind, const Language &language) {
    static constexpr std::array names{// in the order of InterventionKind
                                      REPORT_TEXT_FOR("report", "adjustment", "intervention"),
                                      REPORT_TEXT_FOR("report", "compensation", "intervention"),
                                      REPORT_TEXT_FOR("report", "repair", "intervention"),
                                      REPORT_TEXT_FOR("report", "collision", "intervention")};
    return language.text(names.at(static_cast<std::size_t>(kind)));
}

namespace {

constexpr std::array<std::pair<const char *, Text>, 8> propertyNames{
    {{"rapid", REPORT_TEXT("report", "rapid feed")},
     {"step", REPORT_TEXT("report", "step cycle")},
     {"feedback", REPORT_TEXT("report", "feedback signal")},
     {"zone", REPORT_TEXT("report", "Working zone")},
     {"compensation", REPORT_TEXT("report", "Active compensation")},
     {"tool", REPORT_TEXT("report", "Tool offset")},
     {"workpiece", REPORT_TEXT("report", "Workpiece offset")},
     {"runs", REPORT_TEXT("report", "runs in either direction")}}};

/// "zone 0 … 500": "Working zone: 0 … 500 mm".
QString propertyText(const QString &property, bool angular, const Language &language) {
    const QByteArray word = property.section(u' ', 0, 0).toLatin1();
    QString value = property.section(u' ', 1);
    const auto known =
        std::ranges::find_if(propertyNames, [&](const auto &one) { return word == one.first; });
    QString name = known == propertyNames.end() ? property : language.text(known->second);
    name.front() = name.front().toLower(); // in a list, after other words
    if (value.isEmpty() || known == propertyNames.end())
        return name;
    if (word != "runs" && word != "compensation" && value.contains(u' '))
        value =
            lengthsText(value, angular && word == "zone" ? Quantity::angle : Quantity::position, language);
    return language.sentence({REPORT_TEXT("report", "%1: %2"),
                              {name.toStdString(), value.replace(u' ', QChar::Nbsp).toStdString()}});
}

} // namespace

QString seriesName(const TrendSeries &series, bool angular, const Language &language) {
    QStringList parts;
    const SeriesDifference &difference = series.difference;
    if (difference.edition)
        parts << QString::fromStdString(series.edition);
    if (difference.feed)
        parts << (series.feed
                      ? language.sentence(
                            {REPORT_TEXT("report", "feed %1"),
                             {Number{*series.feed, angular ? Quantity::angularFeed : Quantity::feed, -1}}})
                      : language.text(REPORT_TEXT("report", "no feed stated")));
    if (difference.travel)
        parts << (series.travel
                      ? language.sentence(
                            {REPORT_TEXT("report", "travel or radius %1"),
                             {Number{*series.travel, angular ? Quantity::angle : Quantity::position, -1}}})
                      : language.text(REPORT_TEXT("report", "no targets")));
    if (difference.correction)
        parts << language.sentence(
            {REPORT_TEXT("report", "correction to 20 °C: %1"), {correctionText(series.correction)}});
    for (const QString &property : difference.setUp)
        parts << propertyText(property, angular, language);
    return parts.join(QStringLiteral(", "));
}

QString seriesText(TrendSeries series, bool angular, const Language &language) {
    series.difference = {
        true, true, true, true,
        QString::fromStdString(series.setUp).split(QStringLiteral("; "), Qt::SkipEmptyParts)};
    return seriesName(series, angular, language);
}

QString editionOf(const MachineTrend &trend) {
    return trend.series.empty() ? QString() : QString::fromStdString(trend.series.front().edition);
}

QString otherSeries(const MachineTrend &trend, const Language &language) {
    QStringList others;
    for (const TrendSeries &series : trend.series)
        others << seriesName(series, trend.angular, language);
    others.removeAll(QString());
    return others.isEmpty() ? QString()
                            : language.sentence({REPORT_TEXT("report", "Another series: %1"),
                                                 {others.join(QStringLiteral(" · ")).toStdString()}});
}

namespace {

/// Returns when the bound of the line reaches the limit. Precondition: the trend has both.
QString boundStatement(const MachineTrend &trend, const Language &language) {
    const auto month = [&](double time) { return monthText(dateOfYears(time), language).toStdString(); };
    switch (trend.notBefore.state) {
    case NotBefore::State::already:
        return language.text(REPORT_TEXT("report", "the bound is at the limit already"));
    case NotBefore::State::beyond:
        return language.sentence({REPORT_TEXT("report", "not before %1; nothing is said beyond"),
                                  {month(trendHorizon(*trend.line))}});
    case NotBefore::State::date:
        return language.sentence({REPORT_TEXT("report", "not before %1"), {month(trend.notBefore.time)}});
    case NotBefore::State::noLimit:
        break;
    }
    return {};
}

} // namespace

QString trendStatement(const MachineTrend &trend, const Language &language) {
    if (!trend.line)
        return language.sentence({REPORT_TEXT("report", "fewer than %1 tests since the last intervention"),
                                  {Number{static_cast<double>(fewestTrendPoints), Quantity::count}}});
    const QString noTrend = language.text(REPORT_TEXT("report", "no trend shown"));
    if (trend.notBefore.state == NotBefore::State::noLimit)
        return trend.line->isShown() ? language.text(REPORT_TEXT("report", "no limit")) : noTrend;
    return (trend.line->isShown() ? QString() : noTrend + language.semicolon()) +
           boundStatement(trend, language);
}

QString shortTrendStatement(const MachineTrend &trend, const Language &language) {
    if (!trend.line)
        return language.text(REPORT_TEXT("report", "too few tests"));
    if (trend.notBefore.state == NotBefore::State::beyond)
        return language.sentence(
            {REPORT_TEXT("report", "not before %1 *"),
             {shortMonthText(dateOfYears(trendHorizon(*trend.line)), language).toStdString()}});
    if (trend.notBefore.state == NotBefore::State::date)
        return language.sentence(
            {REPORT_TEXT("report", "not before %1"),
             {shortMonthText(dateOfYears(trend.notBefore.time), language).toStdString()}});
    if (trend.notBefore.state == NotBefore::State::already)
        return language.text(REPORT_TEXT("report", "at the limit"));
    return trendStatement(trend, language);
}

QString trendMethod(const MachineTrend &trend, const Language &language, bool withFormula) {
    QStringList sentences{language.text(REPORT_TEXT(
        "report", "Generalised least squares since the last intervention; what tests share (instrument, "
                  "temperature sensors, α of the machine) is no scatter."))};
    if (withFormula)
        sentences << language.text(
            REPORT_TEXT("report", "V = diag(r² + s²) + Σ c·cᵀ: r own, c shared, s scatter beyond them."));
    sentences << language.text(REPORT_TEXT(
        "report", "A trend is shown where the slope is at least t times its standard uncertainty (95 %). Not "
                  "before: line + t·u reaches the limit, less the guard band where conformity has to be "
                  "proven; one-sided 95 %, for the level, not for the next test."));
    if (trend.line)
        sentences << language.sentence(
            {REPORT_TEXT("report", "Nothing is said beyond %1, twice the observed time."),
             {monthText(dateOfYears(trendHorizon(*trend.line)), language).toStdString()}});
    if (trend.withoutParts)
        sentences << language.text(REPORT_TEXT("report", "A U is stated without its parts: it is taken as "
                                                         "shared by the tests with the same instrument."));
    if (trend.withoutDate > 0)
        sentences << language.sentence(
            {REPORT_TEXT_COUNTED("report", "%n test(s) without a date are left out."),
             {},
             trend.withoutDate});
    return sentences.join(u' ');
}

std::vector<KeyValue> trendFacts(const MachineTrend &trend, const Language &language) {
    if (!trend.line)
        return {};
    const TrendLine &line = *trend.line;
    const Quantity quantity = trendQuantity(trend);
    const QString unit = language.unit(quantity);
    std::vector<KeyValue> facts;
    facts.push_back({language.text(REPORT_TEXT("report", "since")), language.shortDate(trend.since)});
    facts.push_back({language.text(REPORT_TEXT("report", "tests")),
                     language.sentence({REPORT_TEXT("report", "%1 in %2 years"),
                                        {Number{static_cast<double>(line.points), Quantity::count},
                                         Number{line.last - line.first, Quantity::number, 1}}})});
    facts.push_back(
        {language.text(REPORT_TEXT("report", "slope")),
         language.sentence(
             {REPORT_TEXT("report", "%1 %2/year, u %3"),
              {signedNumber(line.slope, quantity, slopeDecimals, language).toStdString(), unit.toStdString(),
               language.number(line.slopeUncertainty(), quantity, slopeDecimals).toStdString()}})});
    facts.push_back({language.text(REPORT_TEXT("report", "line at the last test")),
                     language.number(line.at(line.last), quantity, 1) + QStringLiteral("\u00A0±\u00A0") +
                         language.quantity(2 * line.uncertaintyAt(line.last), quantity, 1)});
    facts.push_back({language.text(REPORT_TEXT("report", "scatter s")),
                     language.quantity(line.scatter, quantity, 1) + QStringLiteral(" · χ²/ν\u00A0") +
                         (line.chi2PerDof ? language.number(*line.chi2PerDof, Quantity::number, slopeDecimals)
                                          : QStringLiteral("–"))});
    return facts;
}

namespace {

/// Precondition: the trend has a line.
Json lineJson(const MachineTrend &trend) {
    const TrendLine &line = *trend.line;
    return {{"since", trend.since},
            {"points", static_cast<int>(line.points)},
            {"slopePerYear", orNull(line.slope)},
            {"u", orNull(line.slopeUncertainty())},
            {"level", orNull(line.at(line.last))},
            {"uOfLevel", orNull(line.uncertaintyAt(line.last))},
            {"scatter", orNull(line.scatter)},
            {"chi2PerDof", orNull(line.chi2PerDof)},
            {"shown", line.isShown()},
            {"limit", orNull(trend.limit)},
            {"guardBand", trend.reserve > 0 ? orNull(trend.reserve) : Json()},
            {"notBefore", saysDate(trend) ? Json(isoOf(trend.notBefore.time)) : Json()},
            {"reach", reachWord(trend.notBefore.state)},
            {"horizon", isoOf(trendHorizon(line))},
            {"withoutParts", trend.withoutParts}};
}

/// Changes since the last test; null: not asked for, or not compared.
Json sinceLastJson(const TrendEntry &entry, const std::string &parameter) {
    const ComparedParameter *change = entry.sinceLast ? changeOf(*entry.sinceLast, parameter) : nullptr;
    return change ? changeJson({{"date", orNull(entry.sinceLast->date)}}, *change) : Json();
}

/// "−9.1 ± 3.7 changed, better", or why nothing is said.
QString sinceLastText(const TrendEntry &entry, const MachineTrend &trend, const Language &language) {
    const ComparedParameter *change = entry.sinceLast ? changeOf(*entry.sinceLast, trend.parameter) : nullptr;
    if (!change || !change->word)
        return entry.sinceLast ? sinceLastWord(*entry.sinceLast, language) : QString();
    const auto words = comparedWords(entry.sinceLast->comparison, language);
    const auto index = static_cast<std::size_t>(change - entry.sinceLast->comparison.parameters.data());
    return words[index].difference + QStringLiteral("\u00A0±\u00A0") + words[index].uncertainty + u' ' +
           words[index].word;
}

Json seriesJson(const TrendSeries &series, const MachineTrend &trend) {
    Json points = Json::array();
    for (const TrendEntry &entry : series.entries) {
        Json shared = Json::array();
        for (const SharedPart &part : entry.shared)
            shared.push_back({{"source", part.source}, {"u", part.u}});
        points.push_back({{"date", entry.date},
                          {"value", orNull(entry.result.value)},
                          {"U", orNull(entry.result.expandedUncertainty)},
                          {"k", orNull(entry.result.k)},
                          {"coverageProbability", orNull(entry.result.coverageProbability())},
                          {"uOwn", entry.result.expandedUncertainty ? Json(entry.result.own) : Json()},
                          {"uShared", shared},
                          {"limit", orNull(entry.result.limit)},
                          {"role", fileWord(entry.role)},
                          {"purpose", fileWord(entry.purpose)},
                          {"file", entry.file.toStdString()},
                          {"test", entry.test},
                          {"sinceLast", sinceLastJson(entry, trend.parameter)}});
    }
    return {{"edition", orNull(series.edition)},
            {"feed", orNull(series.feed)},
            {"travel", orNull(series.travel)},
            {"correctionTo20", fileWord(series.correction)},
            {"setUp", series.setUp},
            {"points", points}};
}

} // namespace

QByteArray trendJson(const ListedMachine &machine, const std::string &axis, const MachineTrend &trend) {
    Json series = Json::array();
    for (const TrendSeries &one : trend.series)
        series.push_back(seriesJson(one, trend));
    Json interventions = Json::array();
    for (const Intervention &one : trend.interventions)
        interventions.push_back({{"date", one.date}, {"kind", interventionWord(one.kind)}});
    const Json who{{"name", orNull(machine.name.toStdString())},
                   {"manufacturer", orNull(machine.manufacturer.toStdString())},
                   {"model", orNull(machine.model.toStdString())},
                   {"serialNumber", orNull(machine.serialNumber.toStdString())}};
    return jsonLine("trend", {{"machine", who},
                              {"axis", axis},
                              {"parameter", trend.parameter},
                              {"unit", trend.angular ? "deg" : "mm"},
                              {"series", series},
                              {"interventions", interventions},
                              {"withoutDate", trend.withoutDate},
                              {"line", trend.line ? lineJson(trend) : Json()}});
}

namespace {

/// `series`: the index; the first one carries the line.
void addRow(CsvWriter &csv, const ListedMachine &machine, const std::string &axis, const MachineTrend &trend,
            std::size_t series, const TrendEntry &entry) {
    const bool onLine = series == 0 && trend.line && entry.stretch == trend.interventions.size();
    const ComparedParameter *change = entry.sinceLast ? changeOf(*entry.sinceLast, trend.parameter) : nullptr;
    csv.row(machine.name.toStdString(), machine.manufacturer.toStdString(), machine.model.toStdString(),
            machine.serialNumber.toStdString(), axis, trend.parameter, static_cast<double>(series + 1),
            trend.series[series].edition, entry.date, entry.result.value, entry.result.expandedUncertainty,
            entry.result.limit, trend.angular ? "deg" : "mm", fileWord(entry.role), fileWord(entry.purpose),
            onLine ? std::optional(trend.line->at(entry.time)) : std::nullopt,
            onLine ? std::optional(trend.line->uncertaintyAt(entry.time)) : std::nullopt,
            entry.file.toStdString(), entry.test,
            entry.sinceLast ? entry.sinceLast->date.value_or("") : std::string(),
            change && change->word ? fileWord(*change->word) : "",
            change ? std::optional(change->difference) : std::nullopt,
            change ? change->uncertainty : std::nullopt);
}

} // namespace

QByteArray trendCsv(const ListedMachine &machine, const std::string &axis,
                    const std::vector<MachineTrend> &trends) {
    CsvWriter csv('.');
    csv.row("machine", "manufacturer", "model", "serialNumber", "axis", "parameter", "series", "edition",
            "date", "value", "U", "limit", "unit", "role", "purpose", "line", "uOfLine", "file", "test",
            "lastDate", "sinceLast", "difference", "differenceU");
    for (const MachineTrend &trend : trends) {
        for (std::size_t i = 0; i < trend.series.size(); ++i) {
            for (const TrendEntry &entry : trend.series[i].entries)
                addRow(csv, machine, axis, trend, i, entry);
        }
    }
    return csv.bytes();
}

Report composeTrend(const ListedMachine &machine, const std::string &axis, const MachineTrend &trend,
                    const Language &language) {
    Report report;
    report.language = language.code();
    report.title = language.sentence(
        {REPORT_TEXT("report", "%1: trend of %2, axis or plane %3"),
         {machine.title().toStdString(), plainSymbolOf(trend.parameter).toStdString(), axis}});
    report.blocks.emplace_back(Heading{2, report.title});
    KeyValues facts;
    const Quantity quantity = trendQuantity(trend);
    const QString limit =
        trend.limit ? language.quantity(*trend.limit, quantity, limitDecimals(*trend.limit, quantity))
                    : QString();
    if (const QString edition = editionOf(trend); !edition.isEmpty())
        facts.rows.push_back({language.text(REPORT_TEXT("report", "Edition")), edition});
    facts.rows.push_back({language.text(REPORT_TEXT("report", "Limit")), limit});
    facts.rows.push_back({language.text(REPORT_TEXT("report", "Trend")), trendStatement(trend, language)});
    for (const KeyValue &fact : trendFacts(trend, language))
        facts.rows.push_back(fact);
    report.blocks.emplace_back(std::move(facts));
    const QString unit = language.unit(quantity);
    for (const TrendSeries &series : trend.series) {
        const QString name = seriesName(series, trend.angular, language);
        if (!name.isEmpty())
            report.blocks.emplace_back(Heading{
                3, language.sentence({REPORT_TEXT("report", "Another series: %1"), {name.toStdString()}})});
        Table table;
        table.columns = {{language.text(REPORT_TEXT("report", "Date"))},
                         {language.text(REPORT_TEXT("report", "Purpose"))},
                         {language.text(REPORT_TEXT("report", "Role"))},
                         {plainSymbolOf(trend.parameter), unit, Alignment::decimal},
                         {QStringLiteral("U"), unit, Alignment::decimal},
                         {language.text(REPORT_TEXT("report", "Limit")), unit, Alignment::decimal},
                         {language.text(REPORT_TEXT("report", "Against the last")), unit},
                         {language.text(REPORT_TEXT("report", "File")), {}, Alignment::left, true}};
        for (const TrendEntry &entry : series.entries) {
            const ShownValue shown = shownResult(entry.result, trend.angular, language);
            const Text purpose = purposeText(entry.purpose);
            const Text role = roleText(entry.role);
            table.rows.push_back(
                {Cell(language.shortDate(entry.date)),
                 Cell(purpose.empty() ? QString() : language.text(purpose)),
                 Cell(role.empty() ? QString() : language.text(role)), Cell(shown.value),
                 Cell(shown.uncertainty),
                 Cell(entry.result.limit ? language.number(*entry.result.limit, quantity,
                                                           limitDecimals(*entry.result.limit, quantity))
                                         : QString()),
                 Cell(sinceLastText(entry, trend, language)), Cell(entry.file)});
        }
        constexpr std::size_t changeColumn = 6;
        leaveOutEmptyColumns(table, changeColumn, changeColumn);
        report.blocks.emplace_back(std::move(table));
    }
    report.blocks.emplace_back(Paragraph{trendMethod(trend, language), TextSize::small});
    return report;
}

} // namespace palmer
