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
#include "register/scan.h"
#include "register/storedsentence.h"
#include "register/typeoutput.h"
#include "report/blocks/plaintext.h"

#include <QBuffer>
#include <QFileInfo>
#include <QTemporaryDir>
#include <algorithm>
#include <optional>
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

/// A register of the files of the call, in a folder of its own, otherwise the one asked for.
class TypeSource {
public:
    explicit TypeSource(const Invocation &invocation) {
        const QStringList files = invocation.arguments.mid(1);
        if (files.isEmpty()) {
            m_register.emplace(registerAddress(invocation), Register::Open::read);
            return;
        }
        if (invocation.has("register"))
            throw UsageError(
                {REPORT_TEXT("report", "files and --%1 do not go together"), {std::string("register")}});
        m_register.emplace(m_folder.filePath(QStringLiteral("register.sqlite")));
        for (const Unreadable &one : scan(*m_register, files).unreadable) {
            printError(one.path + QStringLiteral(": ") + sentenceFrom(one.error, invocation.language));
            m_code = cannotRead;
        }
    }

    [[nodiscard]] Database &database() { return m_register->database(); }
    [[nodiscard]] int code() const { return m_code; } ///< cannotRead: a file was left out

private:
    QTemporaryDir m_folder; ///< outlives the register in it
    std::optional<Register> m_register;
    int m_code = done;
};

/// The type asked for, otherwise that of all machines of the files.
QString typeAsked(const Invocation &invocation, const std::vector<ListedMachine> &all) {
    if (invocation.arguments.size() == 1 || invocation.has("type"))
        return neededOption(invocation, "type");
    std::set<QString> types;
    for (const ListedMachine &machine : all)
        types.insert(asCompared(machine.manufacturer + u' ' + machine.model));
    if (types.size() != 1)
        throw UsageError(
            {REPORT_TEXT("report", "the machines of the files are not all of one type; choose it "
                                   "with --type"),
             {}});
    if (all.front().model.isEmpty())
        throw UsageError(
            {REPORT_TEXT("report", "the files do not state the model of the machines; choose the "
                                   "type with --type"),
             {}});
    return all.front().manufacturer + u' ' + all.front().model;
}

using AxisParameter = std::pair<std::string, std::string>; ///< axis or plane, parameter

/// `asked`: a parameter, or the quantity of several.
std::set<AxisParameter> pairsIn(const std::vector<ListedTest> &list, const std::string &asked) {
    std::set<AxisParameter> pairs;
    for (const ListedTest &one : list) {
        for (const RegisteredResult &result : one.test.results) {
            if (result.value && (result.id == asked || quantityOf(result.id) == asked))
                pairs.emplace(one.test.axis, result.id);
        }
    }
    return pairs;
}

/// `ending`: pdf, svg or png.
QByteArray drawnAs(const QString &ending, const TypeTest &test, const Language &language) {
    const Report report = composeTypeTest(test, language, ending == QLatin1StringView("pdf"));
    if (ending == QLatin1StringView("svg"))
        return figureAsSvg(typeFigure(test, language), report.title, language);
    if (ending == QLatin1StringView("png"))
        return figureAsPng(typeFigure(test, language));
    QByteArray bytes;
    QBuffer pdf(&bytes);
    pdf.open(QIODevice::WriteOnly);
    writePdf(report, pdf);
    return bytes;
}

} // namespace

int runRegisterType(const Invocation &invocation) {
    if (invocation.arguments.size() == 1)
        (void)neededOption(invocation, "type");
    const std::string asked = neededOption(invocation, "parameter").toStdString();
    const Tolerance tolerance{shareAsked(invocation, "content", Tolerance().content),
                              shareAsked(invocation, "confidence", Tolerance().confidence)};
    const TypeDistribution distribution = distributionAsked(invocation);
    const Edition *edition = editionAsked(invocation);
    TypeSource source(invocation);
    const std::vector<ListedMachine> all = machines(source.database());
    if (all.empty() && source.code() != done)
        return source.code();
    const QString words = typeAsked(invocation, all);
    const std::vector<ListedMachine> chosen = machinesAsked(all, words);
    TestFilter filter;
    for (const ListedMachine &machine : chosen)
        filter.machines.push_back(machine.id);
    filter.axis = invocation.value("axis").value_or(QString());
    std::vector<ListedTest> list = tests(source.database(), filter);
    int code = source.code();
    if (edition) {
        for (const Unreadable &one : reevaluate(list, *edition)) {
            printError(one.path + QStringLiteral(": ") + sentenceFrom(one.error, invocation.language));
            code = cannotRead;
        }
    }
    const std::set<AxisParameter> pairs = pairsIn(list, asked);
    if (pairs.empty())
        throw UsageError({REPORT_TEXT("report", "the machines of the type “%1” have no test with %2"),
                          {words.toStdString(), asked}});
    const QString output = invocation.value("o").value_or(QString());
    const QString ending = QFileInfo(output).suffix().toLower();
    const bool drawn =
        QStringList{QStringLiteral("pdf"), QStringLiteral("svg"), QStringLiteral("png")}.contains(ending);
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
        if (drawn)
            bytes = drawnAs(ending, test, invocation.language);
        else if (invocation.has("json") || ending == QLatin1StringView("json"))
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
