// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/commands.h"

#include "commandline/optionvalues.h"
#include "commandline/outputfile.h"
#include "commandline/simulations.h"
#include "commandline/streams.h"
#include "document/plannedtest.h"
#include "document/savedocument.h"
#include "export/controls.h"
#include "export/dcc.h"
#include "export/resultsjson.h"
#include "kernel/evaluation/evaluatetest.h"
#include "kernel/evaluation/surroundings.h"
#include "report/planreport.h"
#include "system/filename.h"

#include <array>

namespace palmer {

namespace {

constexpr const char *tables = "as=linuxcnc|as=siemens|as=weihong|as=compensation-csv";
constexpr const char *notJson = "as=csv|as=linuxcnc|as=siemens|as=weihong|as=compensation-csv|as=program";

constexpr auto exportOptions = optionList(
    Option{"as", "csv|json|dcc|linuxcnc|siemens|weihong|compensation-csv|program",
           REPORT_TEXT("report", "what to write: readings and results, a digital calibration certificate, a "
                                 "compensation table, or the part program of the test's own targets")},
    Option{"dialect", "iso|siemens|heidenhain|linuxcnc|haas",
           REPORT_TEXT("report", "program: without it that of the machine's control"), false, "as=program"},
    Option{"o", "OUT", REPORT_TEXT("report", "the file to write")},
    Option{"test", "N", REPORT_TEXT("report", "which test of the file, from 1; without it the first"), false,
           notJson},
    Option{"decimal-mark", "point|comma", REPORT_TEXT("report", "of CSV; without it the point"), false,
           "as=csv|as=compensation-csv"},
    Option{"from", "P",
           REPORT_TEXT("report", "first position of the compensation; without it the first target"), false,
           tables},
    Option{"to", "P", REPORT_TEXT("report", "last position of the compensation; without it the last target"),
           false, tables},
    Option{"interval", "D", REPORT_TEXT("report", "interval of the compensation; without it the targets"),
           false, tables},
    Option{"per-direction", "",
           REPORT_TEXT("report", "compensation of each direction; without it of their mean"), false, tables},
    Option{"incremental", "",
           REPORT_TEXT("report", "compensation-csv: each value is the step from the one before"), false,
           "as=compensation-csv"},
    Option{"deviations", "",
           REPORT_TEXT("report",
                       "compensation-csv, weihong: values with the sign of the deviations; without it "
                       "corrections, added to the command"),
           false, "as=compensation-csv|as=weihong"},
    Option{"confirm-sign", "",
           REPORT_TEXT("report", "the deviations are actual − target, though the file they come from does "
                                 "not say it"),
           false, tables},
    Option{"reference", "P",
           REPORT_TEXT("report", "siemens: the reference point of the axis, where the values are 0; owed"),
           false, "as=siemens"},
    Option{"encoder", "0|1",
           REPORT_TEXT("report", "siemens: index of the measuring system; without it 0, the first"), false,
           "as=siemens"},
    Option{"compare", "FILE",
           REPORT_TEXT("report", "a compensation table of a control, to compare with the one written"), false,
           tables, false, itself},
    foreignOptions, forceOption);

std::optional<CompensationFormat> compensationFormat(const QString &word) {
    if (word == QLatin1StringView("linuxcnc"))
        return CompensationFormat::linuxcnc;
    if (word == QLatin1StringView("siemens"))
        return CompensationFormat::siemens;
    if (word == QLatin1StringView("weihong"))
        return CompensationFormat::weihong;
    if (word == QLatin1StringView("compensation-csv"))
        return CompensationFormat::csv;
    return {};
}

char decimalMark(const Invocation &invocation) {
    return invocation.value("decimal-mark") == QLatin1StringView("comma") ? ',' : '.';
}

int encoder(const Invocation &invocation) {
    return invocation.value("encoder").value_or(QStringLiteral("0")).toInt();
}

void requireEnding(const Invocation &invocation, const QString &output, const QString &form) {
    if (form == QLatin1StringView("json"))
        requireOutput(invocation, output, {"json"});
    else if (form == QLatin1StringView("dcc"))
        requireOutput(invocation, output, {"xml"});
    else if (form == QLatin1StringView("linuxcnc"))
        requireOutput(invocation, output, {"comp", "txt"});
    else if (form == QLatin1StringView("siemens"))
        requireOutput(invocation, output, {"mpf", "spf", "ini", "txt"});
    else if (form == QLatin1StringView("weihong"))
        requireOutput(invocation, output, {"dat", "txt"});
    else if (form == QLatin1StringView("program"))
        requireOutput(invocation, output, programEndings);
    else
        requireOutput(invocation, output, {"csv", "tsv", "txt"});
}

CompensationOptions compensationOptions(const Invocation &invocation) {
    CompensationOptions result;
    result.from = numberOf(invocation, "from");
    result.to = numberOf(invocation, "to");
    result.interval = numberOf(invocation, "interval");
    result.perDirection = invocation.has("per-direction");
    result.incremental = invocation.has("incremental");
    result.deviations = invocation.has("deviations");
    result.signConfirmed = invocation.has("confirm-sign");
    result.decimalMark = decimalMark(invocation);
    result.reference = numberOf(invocation, "reference");
    result.encoder = encoder(invocation);
    return result;
}

/// A test with its evaluation and document.
struct TestToCompensate {
    const Test &test;
    const TestEvaluation &evaluation;
    const Document &document;
};

/// Prints E, M, B and other parameters of the edition before and after.
void printPrediction(const Message &head, const TestToCompensate &of, const CompensationTable &table,
                     const Language &language) {
    Surroundings surroundings;
    surroundings.machine = &of.document.machine;
    const std::vector<Parameter> &measured = of.evaluation.parameters;
    const TestEvaluation predicted = evaluateTest(compensated(of.test, table), surroundings);
    printError(language.sentence(head));
    for (std::size_t i = 0; i < std::min(measured.size(), predicted.parameters.size()); ++i) {
        const Parameter &parameter = measured[i];
        const auto &value = predicted.parameters[i].value;
        if (parameter.value && value)
            printError(language.sentence(
                {REPORT_TEXT("report", "%1: %2"),
                 {plainSymbol(parameter),
                  (language.quantity(*parameter.value, parameter.term.quantity, 2) + QStringLiteral(" → ") +
                   language.quantity(*value, parameter.term.quantity, 2))
                      .toStdString()}}));
    }
}

/// Prints the comparison of a control's table with the written one.
void printComparison(const FoundTable &found, const CompensationTable &written, const Language &language) {
    const bool linear = written.motion == Motion::linear;
    const Quantity position = linear ? Quantity::position : Quantity::angle;
    const CompensationTable &table = found.table;
    printError(language.sentence(
        {table.axis.empty()
             ? REPORT_TEXT_COUNTED("report", "compared with a table of %1: %n point(s) from %2 to %3")
             : REPORT_TEXT_COUNTED("report",
                                   "compared with a table of %1, axis %4: %n point(s) from %2 to %3"),
         {std::string(found.control), Number{table.positions.front(), position},
          Number{table.positions.back(), position}, table.axis},
         static_cast<int>(table.positions.size())}));
    for (const Message &remark : found.remarks)
        printError(language.sentence(remark));
    const TableDifference difference = largestDifference(table, written);
    printError(language.sentence(
        {REPORT_TEXT("report", "largest difference, written − compared: %1 at %2 %3"),
         {Number{difference.value, linear ? Quantity::deviation : Quantity::angularDeviation, 1},
          Number{difference.position, position},
          std::string(difference.direction == Direction::positive ? "↑" : "↓")}}));
}

/// `written`: the table as the control reads it.
void printWhatItBrings(const TestToCompensate &of, const CompensationTable &written,
                       const std::vector<Message> &remarks, const std::optional<FoundTable> &compared,
                       const Language &language) {
    for (const Message &remark : remarks)
        printError(language.sentence(remark));
    printPrediction({REPORT_TEXT("report", "predicted with the compensation applied:")}, of, written,
                    language);
    if (!compared)
        return;
    printComparison(*compared, written, language);
    printPrediction({REPORT_TEXT("report", "predicted with the compared table applied instead:")}, of,
                    compared->table, language);
}

std::optional<FoundTable> comparedTable(const Invocation &invocation) {
    const auto file = invocation.value("compare");
    if (!file)
        return {};
    try {
        return readFoundTable(readBytes(*file), *file);
    } catch (Error &error) {
        error.place = file->toStdString() + (error.place.empty() ? "" : ": " + error.place);
        throw;
    }
}

void requireFormAndFiles(const Invocation &invocation) {
    if (invocation.value("as").value_or(QString()).isEmpty())
        throw UsageError({REPORT_TEXT("report", "the command %1 needs the option --%2 %3"),
                          {std::string("export"), std::string("as"), std::string(exportOptions[0].value)}});
    if (!invocation.has("o"))
        refuseWithoutOutput("export", "-o OUT");
    if (invocation.arguments.size() != 1)
        throw UsageError({REPORT_TEXT("report", "the command %1 takes one file"), {std::string("export")}});
}

/// Throws UsageError if an assumed sign is not confirmed, or if a known one is.
void requireSign(const Test &test, bool isConfirmed) {
    const ImportedFile *file = fileOfAssumedSign(test);
    if (isConfirmed && !file)
        throw UsageError({REPORT_TEXT(
            "report", "--confirm-sign has no effect here: the sign of the deviations is not in doubt")});
    if (file && !isConfirmed)
        throw UsageError(
            {REPORT_TEXT("report",
                         "“%1” does not say the sign of its deviations, and a table of the wrong "
                         "sign doubles them: %2 if they are actual − target, else import it with %3"),
             {file->fileName, std::string("--confirm-sign"), std::string("--set sign=targetMinusActual")}});
}

/// The part program of a test's own targets; says where the axis moves.
QByteArray ownProgram(const Invocation &invocation, const Document &document, std::size_t index) {
    const auto plan = planOf(*document.tests[index]);
    if (!plan)
        throw UsageError({REPORT_TEXT("report", "the test has no targets to move to: plan them with %1"),
                          {std::string("palmer-cli targets")}});
    const auto dialect =
        dialectOf(invocation, "dialect", formatsOfControl(document.machine.controller).program);
    if (!dialect)
        throw UsageError(
            {REPORT_TEXT("report", "the test names no control whose language is known: say it with %1"),
             {std::string("--dialect iso|siemens|heidenhain|linuxcnc|haas")}});
    const CycleProgram &program = plan->program;
    QByteArray written = partProgram(program, *dialect, invocation.language);
    if (const auto over = overtravelText(program, plan->planned.request)) {
        const Quantity position = program.motion == Motion::linear ? Quantity::position : Quantity::angle;
        const Interval moved = movedThrough(program);
        printError(invocation.language.sentence({REPORT_TEXT("report", "The axis moves from %1 to %2."),
                                                 {Number{moved.from, position, program.decimals},
                                                  Number{moved.to, position, program.decimals}}}) +
                   u' ' + invocation.language.sentence(*over));
    }
    return written;
}

int runExport(const Invocation &invocation) {
    const auto output = invocation.value("o");
    const QString form = invocation.value("as").value_or(QString());
    const auto compensation = compensationFormat(form);
    requireFormAndFiles(invocation);
    requireEnding(invocation, *output, form);
    const CompensationOptions table = compensationOptions(invocation);
    if (compensation == CompensationFormat::siemens && !table.reference)
        throw UsageError(
            {REPORT_TEXT("report", "the compensation of a SINUMERIK is 0 at the reference point of the "
                                   "axis: say where that is (%1)"),
             {std::string("--reference P")}});
    const QString file = invocation.arguments.front();
    const Language names = invocation.languageChosen ? invocation.language : Language(Language::Id::english);
    return codeOf(file, invocation.language, [&]() -> int {
        const EvaluatedDocument evaluated =
            evaluate(std::make_shared<const Document>(documentFrom(file, invocation)));
        const std::optional<FoundTable> compared =
            compensation ? comparedTable(invocation) : std::optional<FoundTable>();
        QByteArray bytes;
        CompensationTable made;
        std::size_t index = 0;
        if (form == QLatin1StringView("dcc")) {
            requireForDcc({evaluated.document, {}, {}, {}}, invocation.language);
            bytes = dcc(simulated(evaluated, SimulateWhich::monteCarloOnly, 0, invocation.language));
        } else if (form == QLatin1StringView("json")) {
            bytes = readingsJson(simulated(evaluated, SimulateWhich::monteCarloOnly, 0, invocation.language),
                                 shownFileName(file), names);
        } else {
            index = testIndex(invocation, evaluated.tests.size());
            if (compensation) {
                requireSign(*evaluated.document->tests[index], table.signConfirmed);
                made = compensationTable(*evaluated.document->tests[index], *evaluated.tests[index],
                                         *compensation, table);
            }
            bytes = compensation ? writeCompensation(made, *compensation, table)
                    : form == QLatin1StringView("program")
                        ? ownProgram(invocation, *evaluated.document, index)
                        : readingsCsv(evaluated, index, names, table.decimalMark);
        }
        if (const int code = written(invocation, {{bytes, *output}}); code != done)
            return code;
        if (compensation) {
            CompensationTable written = readCompensation(bytes, *compensation, table);
            written.motion = made.motion; // not stated in the files of some controls
            printWhatItBrings(
                {*evaluated.document->tests[index], *evaluated.tests[index], *evaluated.document}, written,
                compensationRemarks(*evaluated.document->tests[index], made, *compensation, table), compared,
                invocation.language);
        }
        return done;
    });
}

} // namespace

Command exportCommand() {
    return {"export", "FILE",
            REPORT_TEXT("report", "readings and results, a digital calibration certificate, a compensation "
                                  "table with what it would bring, or the part program of a test"),
            exportOptions, runExport};
}

} // namespace palmer
