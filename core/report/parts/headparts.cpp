// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/parts/parts.h"

#include "language/decimals.h"
#include "report/parts/comparedtests.h"
#include "report/parts/thermalparts.h"
#include "report/words/wording.h"

#include <algorithm>

namespace palmer {

namespace {

constexpr double leftLabels = 25;  ///< mm
constexpr double rightLabels = 31; ///< mm

QString machineText(const Machine &machine) {
    return joined({QString::fromStdString(machine.name), QString::fromStdString(machine.manufacturer),
                   QString::fromStdString(machine.model)});
}

/// Common parts of the heads of tests and of the summary: laboratory, number, title.
TestHead letterHead(const Writer &write, const ReportHead &head) {
    TestHead result;
    result.laboratory = QString::fromStdString(head.laboratory.name);
    result.address = joined(
        {QString::fromStdString(head.laboratory.address), QString::fromStdString(head.laboratory.country)},
        QStringLiteral("\n"));
    result.accreditation = QString::fromStdString(head.laboratory.accreditation);
    result.logo = QByteArray::fromBase64(QByteArray::fromStdString(head.laboratory.logo.value_or("")));
    result.mark = QByteArray::fromBase64(QByteArray::fromStdString(head.laboratory.mark.value_or("")));
    result.number = write.say(REPORT_TEXT("report", "Report No. %1"),
                              {head.number.empty() ? std::string("–") : head.number});
    QStringList notes;
    if (!head.revision.empty())
        notes << write.say(REPORT_TEXT("report", "revision %1"), {head.revision});
    if (head.date)
        notes << write.say(REPORT_TEXT("report", "issued %1"), dateText(write, head.date));
    if (!notes.isEmpty())
        result.numberNotes << notes.join(QStringLiteral(", "));
    if (!head.replaces.empty())
        result.numberNotes << write.say(REPORT_TEXT("report", "replaces %1"), {head.replaces});
    result.title = reportTitle(write, head);
    return result;
}

KeyValues partiesAndDates(const Writer &write, const ReportHead &head, const QString &date,
                          const Text &label = REPORT_TEXT("report", "Date of test"), bool order = true) {
    LabelledRows rows(write, {{}, leftLabels});
    rows.add(label, date);
    rows.add(REPORT_TEXT("report", "Place"), head.place);
    rows.add(REPORT_TEXT("report", "Operator"), head.operatorName);
    rows.add(REPORT_TEXT("report", "Supplier"), partyText(head.supplier));
    rows.add(REPORT_TEXT("report", "Customer"), partyText(head.customer));
    if (!order)
        return rows.take();
    const QString procedure = QString::fromStdString(head.procedure);
    if (head.order.empty() || procedure.isEmpty()) {
        rows.add(REPORT_TEXT("report", "Order"), head.order, false);
        rows.add(REPORT_TEXT("report", "Procedure"), procedure, false);
    } else {
        rows.add(REPORT_TEXT("report", "Order"),
                 joined({QString::fromStdString(head.order),
                         write.say(REPORT_TEXT("report", "procedure %1"), procedure)}));
    }
    return rows.take();
}

QString dateOfTest(const TestPart &part) {
    const QString date = dateText(part.write, part.test.date);
    return part.test.time ? joined({date, QString::fromStdString(*part.test.time)}) : date;
}

/// Period of the tests: as stated in the report head, otherwise from the first to the last test.
QString periodOfTests(const std::vector<TestPart> &parts) {
    const ReportHead &head = parts.front().head();
    if (head.performedFrom || head.performedTo)
        return periodText(parts.front().write, head.performedFrom, head.performedTo);
    std::optional<std::string> from;
    std::optional<std::string> to;
    for (const TestPart &part : parts) {
        if (!part.test.date || part.test.date->empty())
            continue;
        from = std::min(from.value_or(*part.test.date), *part.test.date);
        to = std::max(to.value_or(*part.test.date), *part.test.date);
    }
    return periodText(parts.front().write, from, to);
}

std::vector<const Instrument *> instrumentsOf(const TestPart &part) {
    std::vector<const Instrument *> result;
    for (const std::string &id : part.test.instruments) {
        const auto found = std::ranges::find(part.document().instruments, id, &Instrument::id);
        if (found != part.document().instruments.end())
            result.push_back(&*found);
    }
    return result;
}

QString instrumentText(const Writer &write, const Instrument &instrument) {
    QString name = QString::fromStdString(instrument.description);
    if (name.isEmpty())
        name = joined(
            {QString::fromStdString(instrument.manufacturer), QString::fromStdString(instrument.model)});
    if (instrument.serialNumber.empty())
        return name;
    return joined({name, write.say(REPORT_TEXT("report", "No. %1"), {instrument.serialNumber})});
}

void addInstruments(LabelledRows &rows, const TestPart &part) {
    QStringList names;
    for (const Instrument *instrument : instrumentsOf(part))
        names << instrumentText(part.write, *instrument);
    rows.add(REPORT_TEXT("report", "Instrument"), joined(names, QStringLiteral("\n")));
}

/// Moves rows from the end of the right column to the left one where that makes the head lower.
void balanceColumns(TestHead &head) {
    const auto linesOf = [](const KeyValue &row) { return 1 + row.value.count(u'\n'); };
    const auto lines = [&](const KeyValues &values) {
        qsizetype sum = 0;
        for (const KeyValue &row : values.rows)
            sum += linesOf(row);
        return sum;
    };
    while (lines(head.left) + linesOf(head.right.rows.back()) < lines(head.right)) {
        head.left.rows.push_back(std::move(head.right.rows.back()));
        head.right.rows.pop_back();
    }
}

QString axisText(const PositioningPart &part) {
    const Axis &axis = part.measurement.axis;
    const bool linear = axis.motion == Motion::linear;
    QStringList texts{
        QString::fromStdString(axis.name),
        part.write.text(linear ? REPORT_TEXT("report", "linear") : REPORT_TEXT("report", "rotary"))};
    if (axis.travel)
        texts << part.write.say(REPORT_TEXT("report", "axis travel %1"),
                                {Number{*axis.travel, part.along(), -1}});
    return joined(texts);
}

/// "0.00 to 1 500.41 mm"; with degrees each number has its sign.
QString intervalText(const PositioningPart &part, double from, double to, int decimals) {
    const Language &language = part.write.language();
    const QString first = part.along() == Quantity::angle
                              ? language.quantity(from, part.along(), decimals)
                              : language.number(certain(from), part.along(), decimals);
    return part.write.say(REPORT_TEXT("report", "%1 to %2"),
                          {first.toStdString(), Number{to, part.along(), decimals}});
}

QString travelText(const PositioningPart &part) {
    const auto &targets = part.measurement.targets;
    if (targets.empty())
        return {};
    const int decimals = positionDecimals(part.measurement);
    return part.write.quantity(measurementTravel(part.measurement), part.along(), decimals) +
           QStringLiteral(" (") + intervalText(part, targets.front(), targets.back(), decimals) + u')';
}

QString countsText(const PositioningPart &part) {
    const PositioningResults &results = part.results;
    const Number m = wholeNumber(part.measurement.targets.size());
    if (results.upward != results.downward)
        return part.write.say(REPORT_TEXT("report", "m = %1; n = %2 %3"),
                              {m, wholeNumber(results.upward ? results.positiveRuns : results.negativeRuns),
                               std::string(results.upward ? "↑" : "↓")});
    if (results.positiveRuns == results.negativeRuns)
        return part.write.say(REPORT_TEXT("report", "m = %1; n = %2 per direction"),
                              {m, wholeNumber(results.positiveRuns)});
    return part.write.say(REPORT_TEXT("report", "m = %1; n = %2 ↑, %3 ↓"),
                          {m, wholeNumber(results.positiveRuns), wholeNumber(results.negativeRuns)});
}

QString referenceLengthText(const CircularPart &part) {
    const ReferenceLength &length = part.measurement.referenceLength;
    const Writer &write = part.write;
    if (!length.calibrated)
        return {};
    if (!*length.calibrated)
        return write.text(REPORT_TEXT("report", "not calibrated"));
    QString calibrated = write.text(REPORT_TEXT_FOR("report", "calibrated", "length"));
    if (!length.expandedUncertainty)
        return calibrated;
    return joined({calibrated, write.say(REPORT_TEXT("report", "U = %1 (k = %2)"),
                                         {Number{*length.expandedUncertainty, Quantity::micrometres, -1},
                                          Number{length.coverageFactor, Quantity::number, -1}})});
}

QString titleAndEdition(const TestPart &part) {
    return joined({testName(part.write, part.test), QString::fromUtf8(part.edition().word)},
                  QStringLiteral(" · "));
}

/// Common parts of the heads of all kinds, without the right column.
TestHead commonHead(const TestPart &part) {
    TestHead head = letterHead(part.write, part.head());
    head.anchor = part.headAnchor();
    if (part.count > 1)
        head.numberNotes << part.write.say(REPORT_TEXT("report", "Test %1 of %2"),
                                           {wholeNumber(part.number), wholeNumber(part.count)});
    head.subtitle =
        joined({titleAndEdition(part), QString::fromStdString(part.test.title)}, QStringLiteral(" · "));
    if (!part.edition().title.empty())
        head.editionTitle = part.write.text(part.edition().title);
    head.left = partiesAndDates(part.write, part.head(), dateOfTest(part),
                                REPORT_TEXT("report", "Date of test"), part.count == 1); // or in the summary
    return head;
}

} // namespace

QString reportTitle(const Writer &write, const ReportHead &head) {
    return head.title.empty() ? write.text(REPORT_TEXT("report", "Acceptance test report"))
                              : QString::fromStdString(head.title);
}

RunningHead runningHead(const TestPart &part) {
    return {QString::fromStdString(part.head().laboratory.name), titleAndEdition(part)};
}

namespace {

void addAxis(LabelledRows &rows, const PositioningPart &part) {
    rows.add(REPORT_TEXT("report", "Axis"), axisText(part));
    rows.add(REPORT_TEXT("report", "Measurement travel"), travelText(part));
    if (part.measurement.zone)
        rows.add(REPORT_TEXT("report", "Working zone"),
                 intervalText(part, part.measurement.zone->from, part.measurement.zone->to, -1));
    rows.add(REPORT_TEXT("report", "Cycle, targets"),
             joined({part.write.text(cycleText(part.measurement.cycle, part.edition())), countsText(part)},
                    part.write.semicolon()));
}

} // namespace

KeyValues axisRows(const PositioningPart &part) {
    LabelledRows rows(part.write);
    addAxis(rows, part);
    return rows.take();
}

TestHead positioningHead(const PositioningPart &part) {
    TestHead head = commonHead(part);
    if (part.results.stepCycleNotAgreed)
        head.notice =
            part.write.text(REPORT_TEXT("report", "step cycle – not an ISO 230-2 acceptance result"));
    LabelledRows rows(part.write, {{}, rightLabels});
    rows.add(REPORT_TEXT("report", "Machine"), machineText(part.document().machine));
    rows.add(REPORT_TEXT("report", "Serial number"), part.document().machine.serialNumber);
    addAxis(rows, part);
    addInstruments(rows, part);
    head.right = rows.take();
    balanceColumns(head);
    return head;
}

TestHead annexHead(const std::vector<TestPart> &parts, const QString &anchor) {
    const TestPart &part = parts.front();
    TestHead head = letterHead(part.write, part.head());
    head.annex = true;
    head.anchor = anchor;
    head.title = part.write.text(REPORT_TEXT("report", "Annex"));
    head.subtitle = parts.size() > 1 ? reportTitle(part.write, part.head()) : titleAndEdition(part);
    LabelledRows machine(part.write, {{}, leftLabels});
    machine.add(REPORT_TEXT("report", "Machine"), machineText(part.document().machine));
    head.left = machine.take();
    LabelledRows date(part.write, {{}, rightLabels});
    if (parts.size() > 1)
        date.add(REPORT_TEXT("report", "Dates of the tests"), periodOfTests(parts));
    else
        date.add(REPORT_TEXT("report", "Date of test"), dateOfTest(part));
    head.right = date.take();
    return head;
}

RunningHead annexRunningHead(const std::vector<TestPart> &parts) {
    const TestPart &part = parts.front();
    return {QString::fromStdString(part.head().laboratory.name),
            joined({part.write.text(REPORT_TEXT("report", "Annex")),
                    parts.size() > 1 ? reportTitle(part.write, part.head()) : titleAndEdition(part)},
                   QStringLiteral(" · "))};
}

TestHead driftHead(const Writer &write, const Document &document) {
    TestHead head = letterHead(write, document.report);
    head.left =
        partiesAndDates(write, document.report,
                        periodText(write, document.report.performedFrom, document.report.performedTo));
    LabelledRows rows(write, {{}, rightLabels});
    rows.add(REPORT_TEXT("report", "Machine"), machineText(document.machine));
    rows.add(REPORT_TEXT("report", "Serial number"), document.machine.serialNumber);
    head.right = rows.take();
    return head;
}

TestHead sheetHead(const Writer &write, const EvaluatedDocument &evaluated,
                   const std::vector<TestPart> &parts) {
    const Document &document = *evaluated.document;
    TestHead head = letterHead(write, document.report);
    head.title = write.text(REPORT_TEXT("report", "Acceptance sheet"));
    const auto counted = [&](const Text &words, std::size_t count) {
        return write.language().sentence({words, {}, static_cast<int>(count)});
    };
    head.subtitle = joined(
        {QString::fromStdString(document.report.title), QString::fromStdString(document.machine.name),
         counted(REPORT_TEXT_COUNTED("report", "%n check(s)"), document.report.sheet.size()),
         parts.empty() ? QString() : counted(REPORT_TEXT_COUNTED("report", "%n test(s)"), parts.size())},
        QStringLiteral(" · "));
    head.left = partiesAndDates(
        write, document.report,
        parts.empty() ? periodText(write, document.report.performedFrom, document.report.performedTo)
                      : periodOfTests(parts),
        REPORT_TEXT("report", "Dates of the tests"));
    LabelledRows rows(write, {{}, rightLabels});
    rows.add(REPORT_TEXT("report", "Machine"), machineText(document.machine));
    rows.add(REPORT_TEXT("report", "Serial number"), document.machine.serialNumber);
    rows.add(REPORT_TEXT("report", "Control"), document.machine.controller);
    rows.add(REPORT_TEXT("report", "Condition"), document.machine.condition);
    head.right = rows.take();
    return head;
}

TestHead comparisonHead(const TestPart &after, const TestPart &before) {
    const Writer &write = after.write;
    TestHead head = letterHead(write, after.head());
    head.title = write.text(REPORT_TEXT("report", "Comparison of two tests"));
    head.subtitle = titleAndEdition(after);
    head.editionTitle = write.text(comparisonNature());
    const auto named = [&](const TestPart &part) {
        return joined({write.say(REPORT_TEXT("report", "Test %1"), {wholeNumber(part.number)}),
                       QString::fromStdString(part.test.title)});
    };
    LabelledRows left(write, {{}, leftLabels});
    left.add(REPORT_TEXT("report", "Machine"), machineText(after.document().machine));
    left.add(REPORT_TEXT("report", "Serial number"), after.document().machine.serialNumber);
    head.left = left.take();
    LabelledRows right(write, {{}, rightLabels});
    right.add(REPORT_TEXT_FOR("report", "before", "of two tests"), named(before));
    right.add(REPORT_TEXT_FOR("report", "after", "of two tests"), named(after));
    head.right = right.take();
    return head;
}

TestHead thermalHead(const Writer &write, const EvaluatedDocument &evaluated, std::size_t test) {
    const Document &document = *evaluated.document;
    const Test &drift = *document.tests[test];
    TestHead head = letterHead(write, document.report);
    head.title = write.text(REPORT_TEXT("report", "Thermal behaviour"));
    head.subtitle =
        joined({testName(write, drift), QString::fromStdString(drift.title)}, QStringLiteral(" · "));
    head.editionTitle = write.text(thermalNature());
    LabelledRows left(write, {{}, leftLabels});
    left.add(REPORT_TEXT("report", "Machine"), machineText(document.machine));
    left.add(REPORT_TEXT("report", "Serial number"), document.machine.serialNumber);
    left.add(REPORT_TEXT("report", "Date of test"), dateText(write, drift.date));
    const auto &measurement = std::get<DriftMeasurement>(drift.measurement);
    QStringList temperatures;
    for (const DriftTemperature &one : measurement.temperatures)
        temperatures << joined({QString::fromStdString(one.measures),
                                one.resolution
                                    ? write.say(REPORT_TEXT("report", "resolution %1"),
                                                {Number{*one.resolution, Quantity::temperature, -1}})
                                    : QString()});
    left.add(REPORT_TEXT("report", "Temperatures"), temperatures.join(u'\n'), false);
    head.left = left.take();
    LabelledRows right(write, {{}, rightLabels});
    QStringList users;
    for (const std::size_t user : testsTaking(document, drift.id))
        users << joined(
            {testName(write, *document.tests[user]), QString::fromStdString(document.tests[user]->title)});
    right.add(REPORT_TEXT("report", "Used by"), users.join(u'\n'));
    right.add(REPORT_TEXT("report", "Points"), write.language().count(measurement.times.size()));
    if (measurement.settled)
        right.add(REPORT_TEXT("report", "At the beginning"),
                  write.text(REPORT_TEXT("report", "in balance with its temperatures, as stated")));
    head.right = right.take();
    return head;
}

TestHead circularHead(const CircularPart &part) {
    const Writer &write = part.write;
    TestHead head = commonHead(part);
    LabelledRows rows(write, {{}, rightLabels});
    rows.add(REPORT_TEXT("report", "Machine"), machineText(part.document().machine));
    rows.add(REPORT_TEXT("report", "Serial number"), part.document().machine.serialNumber);
    rows.add(REPORT_TEXT("report", "Plane, axes"), part.plane());
    if (part.feedback())
        rows.add(REPORT_TEXT("report", "Measured with"),
                 write.text(REPORT_TEXT("report", "feedback signal of the axes")));
    if (!part.feedback() || !part.test.instruments.empty())
        addInstruments(rows, part);
    if (part.needsLength())
        rows.add(REPORT_TEXT("report", "Reference length"), referenceLengthText(part));
    head.right = rows.take();
    balanceColumns(head);
    return head;
}

TestHead summaryHead(const std::vector<TestPart> &parts) {
    const TestPart &first = parts.front();
    const Writer &write = first.write;
    const Document &document = first.document();
    TestHead head = letterHead(write, document.report);
    QStringList editions;
    for (const TestPart &part : parts) {
        if (const QString edition = QString::fromUtf8(part.edition().word); !editions.contains(edition))
            editions << edition;
    }
    head.subtitle = joined(
        {write.language().sentence(
             {REPORT_TEXT_COUNTED("report", "Summary of %n test(s)"), {}, static_cast<int>(parts.size())}),
         enumerated(write, editions)},
        QStringLiteral(" · "));
    head.left = partiesAndDates(write, document.report, periodOfTests(parts),
                                REPORT_TEXT("report", "Dates of the tests"));
    LabelledRows rows(write, {{}, rightLabels});
    rows.add(REPORT_TEXT("report", "Machine"), machineText(document.machine));
    rows.add(REPORT_TEXT("report", "Serial number"), document.machine.serialNumber);
    rows.add(REPORT_TEXT("report", "Control"), document.machine.controller);
    rows.add(REPORT_TEXT("report", "Condition"), document.machine.condition);
    QStringList instruments;
    for (const TestPart &part : parts) {
        for (const Instrument *instrument : instrumentsOf(part)) {
            if (const QString text = instrumentText(write, *instrument); !instruments.contains(text))
                instruments << text;
        }
    }
    rows.add(REPORT_TEXT("report", "Instruments"), instruments.join(write.semicolon()));
    head.right = rows.take();
    return head;
}

} // namespace palmer
