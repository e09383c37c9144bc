// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/listing.h"

#include "document/filewords.h"
#include "document/jsonprinter.h"
#include "document/resultwords.h"
#include "kernel/measurement/testfacts.h"
#include "language/csvwriter.h"
#include "language/rounding.h"
#include "register/jsonmembers.h"
#include "register/machinetrend.h"
#include "report/words/accordancetext.h"
#include "report/words/wording.h"

#include <algorithm>
#include <cmath>

namespace palmer {

namespace {

Members verdictMember(Members members, std::optional<Verdict> verdict) {
    if (verdict)
        members.quoted("verdict", fileWord(*verdict));
    else
        members.word("verdict", "null");
    return members;
}

const char *unitOf(const RegisteredTest &test) {
    return test.angular ? "deg" : "mm";
}

Members resultMembers(const RegisteredResult &result, const RegisteredTest &test) {
    Members members;
    members.text("id", result.id)
        .number("value", result.value)
        .quoted("unit", unitOf(test))
        .number("expandedUncertainty", result.expandedUncertainty)
        .number("k", result.k)
        .number("limit", result.limit)
        .number("guardBand", result.guardBand);
    return verdictMember(std::move(members), result.verdict);
}

Members machineMembers(const RegisteredTest &test) {
    Members members;
    members.textOrNull("name", test.machineName)
        .textOrNull("manufacturer", test.manufacturer)
        .textOrNull("model", test.model)
        .textOrNull("serialNumber", test.serialNumber)
        .textOrNull("location", test.location);
    return members;
}

const char *inAccordance(Accordance accordance) {
    return accordance == Accordance::yes ? "true" : accordance == Accordance::no ? "false" : "null";
}

QString fileOf(const ListedTest &listed) {
    return listed.places.empty() ? QString() : listed.places.front().path;
}

} // namespace

QByteArray listedTestJson(const ListedTest &listed) {
    const RegisteredTest &test = listed.test;
    std::vector<std::string> paths; // borrowed by the members
    for (const TestPlace &place : listed.places)
        paths.push_back(place.path.toStdString());
    std::vector<std::string> states;
    for (const TestPlace &place : listed.places)
        states.push_back(place.state.toStdString());
    std::vector<Members> places;
    for (std::size_t i = 0; i < listed.places.size(); ++i) {
        Members place;
        place.text("file", paths[i]).whole("test", listed.places[i].test).text("state", states[i]);
        places.push_back(std::move(place));
    }
    std::vector<Members> instruments;
    for (const RegisteredInstrument &instrument : test.instruments) {
        Members one;
        one.textOrNull("description", instrument.description)
            .textOrNull("serialNumber", instrument.serialNumber)
            .textOrNull("certificate", instrument.certificate)
            .textOrNull("calibrationDue", instrument.due);
        instruments.push_back(std::move(one));
    }
    std::vector<Members> results;
    for (const RegisteredResult &result : test.results)
        results.push_back(resultMembers(result, test));
    const bool ofAxis = traitsOf(test.kind).isOfAxis;
    const std::string none;
    Members members;
    members.text("file", paths.empty() ? none : paths.front())
        .whole("test", listed.places.empty() ? 1 : listed.places.front().test)
        .list("places", std::move(places))
        .object("machine", machineMembers(test))
        .text("title", test.title)
        .quoted("kind", fileWord(test.kind))
        .text("id", test.id)
        .textOrNull("axis", ofAxis ? test.axis : none)
        .textOrNull("plane", ofAxis ? none : test.axis)
        .textOrNull("date", test.date)
        .textOrNull("time", test.time)
        .textOrNull("edition", test.edition)
        .number("feed", test.feed)
        .number("travel", test.travel)
        .quoted("accordance", fileWord(test.accordance))
        .word("inAccordance", inAccordance(test.accordance))
        .whole("unmet", test.counts.unmet)
        .whole("undeclared", test.counts.undeclared)
        .whole("departures", test.counts.departures)
        .quoted("role", fileWord(test.role))
        .quoted("purpose", fileWord(test.purpose))
        .quoted("limits", limitsWord(test.verdict))
        .quoted("correctionTo20", fileWord(test.correction))
        .quoted("decisionRule", fileWord(test.rule))
        .list("parameters", std::move(results))
        .list("instruments", std::move(instruments))
        .textOrNull("due", listed.due)
        .textOrNull("certificateDue", listed.certificateDue);
    members = verdictMember(std::move(members), test.verdict);
    return members.line();
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
