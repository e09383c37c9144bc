// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/parts/parts.h"

#include "document/instruments.h"
#include "language/decimals.h"
#include "report/parts/thermalparts.h"
#include "report/words/findingtext.h"

#include <algorithm>
#include <set>

namespace palmer {

namespace {

constexpr double statementLabels = 44; ///< mm
constexpr double statementsLeft = 42;  ///< in two columns of statements, mm
constexpr double statementsRight = 36;
constexpr double statementsBeside = 96; ///< width of the left one, for details of a machine on one line, mm
constexpr qsizetype longestBeside = 56; ///< characters of a statement there

/// Ids of the instruments named by the tests.
std::set<std::string> usedInstruments(const Document &document) {
    std::set<std::string> used;
    for (const TestPointer &test : document.tests)
        used.insert(test->instruments.begin(), test->instruments.end());
    return used;
}

QString selfTestText(const Writer &write, const std::optional<bool> &passed) {
    if (!passed)
        return write.text(REPORT_TEXT("report", "self-test not run"));
    return write.text(*passed ? REPORT_TEXT("report", "self-test against reference data passed")
                              : REPORT_TEXT("report", "self-test against reference data NOT passed"));
}

Text signerText(Signer signer) {
    return inOrder(signer,
                   {REPORT_TEXT("report", "Operator"), REPORT_TEXT("report", "Laboratory"),
                    REPORT_TEXT("report", "Supplier/manufacturer"), REPORT_TEXT("report", "Customer/user")});
}

/// Shortens a name to fit in a column that is never split; head and statements give it in full.
QString bounded(const QString &name) {
    constexpr qsizetype most = 160;
    if (name.size() <= most)
        return name;
    const bool splits = name.at(most - 1).isHighSurrogate();
    return name.left(splits ? most - 1 : most).trimmed() + u'…';
}

QString authorisedText(const ReportHead &head) {
    return joined(
        {QString::fromStdString(head.authorisedBy.name), QString::fromStdString(head.authorisedBy.function)});
}

/// The head names the company of a supplier or customer, not the signer.
QString knownName(Signer signer, const ReportHead &head) {
    return signer == Signer::operatorSigns ? bounded(QString::fromStdString(head.operatorName))
           : signer == Signer::laboratory  ? bounded(authorisedText(head))
                                           : QString();
}

} // namespace

QString machineDetails(const Writer &write, const Machine &machine) {
    QStringList details;
    if (!machine.controller.empty())
        details << write.say(REPORT_TEXT("report", "control %1"), {machine.controller});
    if (machine.year)
        details << write.say(REPORT_TEXT("report", "year %1"), {std::to_string(*machine.year)});
    details << QString::fromStdString(machine.location);
    return joined(details);
}

QString traceabilityText(const Writer &write, const Instrument &instrument) {
    const Traceability &traced = instrument.traceability;
    const auto named = [&](const Text &words, const std::string &name) {
        return name.empty() ? QString() : write.say(words, {name});
    };
    constexpr Text certificate = REPORT_TEXT("report", "certificate %1");
    return joined({named(REPORT_TEXT("report", "calibrated by %1"), instrument.calibratedBy),
                   named(certificate, instrument.certificate), dateText(write, instrument.calibrationDate),
                   named(REPORT_TEXT("report", "traceable to %1"), traced.laboratory),
                   named(REPORT_TEXT("report", "accreditation %1"), traced.accreditation),
                   named(certificate, traced.certificate)});
}

void addTraceability(std::vector<Block> &blocks, const Writer &write, const EvaluatedDocument &evaluated) {
    const std::vector<Instrument> &instruments = evaluated.document->instruments;
    if (instruments.empty())
        return;
    const std::set<std::string> used = usedInstruments(*evaluated.document);
    Table table;
    table.columns = {write.flexible(REPORT_TEXT("report", "Instrument"), 48),
                     write.column(REPORT_TEXT_FOR("report", "Serial No.", "column"), 17),
                     write.column(REPORT_TEXT("report", "Certificate"), 17),
                     write.column(REPORT_TEXT("report", "Calibrated by"), 31),
                     write.column(REPORT_TEXT("report", "Calibrated"), 22),
                     write.column(REPORT_TEXT("report", "Due"), 22),
                     write.column(REPORT_TEXT("report", "Resolution"), 18)};
    for (std::size_t i = 1; i < 3; ++i)
        table.columns[i].fitting = true;
    const auto shortDate = [&](const std::optional<std::string> &date) {
        return date && !date->empty() ? write.language().shortDate(*date) : QString();
    };
    for (const Instrument &instrument : instruments)
        table.rows.push_back(
            {joined({QString::fromStdString(instrument.description),
                     QString::fromStdString(instrument.manufacturer),
                     QString::fromStdString(instrument.model),
                     used.contains(instrument.id) ? QString()
                                                  : write.text(REPORT_TEXT("report", "(named by no test)"))}),
             QString::fromStdString(instrument.serialNumber), QString::fromStdString(instrument.certificate),
             QString::fromStdString(instrument.calibratedBy), shortDate(instrument.calibrationDate),
             shortDate(instrument.calibrationDue),
             write.quantity(instrument.resolution, resolutionQuantity(*evaluated.document, instrument))});
    for (std::size_t i = 0; i < instruments.size(); ++i) {
        Instrument traced; // the calibration stands in its columns
        traced.traceability = instruments[i].traceability;
        if (traced.traceability != Traceability())
            table.rows[i].front().extras.edit().notes.push_back({traceabilityText(write, traced)});
    }
    addHeading(blocks, write.text(REPORT_TEXT("report", "Traceability of the instruments")));
    blocks.emplace_back(std::move(table));
}

void addDriftTests(std::vector<Block> &blocks, const Writer &write, const EvaluatedDocument &evaluated) {
    KeyValues values;
    values.labelWidth = statementLabels;
    for (std::size_t i = 0; i < evaluated.tests.size(); ++i) {
        const Test &test = *evaluated.document->tests[i];
        if (!isDrift(test))
            continue;
        const auto &drift = std::get<DriftMeasurement>(test.measurement);
        const auto range = rangeOf(drift);
        QStringList texts{drift.channels.size() > 1 ? rangesOfChannels(drift, write.language())
                          : range ? write.say(REPORT_TEXT("report", "range of the deviations %1"),
                                              {Number{*range, deviationQuantity(drift), 1}})
                                  : QString()};
        for (const Finding &finding : evaluated.tests[i]->findings)
            texts << findingText(finding, write.language());
        texts << QString::fromStdString(test.remarks);
        values.rows.push_back({joined({testName(write, test), QString::fromStdString(test.title)}),
                               joined(texts, QStringLiteral("\n"))});
    }
    if (values.rows.empty())
        return;
    addHeading(blocks, write.text(REPORT_TEXT("report", "Drift tests")),
               write.text(REPORT_TEXT("report", "environmental variation error")));
    blocks.emplace_back(std::move(values));
}

void addStated(std::vector<Block> &blocks, const std::vector<KeyValue> &rows) {
    constexpr std::ptrdiff_t fewest = 2; // minimum for two columns
    KeyValues beside{{}, statementsLeft, true};
    KeyValues below{{}, statementLabels, true};
    const auto isShort = [](const KeyValue &row) {
        return row.value.size() <= longestBeside && !row.value.contains(u'\n');
    };
    const bool bothColumns = std::ranges::count_if(rows, isShort) >= fewest;
    for (const KeyValue &row : rows)
        (bothColumns && isShort(row) ? beside : below).rows.push_back(row);
    if (bothColumns) {
        SideBySide both{{beside}, {KeyValues{{}, statementsRight, true}}, statementsBeside, 5};
        both.levelled = true;
        blocks.emplace_back(std::move(both));
    }
    if (!below.rows.empty())
        blocks.emplace_back(std::move(below));
}

QString scopeText(const Writer &write) {
    return write.text(REPORT_TEXT("report",
                                  "The results relate only to the machine tested in the stated condition.")) +
           u' ' + write.text(REPORT_TEXT("report", "This report may be reproduced only in full."));
}

void addStatements(std::vector<Block> &blocks, const Writer &write, const EvaluatedDocument &evaluated,
                   const Making &making, const QString &fingerprint, const QString &foreign, int level) {
    if (!making.annex)
        addProgram(blocks, write, evaluated, making, fingerprint, foreign, level);
    const Document &document = *evaluated.document;
    const ReportHead &head = document.report;
    const bool signedBy = !head.signatures.empty() &&
                          std::ranges::find(head.leaveOut, ReportPart::signatures) == head.leaveOut.end();
    const bool named =
        signedBy && std::ranges::find(head.signatures, Signer::laboratory) != head.signatures.end();
    LabelledRows rows(write);
    rows.add(REPORT_TEXT("report", "Deviations from the method"), head.deviationsFromMethod, false);
    rows.add(REPORT_TEXT("report", "Tests carried out"),
             periodText(write, head.performedFrom, head.performedTo), false);
    rows.add(REPORT_TEXT("report", "Details of the machine"), machineDetails(write, document.machine), false);
    rows.add(REPORT_TEXT("report", "Condition of the machine"), document.machine.condition);
    rows.add(REPORT_TEXT("report", "Adjustments made"), head.adjustments);
    rows.add(REPORT_TEXT("report", "Reason of the revision"), head.revisionReason, false);
    if (!named ||
        authorisedText(head) != knownName(Signer::laboratory, head)) // otherwise above the signature
        rows.add(REPORT_TEXT("report", "Authorised by"), authorisedText(head));
    addHeading(blocks, write.text(signedBy ? REPORT_TEXT("report", "Responsibility and signatures")
                                           : REPORT_TEXT("report", "Statements")));
    addStated(blocks, rows.take().rows);
    blocks.emplace_back(Paragraph{scopeText(write), TextSize::small});
    if (!signedBy)
        return;
    Signatures signatures;
    for (const Signer signer : head.signatures)
        signatures.columns.push_back({write.text(signerText(signer)),
                                      {{write.text(REPORT_TEXT("report", "Name")), knownName(signer, head)},
                                       {write.text(REPORT_TEXT("report", "Date"))},
                                       {write.text(REPORT_TEXT("report", "Signature")), {}, true}}});
    blocks.emplace_back(std::move(signatures));
}

void addProgram(std::vector<Block> &blocks, const Writer &write, const EvaluatedDocument &evaluated,
                const Making &making, const QString &fingerprint, const QString &foreign, int level) {
    LabelledRows rows(write, {{}, statementLabels});
    rows.add(REPORT_TEXT("report", "Program"),
             joined({making.program, selfTestText(write, making.selfTestPassed)}));
    rows.add(REPORT_TEXT("report", "Fingerprint SHA-256"), fingerprint);
    if (!foreign.isEmpty())
        rows.add(REPORT_TEXT("report", "Characters"),
                 write.say(REPORT_TEXT("report",
                                       "not in the font of the report: %1; drawn from another font where one "
                                       "is installed, else as boxes"),
                           foreign));
    blocks.emplace_back(Heading{level, write.text(REPORT_TEXT("report", "Program and test file"))});
    blocks.emplace_back(rows.take());
    blocks.emplace_back(Paragraph{
        joined(
            {coverageText(write, evaluated),
             write.text(REPORT_TEXT(
                 "report", "The fingerprint is that of the test file attached to the PDF of this report."))},
            QStringLiteral(" ")),
        TextSize::small});
}

QString coverageText(const Writer &write, const EvaluatedDocument &evaluated) {
    const auto isEvaluated = [](const Parameter &parameter) {
        return parameter.expandedUncertainty && usesContributions(parameter.decidedBy);
    };
    const bool any = std::ranges::any_of(evaluated.tests, [&](const auto &test) {
        return std::ranges::any_of(test->parameters, isEvaluated);
    });
    if (!any)
        return {};
    return write.text(REPORT_TEXT(
        "report",
        "Expanded uncertainties are evaluated according to the GUM (JCGM 100) and stated with the coverage "
        "factor k = 2, a coverage probability of about 95 %; simulated ones (JCGM 101) are half of the "
        "shortest interval that holds 95.45 %."));
}

void addResponsibility(std::vector<Block> &blocks, const Writer &write, const ReportHead &head) {
    constexpr double height = 12.4; // mm, like the widths
    constexpr double dateWidth = 36;
    constexpr double signatureWidth = 62;
    const auto column = [&](const Text &label, const QString &value, double width) {
        return SignatureColumn{{}, {{write.text(label), value, true, height}}, width};
    };
    addHeading(blocks, write.text(REPORT_TEXT("report", "Responsibility for the report")));
    blocks.emplace_back(Signatures{
        {column(REPORT_TEXT("report", "Authorised by: name, function"), bounded(authorisedText(head)), 0),
         column(REPORT_TEXT("report", "Date"), {}, dateWidth),
         column(REPORT_TEXT("report", "Signature"), {}, signatureWidth)}});
}

} // namespace palmer
