// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/listing.h"

#include "document/filewords.h"
#include "document/resultwords.h"
#include "kernel/measurement/testfacts.h"
#include "language/csvwriter.h"
#include "language/rounding.h"
#include "register/jsonline.h"
#include "register/machinetrend.h"
#include "report/words/accordancetext.h"
#include "report/words/wording.h"

#include <algorithm>
#include <cmath>

namespace palmer {

namespace {

Json verdictOrNull(std::optional<Verdict> verdict) {
    return verdict ? Json(fileWord(*verdict)) : Json();
}

const char *unitOf(const RegisteredTest &test) {
    return test.angular ? "deg" : "mm";
}

Json resultJson(const RegisteredResult &result, const RegisteredTest &test) {
    return {{"id", result.id},
            {"value", orNull(result.value)},
            {"unit", unitOf(test)},
            {"expandedUncertainty", orNull(result.expandedUncertainty)},
            {"k", orNull(result.k)},
            {"limit", orNull(result.limit)},
            {"guardBand", orNull(result.guardBand)},
            {"verdict", verdictOrNull(result.verdict)}};
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

QString fileOf(const ListedTest &listed) {
    return listed.places.empty() ? QString() : listed.places.front().path;
}

} // namespace

QByteArray listedTestJson(const ListedTest &listed) {
    const RegisteredTest &test = listed.test;
    Json places = Json::array();
    for (const TestPlace &place : listed.places)
        places.push_back(
            {{"file", place.path.toStdString()}, {"test", place.test}, {"state", place.state.toStdString()}});
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
    return jsonLine({{"file", fileOf(listed).toStdString()},
                     {"test", listed.places.empty() ? 1 : listed.places.front().test},
                     {"places", places},
                     {"machine", machineJson(test)},
                     {"title", test.title},
                     {"kind", fileWord(test.kind)},
                     {"id", test.id},
                     {"axis", orNull(ofAxis ? test.axis : none)},
                     {"plane", orNull(ofAxis ? none : test.axis)},
                     {"date", orNull(test.date)},
                     {"time", orNull(test.time)},
                     {"edition", orNull(test.edition)},
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
                     {"verdict", verdictOrNull(test.verdict)}});
}

QByteArray listedTestsCsvHead() {
    CsvWriter csv('.');
    csv.row("file", "test", "machine", "manufacturer", "model", "serialNumber", "axis", "date", "edition",
            "purpose", "role", "parameter", "value", "U", "limit", "unit", "limits", "accordance");
    return csv.bytes();
}

QByteArray listedTestCsv(const ListedTest &listed) {
    const RegisteredTest &test = listed.test;
    CsvWriter csv('.');
    const auto head = [&] {
        csv.cells(fileOf(listed).toStdString(), listed.places.empty() ? 1 : listed.places.front().test,
                  test.machineName, test.manufacturer, test.model, test.serialNumber, test.axis,
                  test.date.value_or(""), test.edition, fileWord(test.purpose), fileWord(test.role));
    };
    for (const RegisteredResult &result : test.results) {
        head();
        csv.row(result.id, result.value, result.expandedUncertainty, result.limit, unitOf(test),
                limitsWord(result.verdict), fileWord(test.accordance));
    }
    if (test.results.empty()) {
        head();
        csv.row("", "", "", "", "", "", fileWord(test.accordance));
    }
    return csv.bytes();
}

ShownResult shownResult(const RegisteredResult &result, bool angular, const Language &language) {
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
          REPORT_TEXT("report", "Purpose"), REPORT_TEXT("report", "Role"), REPORT_TEXT("report", "Results"),
          REPORT_TEXT("report", "Limits"), REPORT_TEXT("report", "Test")})
        table.columns.push_back({language.text(head)});
    table.columns[5].flexible = true;
    for (const ListedTest &listed : tests) {
        const RegisteredTest &test = listed.test;
        QStringList results;
        for (const std::string &id : mainParametersOf({listed})) {
            const auto found = std::ranges::find(test.results, id, &RegisteredResult::id);
            if (found == test.results.end())
                continue;
            results << plainSymbolOf(id) + QChar(QChar::Nbsp) +
                           shownResult(*found, test.angular, language).text();
        }
        const auto said = [&](const Text &text) { return text.empty() ? QString() : language.text(text); };
        table.rows.push_back(
            {Cell(test.date ? language.shortDate(*test.date) : QString()),
             Cell(QString::fromStdString(test.axis)), Cell(QString::fromStdString(test.edition)),
             Cell(said(purposeText(test.purpose))), Cell(said(roleText(test.role))),
             Cell(results.join(QStringLiteral("; "))),
             Cell(language.text(limitsText(test.verdict, hasLimit(test)))),
             Cell(traitsOf(test.kind).isJudged ? language.text(accordanceWords(test.accordance))
                                               : QString())});
    }
    report.blocks.emplace_back(std::move(table));
    return report;
}

} // namespace palmer
