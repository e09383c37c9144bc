// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/listing.h"

#include "document/filewords.h"
#include "document/resultwords.h"
#include "kernel/measurement/testfacts.h"
#include "kernel/words/shortest.h"
#include "language/rounding.h"
#include "register/jsonline.h"
#include "register/machinetrend.h"
#include "register/sincelast.h"
#include "report/parts/comparedtests.h"
#include "report/parts/testpart.h"
#include "report/tables/summary.h"
#include "report/words/accordancetext.h"
#include "report/words/wording.h"

#include <QRegularExpression>
#include <algorithm>
#include <cmath>

namespace palmer {

namespace {

const char *unitOf(const RegisteredTest &test) {
    return test.angular ? "deg" : "mm";
}

Json resultJson(const RegisteredResult &result, const RegisteredTest &test) {
    return {{"id", result.id},
            {"value", orNull(result.value)},
            {"unit", unitOf(test)},
            {"expandedUncertainty", orNull(result.expandedUncertainty)},
            {"k", orNull(result.k)},
            {"coverageProbability", orNull(result.coverageProbability())},
            {"limit", orNull(result.limit)},
            {"guardBand", orNull(result.guardBand)},
            {"verdict", result.verdict ? Json(fileWord(*result.verdict)) : Json()}};
}

Json machineJson(const RegisteredTest &test) {
    return {{"name", orNull(test.machineName)},
            {"manufacturer", orNull(test.manufacturer)},
            {"model", orNull(test.model)},
            {"serialNumber", orNull(test.serialNumber)},
            {"location", orNull(test.location)}};
}

Json inAccordance(Accordance accordance) {
    return accordance == Accordance::yes ? Json(true) : accordance == Accordance::no ? Json(false) : Json();
}

SummaryTest identified(const ListedTest &listed) {
    static const QRegularExpression zone(
        QStringLiteral("(?:^|; )zone ([^;]*)")); // of "step; zone 0 … 500; runs 5 + 5"
    const RegisteredTest &test = listed.test;
    const TestPlace place = listed.places.empty() ? TestPlace() : listed.places.front();
    return {place.path,
            place.test,
            test.machineName,
            test.manufacturer,
            test.model,
            test.serialNumber,
            place.number.toStdString(),
            test.axis,
            test.date.value_or(""),
            test.edition,
            test.purpose,
            test.role,
            zone.match(QString::fromStdString(test.setUp)).captured(1).toStdString(),
            test.angular};
}

/// "test: 18 Nov 2026; certificate: 31 Jan 2027".
QString dueText(const ListedTest &listed, const Language &language) {
    QStringList parts;
    if (listed.due)
        parts << language.sentence(
            {REPORT_TEXT("report", "test: %1"), {language.shortDate(*listed.due).toStdString()}});
    if (listed.certificateDue)
        parts << language.sentence({REPORT_TEXT("report", "certificate: %1"),
                                    {language.shortDate(*listed.certificateDue).toStdString()}});
    return parts.join(language.semicolon());
}

Json sinceLastJson(const SinceLast &change) {
    Json parameters = Json::array();
    for (const ComparedParameter &one : change.comparison.parameters)
        parameters.push_back(changeJson({{"id", comparedId(one)}}, one));
    const auto word = wordOfAll(change.comparison);
    return {{"file", change.last.path.toStdString()},
            {"test", change.last.test},
            {"date", orNull(change.date)},
            {"word", word ? Json(fileWord(*word)) : Json()},
            {"refusal", change.comparison.refusal ? Json(fileWord(*change.comparison.refusal)) : Json()},
            {"noWord", change.comparison.noWord ? Json(fileWord(*change.comparison.noWord)) : Json()},
            {"parameters", parameters}};
}

} // namespace

QByteArray listedTestJson(const ListedTest &listed) {
    const RegisteredTest &test = listed.test;
    Json places = Json::array();
    for (const TestPlace &place : listed.places)
        places.push_back({{"file", place.path.toStdString()},
                          {"test", place.test},
                          {"reportNumber", orNull(place.number.toStdString())},
                          {"state", place.state.toStdString()}});
    Json instruments = Json::array();
    for (const RegisteredInstrument &one : test.instruments)
        instruments.push_back({{"description", orNull(one.description)},
                               {"serialNumber", orNull(one.serialNumber)},
                               {"certificate", orNull(one.certificate)},
                               {"calibrationDue", orNull(one.due)}});
    Json results = Json::array();
    for (const RegisteredResult &result : test.results)
        results.push_back(resultJson(result, test));
    const bool ofAxis = traitsOf(test.kind).isOfAxis;
    const std::string none;
    const SummaryTest summary = identified(listed);
    return jsonLine("list", {{"file", summary.file.toStdString()},
                             {"test", summary.test},
                             {"places", places},
                             {"machine", machineJson(test)},
                             {"reportNumber", orNull(summary.reportNumber)},
                             {"title", test.title},
                             {"kind", fileWord(test.kind)},
                             {"id", test.id},
                             {"axis", orNull(ofAxis ? test.axis : none)},
                             {"plane", orNull(ofAxis ? none : test.axis)},
                             {"date", orNull(test.date)},
                             {"time", orNull(test.time)},
                             {"edition", orNull(test.edition)},
                             {"zone", orNull(summary.zone)},
                             {"feed", orNull(test.feed)},
                             {"travel", orNull(test.travel)},
                             {"accordance", fileWord(test.accordance)},
                             {"inAccordance", inAccordance(test.accordance)},
                             {"unmet", test.counts.unmet},
                             {"undeclared", test.counts.undeclared},
                             {"departures", test.counts.departures},
                             {"role", fileWord(test.role)},
                             {"purpose", fileWord(test.purpose)},
                             {"limits", limitsWord(test.verdict)},
                             {"correctionTo20", fileWord(test.correction)},
                             {"decisionRule", fileWord(test.rule)},
                             {"parameters", results},
                             {"instruments", instruments},
                             {"due", orNull(listed.due)},
                             {"certificateDue", orNull(listed.certificateDue)},
                             {"sinceLast", listed.sinceLast ? sinceLastJson(*listed.sinceLast) : Json()},
                             {"verdict", test.verdict ? Json(fileWord(*test.verdict)) : Json()}});
}

QByteArray listedTestsCsvHead(char decimalMark) {
    QStringList head = summaryHead(SummaryForm::csv, Language(Language::Id::english));
    for (const char *name : {"due", "certificateDue", "lastDate", "sinceLast", "difference", "differenceU"})
        head << QString::fromLatin1(name);
    return summaryCsv({head}, decimalMark);
}

QByteArray listedTestCsv(const ListedTest &listed, char decimalMark) {
    const RegisteredTest &test = listed.test;
    const QStringList head =
        summaryCells(identified(listed), SummaryForm::csv, Language(Language::Id::english));
    const QStringList tail{QString::fromLatin1(fileWord(test.accordance)),
                           QString::fromStdString(listed.due.value_or("")),
                           QString::fromStdString(listed.certificateDue.value_or(""))};
    const auto cell = [](std::optional<double> number) {
        return number ? QString::fromStdString(shortest(*number)) : QString();
    };
    const auto changes = [&](const std::string &result) -> QStringList {
        if (!listed.sinceLast)
            return {{}, {}, {}, {}};
        const ComparedParameter *change = changeOf(*listed.sinceLast, result);
        return {QString::fromStdString(listed.sinceLast->date.value_or("")),
                change && change->word ? QString::fromLatin1(fileWord(*change->word)) : QString(),
                change ? cell(change->difference) : QString(),
                change ? cell(change->uncertainty) : QString()};
    };
    std::vector<QStringList> rows;
    for (const RegisteredResult &result : test.results)
        rows.push_back(head +
                       QStringList{QString::fromStdString(result.id), cell(result.value),
                                   cell(result.expandedUncertainty), cell(result.limit),
                                   QString::fromLatin1(unitOf(test)),
                                   QString::fromLatin1(limitsWord(result.verdict))} +
                       tail + changes(result.id));
    if (rows.empty())
        rows.push_back(head + QStringList(6, QString()) + tail + changes({}));
    return summaryCsv(rows, decimalMark);
}

QString joinedText(const ListedMachine &machine, const Language &language) {
    QStringList marks;
    for (const MachineFields &joined : machine.joined)
        marks << markOf(joined);
    return language.sentence(
        {REPORT_TEXT("report", "joined with %1"), {marks.join(QStringLiteral(", ")).toStdString()}});
}

QStringList statedOf(const MachineFields &machine) {
    QStringList parts{titleOf(machine), machine.manufacturer, machine.model, machine.serialNumber};
    parts.removeAll(QString());
    parts.removeDuplicates();
    return parts;
}

QString evidenceOf(const ListedMachine &machine, const Language &language) {
    QStringList parts = statedOf(machine);
    if (!machine.isIdentified)
        parts << language.text(REPORT_TEXT("report", "not identified: no serial number"));
    if (!machine.joined.empty())
        parts << joinedText(machine, language);
    return QString::number(machine.number) + QStringLiteral(". ") + parts.join(QStringLiteral(" · "));
}

ShownValue shownResult(const RegisteredResult &result, bool angular, const Language &language) {
    const Quantity quantity = angular ? Quantity::angularDeviation : Quantity::deviation;
    if (!result.value)
        return {QStringLiteral("–"), {}};
    const int usual = result.expandedUncertainty
                          ? decimalsWithUncertainty(*result.expandedUncertainty, quantity)
                          : decimalsWithoutUncertainty;
    return {language.number(*result.value, quantity, result.decimals.value_or(usual)),
            result.expandedUncertainty ? language.uncertainty(*result.expandedUncertainty, quantity,
                                                              result.uncertaintyDecimals.value_or(usual))
                                       : QString()};
}

QString plainSymbolOf(const std::string &resultId) {
    for (const Edition *edition : editions()) {
        for (const Row &row : edition->rows) {
            if (resultId == row.term.id)
                return QString::fromUtf8(row.term.symbol.base) +
                       QString::fromUtf8(row.term.symbol.subscript) +
                       QString::fromUtf8(row.term.symbol.arrow);
        }
    }
    return QString::fromStdString(resultId).remove(u'_');
}

Report composeList(const QString &title, const std::vector<ListedTest> &tests, const Language &language) {
    Report report;
    report.language = language.code();
    report.title = title;
    report.blocks.emplace_back(Heading{2, title});
    Table table;
    for (const Text &head :
         {REPORT_TEXT("report", "Date"), REPORT_TEXT("report", "Axis"), REPORT_TEXT("report", "Edition"),
          REPORT_TEXT("report", "Purpose"), REPORT_TEXT("report", "Role"),
          REPORT_TEXT("report", "Report No."), REPORT_TEXT("report", "Working zone"),
          REPORT_TEXT("report", "Results"), REPORT_TEXT("report", "Limits"), REPORT_TEXT("report", "Test"),
          REPORT_TEXT("report", "Against the last"), REPORT_TEXT("report", "Due")})
        table.columns.push_back({language.text(head)});
    constexpr std::size_t resultColumn = 7;
    table.columns[resultColumn].flexible = true;
    for (const ListedTest &listed : tests) {
        const RegisteredTest &test = listed.test;
        QStringList results;
        const Quantity quantity = test.angular ? Quantity::angularDeviation : Quantity::deviation;
        for (const std::string &id : mainParametersOf({listed})) {
            if (const RegisteredResult *found = resultOf(test, id))
                results << plainSymbolOf(id) + QChar(QChar::Nbsp) +
                               shownResult(*found, test.angular, language).text() + QChar(QChar::Nbsp) +
                               language.unit(quantity);
        }
        const QStringList cells = summaryCells(identified(listed), SummaryForm::text, language);
        std::vector<Cell> row;
        for (const int column : {8, 7, 9, 10, 11, 6, 12}) // those that the title does not say
            row.emplace_back(cells[column]);
        row.emplace_back(results.join(language.semicolon()));
        row.emplace_back(language.text(limitsText(test.verdict, hasLimit(test))));
        row.emplace_back(traitsOf(test.kind).isJudged
                             ? summaryAccordance(test.accordance, SummaryForm::text, language)
                             : QString());
        row.emplace_back(listed.sinceLast ? sinceLastWord(*listed.sinceLast, language) : QString());
        row.emplace_back(dueText(listed, language));
        table.rows.push_back(std::move(row));
    }
    leaveOutEmptyColumns(table, 0, table.columns.size() - 1);
    report.blocks.emplace_back(std::move(table));
    return report;
}

} // namespace palmer
