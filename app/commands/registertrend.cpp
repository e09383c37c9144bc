// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/registertrend.h"

#include "commandline/optionvalues.h"
#include "commandline/outputfile.h"
#include "commandline/streams.h"
#include "print/figures/exportfigure.h"
#include "print/pdf/writepdf.h"
#include "register/history.h"
#include "register/listing.h"
#include "register/queries.h"
#include "register/reevaluate.h"
#include "register/register.h"
#include "register/sincelast.h"
#include "register/storedsentence.h"
#include "register/trendfigure.h"
#include "register/trendoutput.h"
#include "report/blocks/plaintext.h"

#include <QBuffer>
#include <QDate>
#include <QFileInfo>
#include <algorithm>

namespace palmer {

namespace {

std::vector<std::string> parametersAsked(const Invocation &invocation, const std::vector<ListedTest> &list) {
    const QStringList asked = invocation.values("parameter");
    if (asked.isEmpty())
        return mainParametersOf(list);
    const std::vector<std::string> known = parametersOf(list);
    std::vector<std::string> result;
    for (const QString &one : asked) {
        const std::string id = one.toStdString();
        const auto found = std::ranges::find_if(
            known, [&](const std::string &name) { return name == id || quantityOf(name) == id; });
        if (found == known.end()) {
            std::string all;
            for (const std::string &name : known)
                all += (all.empty() ? "" : ", ") + name;
            throw all.empty()
                ? UsageError({REPORT_TEXT("report", "unknown parameter %1: the tests have none"), {id}})
                : UsageError(
                      {REPORT_TEXT("report", "these tests have no parameter %1; they have: %2"), {id, all}});
        }
        result.push_back(*found);
    }
    return result;
}

enum class Form { text, csv, json, svg, png, pdf };

Form formOf(const Invocation &invocation, const QString &output) {
    const QString ending = QFileInfo(output).suffix().toLower();
    if (ending == QLatin1StringView("csv"))
        return Form::csv;
    for (const auto &[word, form] :
         {std::pair("svg", Form::svg), std::pair("png", Form::png), std::pair("pdf", Form::pdf)}) {
        if (ending == QLatin1StringView(word))
            return form;
    }
    if (ending == QLatin1StringView("json") || invocation.has("json"))
        return Form::json;
    if (!output.isEmpty() && output != QLatin1StringView("-"))
        refuseWithoutOutput("register trend", "-o OUT.csv|json|svg|png|pdf");
    return Form::text;
}

QByteArray picture(const ListedMachine &machine, const std::string &axis, const MachineTrend &trend,
                   Form form, const Language &language) {
    const QString title = composeTrend(machine, axis, trend, language).title;
    const TrendFigure figure = trendFigure(title, trend, QDate::currentDate(), language);
    if (form == Form::svg)
        return figureAsSvg(figure, title, language);
    return form == Form::png ? figureAsPng(figure) : figureAsPdf(figure, title);
}

/// Languages of --language, otherwise the language of the command.
QStringList reportLanguages(const Invocation &invocation) {
    const auto chosen = invocation.value("language");
    QStringList result = chosen ? chosen->split(u',') : QStringList{invocation.language.code()};
    result.removeDuplicates();
    return result;
}

constexpr qsizetype longestNumber = 40; ///< fits in the head of the page

} // namespace

QString neededOption(const Invocation &invocation, const char *option) {
    const auto given = invocation.value(option);
    if (!given || given->isEmpty())
        throw UsageError({REPORT_TEXT("report", "this part of register needs --%1"), {std::string(option)}});
    return *given;
}

ListedMachine machineCalled(Database &database, const QString &words, const Language &language) {
    const std::vector<ListedMachine> found = machinesCalled(database, words);
    if (found.empty())
        throw UsageError(
            {REPORT_TEXT("report", "no machine of the register is called “%1”"), {words.toStdString()}});
    if (found.size() == 1)
        return found.front();
    constexpr std::size_t most = 5;
    std::string names;
    for (std::size_t i = 0; i < std::min(found.size(), most); ++i)
        names += (i == 0 ? "" : "; ") + evidenceOf(found[i], language).toStdString();
    if (found.size() > most)
        names += "; …";
    throw UsageError(
        {REPORT_TEXT("report", "%1 machines may be meant by “%2”: %3; say the number before its name"),
         {Number{static_cast<double>(found.size()), Quantity::count}, words.toStdString(), names}});
}

int runRegisterReport(const Invocation &invocation) {
    const QString words = neededOption(invocation, "machine");
    const QString output = neededOutput(invocation, "register report", "-o OUT.pdf");
    requireOutput(invocation, output, {"pdf"});
    const QStringList languages = reportLanguages(invocation);
    if (output == QLatin1StringView("-") && languages.size() > 1)
        throw UsageError({REPORT_TEXT("report", "standard output takes one report; choose --language"), {}});
    Register reg(registerAddress(invocation), Register::Open::read);
    const ListedMachine machine = machineCalled(reg.database(), words, invocation.language);
    History history =
        historyOf(reg.database(), machine, QDate::currentDate(), QStringLiteral("Palmer " PALMER_VERSION));
    if (const auto number = invocation.value("number")) {
        if (number->size() > longestNumber)
            throw UsageError({REPORT_TEXT("report", "the number of a history has at most %1 characters"),
                              {Number{static_cast<double>(longestNumber), Quantity::count}}});
        history.number = number->simplified();
    }
    std::vector<FileToSave> files;
    for (const QString &name : languages) {
        const auto language = Language::fromName(name);
        QBuffer pdf;
        pdf.open(QIODevice::WriteOnly);
        writePdf(composeHistory(history, *language), pdf);
        files.push_back({pdf.data(), languages.size() > 1 ? withLanguage(output, name) : output});
    }
    for (const FileToSave &file : files)
        requireOutput(invocation, file.path, {"pdf"});
    writeOutputs(files);
    return done;
}

int runRegisterTrend(const Invocation &invocation) {
    const QString words = neededOption(invocation, "machine");
    TestFilter filter;
    filter.axis = neededOption(invocation, "axis");
    const QString output = invocation.value("o").value_or(QString());
    const Form form = formOf(invocation, output);
    if (!output.isEmpty())
        requireOutput(invocation, output, {"csv", "json", "svg", "png", "pdf"});
    const Edition *edition = editionAsked(invocation);
    if (edition && invocation.has("since-last"))
        throw UsageError({REPORT_TEXT("report", "--%1 and --%2 do not go together"),
                          {std::string("since-last"), std::string("edition")}});
    Register reg(registerAddress(invocation), Register::Open::read);
    const ListedMachine machine = machineCalled(reg.database(), words, invocation.language);
    filter.machines = {machine.id};
    std::vector<ListedTest> list = tests(reg.database(), filter);
    if (list.empty())
        throw UsageError(
            {REPORT_TEXT("report", "the machine has no test of %1"), {filter.axis.toStdString()}});
    int code = done;
    if (edition) {
        for (const Unreadable &one : reevaluate(list, *edition)) {
            printError(one.path + QStringLiteral(": ") + sentenceFrom(one.error, invocation.language));
            code = cannotRead;
        }
    }
    if (invocation.has("since-last"))
        findChanges(list);
    const std::string axis = list.back().test.axis;
    std::vector<MachineTrend> trends;
    for (const std::string &parameter : parametersAsked(invocation, list))
        trends.push_back(machineTrend(list, parameter));
    const bool drawn = form == Form::svg || form == Form::png || form == Form::pdf;
    if (drawn && trends.size() != 1)
        throw UsageError(
            {REPORT_TEXT("report", "a picture shows one parameter: choose it with --parameter"), {}});
    QByteArray bytes;
    if (form == Form::csv)
        bytes = trendCsv(machine, axis, trends);
    else if (drawn)
        bytes = picture(machine, axis, trends.front(), form, invocation.language);
    for (const MachineTrend &trend : trends) {
        if (form == Form::json)
            bytes += trendJson(machine, axis, trend);
        else if (form == Form::text)
            bytes += (bytes.isEmpty() ? "" : "\n") +
                     plainText(composeTrend(machine, axis, trend, invocation.language)).toUtf8();
    }
    if (output.isEmpty())
        printOut(bytes);
    else
        writeOutput(bytes, output);
    return code;
}

} // namespace palmer
