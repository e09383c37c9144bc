// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commandline/optionvalues.h"
#include "commandline/outputfile.h"
#include "commandline/streams.h"
#include "commands/registertrend.h"
#include "print/figures/exportfigure.h"
#include "print/pdf/writepdf.h"
#include "register/reevaluate.h"
#include "register/register.h"
#include "register/storedsentence.h"
#include "register/typeoutput.h"
#include "report/blocks/plaintext.h"

#include <QBuffer>
#include <QFileInfo>
#include <algorithm>
#include <set>

namespace palmer {

namespace {

TypeDistribution distributionAsked(const Invocation &invocation) {
    const QString word = invocation.value("distribution").value_or(QStringLiteral("logNormal"));
    if (word != QLatin1StringView("logNormal") && word != QLatin1StringView("normal"))
        refuse("distribution", word, "logNormal, normal");
    return word == QLatin1StringView("normal") ? TypeDistribution::normal : TypeDistribution::logNormal;
}

double shareAsked(const Invocation &invocation, const char *option, double usual) {
    constexpr double least = 0.5;
    constexpr double most = 0.999;
    const auto given = invocation.value(option);
    return given ? numberBetween(option, *given, least, most) : usual;
}

std::vector<ListedMachine> machinesAsked(const std::vector<ListedMachine> &all, const QString &words) {
    std::vector<ListedMachine> found = machinesOfType(all, words);
    if (found.empty())
        throw UsageError(
            {REPORT_TEXT("report", "no machine of the register is of the type “%1”"), {words.toStdString()}});
    std::set<QString> makers;
    for (const ListedMachine &machine : found)
        makers.insert(asCompared(machine.manufacturer));
    if (makers.size() > 1)
        throw UsageError({REPORT_TEXT("report", "several makers have the type “%1”; say “%2 %1”"),
                          {words.toStdString(), found.front().manufacturer.toStdString()}});
    return found;
}

} // namespace

int runRegisterType(const Invocation &invocation) {
    const QString words = neededOption(invocation, "type");
    const std::string asked = neededOption(invocation, "parameter").toStdString();
    const Tolerance tolerance{shareAsked(invocation, "content", Tolerance().content),
                              shareAsked(invocation, "confidence", Tolerance().confidence)};
    const TypeDistribution distribution = distributionAsked(invocation);
    const Edition *edition = editionAsked(invocation);
    Register reg(registerAddress(invocation), Register::Open::read);
    const std::vector<ListedMachine> chosen = machinesAsked(machines(reg.database()), words);
    TestFilter filter;
    for (const ListedMachine &machine : chosen)
        filter.machines.push_back(machine.id);
    filter.axis = invocation.value("axis").value_or(QString());
    std::vector<ListedTest> list = tests(reg.database(), filter);
    int code = done;
    if (edition) {
        for (const Unreadable &one : reevaluate(list, *edition)) {
            printError(one.path + QStringLiteral(": ") + sentenceFrom(one.error, invocation.language));
            code = cannotRead;
        }
    }
    std::set<std::pair<std::string, std::string>> pairs; // axis or plane, parameter
    for (const ListedTest &one : list) {
        for (const RegisteredResult &result : one.test.results) {
            if (result.value && (result.id == asked || quantityOf(result.id) == asked))
                pairs.emplace(one.test.axis, result.id);
        }
    }
    if (pairs.empty())
        throw UsageError({REPORT_TEXT("report", "the machines of the type “%1” have no test with %2"),
                          {words.toStdString(), asked}});
    const QString output = invocation.value("o").value_or(QString());
    const QString ending = QFileInfo(output).suffix().toLower();
    const bool onPaper = ending == QLatin1StringView("pdf");
    const bool drawn = onPaper || ending == QLatin1StringView("svg") || ending == QLatin1StringView("png");
    if (!output.isEmpty())
        requireOutput(invocation, output, {"json", "svg", "png", "pdf"});
    if (drawn && pairs.size() != 1)
        throw UsageError({REPORT_TEXT("report", "a picture shows one parameter of one axis: choose it with "
                                                "--parameter and --axis"),
                          {}});
    QByteArray bytes;
    for (const auto &[axis, parameter] : pairs) {
        if (!hasTypeTest(parameter))
            throw UsageError(
                {REPORT_TEXT("report", "%1 has a sign: a type test takes parameters without one"),
                 {parameter}});
        const TypeTest test = typeTest(chosen, list, axis, parameter, tolerance, distribution);
        if (onPaper) {
            QBuffer pdf(&bytes);
            pdf.open(QIODevice::WriteOnly);
            writePdf(composeTypeTest(test, invocation.language, true), pdf);
        } else if (drawn) {
            const Figure figure = typeFigure(test, invocation.language);
            const QString title = composeTypeTest(test, invocation.language).title;
            bytes = ending == QLatin1StringView("svg") ? figureAsSvg(figure, title, invocation.language)
                                                       : figureAsPng(figure);
        } else if (invocation.has("json") || ending == QLatin1StringView("json"))
            bytes += typeTestJson(test);
        else
            bytes += (bytes.isEmpty() ? "" : "\n") +
                     plainText(composeTypeTest(test, invocation.language)).toUtf8();
    }
    if (output.isEmpty())
        printOut(bytes);
    else
        writeOutput(bytes, output);
    return code;
}

} // namespace palmer
