#include "report/headparts.h"

#include "document/testsofverdict.h"
#include "kernel/evaluation/conformity.h"
#include "report/accordancetext.h"
#include "report/resultparts.h"
#include "report/wording.h"

#include <algorithm>

namespace palmer {

namespace {

constexpr double leftLabels = 25;  ///< mm
constexpr double rightLabels = 31; ///< mm

class Rows {
public:
    Rows(const Writer &write, double labelWidth)
        : m_write(write) {
        m_values.labelWidth = labelWidth;
    }

    void add(const Text &label, const QString &value) {
        m_values.rows.push_back({m_write.text(label), value});
    }
    void add(const Text &label, const std::string &value) { add(label, QString::fromStdString(value)); }
    [[nodiscard]] KeyValues take() { return std::move(m_values); }

private:
    const Writer &m_write;
    KeyValues m_values;
};

QString dateText(const Writer &write, const std::optional<std::string> &date) {
    return date && !date->empty() ? write.language().date(*date) : QString();
}

QString machineText(const Machine &machine) {
    return joined({QString::fromStdString(machine.name), QString::fromStdString(machine.manufacturer),
                   QString::fromStdString(machine.model)});
}

/// Laboratory, number, title: what the heads of tests and of the summary have in common.
TestHead letterHead(const Writer &write, const ReportHead &head) {
    TestHead result;
    result.laboratory = QString::fromStdString(head.laboratory.name);
    result.address = QString::fromStdString(head.laboratory.address);
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

KeyValues partiesAndDates(const Writer &write, const ReportHead &head, const QString &date) {
    Rows rows(write, leftLabels);
    rows.add(REPORT_TEXT("report", "Date of test"), date);
    rows.add(REPORT_TEXT("report", "Place"), head.place);
    rows.add(REPORT_TEXT("report", "Operator"), head.operatorName);
    rows.add(REPORT_TEXT("report", "Supplier"), partyText(head.supplier));
    rows.add(REPORT_TEXT("report", "Customer"), partyText(head.customer));
    return rows.take();
}

QString dateOfTest(const TestPart &part) {
    const QString date = dateText(part.write, part.test.date);
    return part.test.time ? joined({date, QString::fromStdString(*part.test.time)}) : date;
}

QString periodText(const Writer &write, const ReportHead &head) {
    const QString from = dateText(write, head.performedFrom);
    const QString to = dateText(write, head.performedTo);
    if (from.isEmpty() || to.isEmpty() || from == to)
        return from.isEmpty() ? to : from;
    return write.say(REPORT_TEXT_FOR("report", "%1 to %2", "dates"), {from.toStdString(), to.toStdString()});
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

QString certificateText(const Writer &write, const Instrument &instrument) {
    const QString date = dateText(write, instrument.calibrationDate);
    if (instrument.certificate.empty() || date.isEmpty())
        return joined({QString::fromStdString(instrument.certificate), date});
    return write.say(REPORT_TEXT_FOR("report", "%1 of %2", "certificate, date"),
                     {instrument.certificate, date.toStdString()});
}

void addInstruments(Rows &rows, const TestPart &part) {
    QStringList names;
    QStringList certificates;
    for (const Instrument *instrument : instrumentsOf(part)) {
        names << instrumentText(part.write, *instrument);
        certificates << certificateText(part.write, *instrument);
    }
    rows.add(REPORT_TEXT("report", "Instrument"), joined(names, QStringLiteral("\n")));
    rows.add(REPORT_TEXT("report", "Certificate"), joined(certificates, QStringLiteral("\n")));
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

/// "0.00 to 1 500.41 mm"; a sign of degrees stands at each number.
QString intervalText(const PositioningPart &part, double from, double to, int decimals) {
    const Language &language = part.write.language();
    const QString first = part.along() == Quantity::angle ? language.quantity(from, part.along(), decimals)
                                                          : language.number(from, part.along(), decimals);
    return part.write.say(REPORT_TEXT("report", "%1 to %2"),
                          {first.toStdString(), Number{to, part.along(), decimals}});
}

QString travelText(const PositioningPart &part) {
    const auto &targets = part.measurement.targets;
    if (targets.empty())
        return {};
    const int decimals = positionDecimals(targets, part.along());
    return part.write.quantity(measurementTravel(part.measurement), part.along(), decimals) +
           QStringLiteral(" (") + intervalText(part, targets.front(), targets.back(), decimals) + u')';
}

QString countsText(const PositioningPart &part) {
    const PositioningResults &results = part.results;
    const auto count = [](auto n) { return Number{static_cast<double>(n), Quantity::count, 0}; };
    const Number m = count(part.measurement.targets.size());
    if (results.upward != results.downward)
        return part.write.say(REPORT_TEXT("report", "m = %1; n = %2 %3"),
                              {m, count(results.upward ? results.positiveRuns : results.negativeRuns),
                               std::string(results.upward ? "↑" : "↓")});
    if (results.positiveRuns == results.negativeRuns)
        return part.write.say(REPORT_TEXT("report", "m = %1; n = %2 per direction"),
                              {m, count(results.positiveRuns)});
    return part.write.say(REPORT_TEXT("report", "m = %1; n = %2 ↑, %3 ↓"),
                          {m, count(results.positiveRuns), count(results.negativeRuns)});
}

QString referenceLengthText(const CircularPart &part) {
    const ReferenceLength &length = part.measurement.referenceLength;
    const Writer &write = part.write;
    if (!length.calibrated)
        return {};
    if (!*length.calibrated)
        return write.text(REPORT_TEXT("report", "not calibrated"));
    const QString calibrated = write.text(REPORT_TEXT_FOR("report", "calibrated", "length"));
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

/// What the heads of all kinds state alike; the right column is left to each.
TestHead commonHead(const TestPart &part) {
    TestHead head = letterHead(part.write, part.head());
    head.anchor = part.headAnchor();
    if (part.count > 1)
        head.numberNotes << part.write.say(REPORT_TEXT("report", "Test %1 of %2"),
                                           {Number{static_cast<double>(part.number), Quantity::count, 0},
                                            Number{static_cast<double>(part.count), Quantity::count, 0}});
    head.subtitle =
        joined({titleAndEdition(part), QString::fromStdString(part.test.title)}, QStringLiteral(" · "));
    if (!part.edition().title.empty())
        head.editionTitle = part.write.text(part.edition().title);
    head.left = partiesAndDates(part.write, part.head(), dateOfTest(part));
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

TestHead positioningHead(const PositioningPart &part) {
    TestHead head = commonHead(part);
    if (part.results.stepCycleNotAgreed)
        head.notice =
            part.write.text(REPORT_TEXT("report", "step cycle – not an ISO 230-2 acceptance result"));
    const Edition &edition = part.edition();
    const auto addLeft = [&](const Text &label, const QString &value) {
        head.left.rows.push_back({part.write.text(label), value});
    };
    addLeft(REPORT_TEXT("report", "Cycle"),
            part.write.text(part.measurement.cycle == Cycle::standard ? edition.standardCycle
                                                                      : edition.stepCycle));
    addLeft(REPORT_TEXT("report", "Target positions"), countsText(part));

    Rows rows(part.write, rightLabels);
    rows.add(REPORT_TEXT("report", "Machine"), machineText(part.document().machine));
    rows.add(REPORT_TEXT("report", "Serial number"), part.document().machine.serialNumber);
    rows.add(REPORT_TEXT("report", "Axis"), axisText(part));
    rows.add(REPORT_TEXT("report", "Measurement travel"), travelText(part));
    if (part.measurement.zone)
        rows.add(REPORT_TEXT("report", "Working zone"),
                 intervalText(part, part.measurement.zone->from, part.measurement.zone->to, -1));
    rows.add(REPORT_TEXT("report", "Measuring system"), part.measurement.axis.positionFeedback);
    addInstruments(rows, part);
    head.right = rows.take();
    return head;
}

TestHead circularHead(const CircularPart &part) {
    const Writer &write = part.write;
    const CircularMeasurement &measurement = part.measurement;
    TestHead head = commonHead(part);
    if (part.needsLength())
        head.left.rows.push_back(
            {write.text(REPORT_TEXT("report", "Reference length")), referenceLengthText(part)});

    Rows rows(write, rightLabels);
    rows.add(REPORT_TEXT("report", "Machine"), machineText(part.document().machine));
    rows.add(REPORT_TEXT("report", "Serial number"), part.document().machine.serialNumber);
    rows.add(REPORT_TEXT("report", "Plane, axes"), part.plane());
    rows.add(REPORT_TEXT("report", "Measuring system"), measurement.positionFeedback);
    if (part.feedback())
        rows.add(REPORT_TEXT("report", "Measured with"),
                 write.text(REPORT_TEXT("report", "feedback signal of the axes")));
    if (!part.feedback() || !part.test.instruments.empty())
        addInstruments(rows, part);
    head.right = rows.take();
    return head;
}

void addSummary(std::vector<Block> &blocks, const std::vector<TestPart> &parts) {
    const TestPart &first = parts.front();
    const Writer &write = first.write;
    const Document &document = first.document();
    TestHead head = letterHead(write, document.report);
    head.subtitle = write.text(REPORT_TEXT("report", "Summary of the tests"));
    head.left = partiesAndDates(write, document.report, periodText(write, document.report));
    Rows rows(write, rightLabels);
    rows.add(REPORT_TEXT("report", "Machine"), machineText(document.machine));
    rows.add(REPORT_TEXT("report", "Serial number"), document.machine.serialNumber);
    rows.add(REPORT_TEXT("report", "Control"), document.machine.controller);
    rows.add(REPORT_TEXT("report", "Condition"), document.machine.condition);
    rows.add(REPORT_TEXT("report", "Order"), document.report.order);
    head.right = rows.take();
    blocks.emplace_back(RunningHead{head.laboratory, head.title});
    blocks.emplace_back(std::move(head));

    Table table;
    table.columns = {{QString(), {}, Alignment::right, false, 7},
                     {write.text(REPORT_TEXT("report", "Test")), {}, Alignment::left, true, 62},
                     {write.text(REPORT_TEXT("report", "Date")), {}, Alignment::left, false, 30},
                     {write.text(REPORT_TEXT("report", "Edition")), {}, Alignment::left, false, 34},
                     {write.text(REPORT_TEXT("report", "Verdict")), {}, Alignment::left, false, 42}};
    std::optional<Verdict> verdict;
    std::vector<Accordance> accordances;
    for (const TestPart &part : parts) {
        const TestEvaluation &evaluation = part.evaluation;
        const Accordance accordance = evaluation.accordance();
        const bool counts = countsForVerdict(document, part.index);
        if (counts) {
            verdict = worst(verdict, evaluation.verdict);
            accordances.push_back(accordance);
        }
        Cell word;
        word.text.spans.push_back({write.text(verdictWord(evaluation.verdict, hasLimits(part.test)))});
        word.text.spans.back().bold = evaluation.verdict == Verdict::doesNotConform;
        if (evaluation.verdict)
            word.mark = markOf(*evaluation.verdict);
        if (const Text words = accordanceWords(accordance); !words.empty()) {
            word.text.spans.push_back({u'\n' + write.text(words)});
            word.text.spans.back().bold = accordance == Accordance::no;
        }
        table.links.push_back(part.headAnchor());
        if (!counts)
            word.text.spans.push_back(
                {u'\n' + write.text(REPORT_TEXT("report", "for information, not part of the verdict"))});
        const Text role = roleText(part.test.role);
        table.rows.push_back({QString::number(part.number),
                              joined({testName(write, part.test), QString::fromStdString(part.test.title),
                                      role.empty() ? QString() : write.text(role)},
                                     QStringLiteral("\n")),
                              dateText(write, part.test.date), QString::fromUtf8(part.edition().word), word});
    }
    addHeading(blocks, write.text(REPORT_TEXT("report", "Tests")));
    blocks.emplace_back(std::move(table));

    VerdictLine line;
    const Accordance weakest =
        std::ranges::find(accordances, Accordance::no) != accordances.end()         ? Accordance::no
        : std::ranges::find(accordances, Accordance::notShown) != accordances.end() ? Accordance::notShown
                                                                                    : Accordance::yes;
    line.verdict = largeMark(verdict, weakest);
    line.label = write.text(REPORT_TEXT("report", "Verdict of the report"));
    const bool anyLimit =
        std::ranges::any_of(parts, [](const TestPart &part) { return hasLimits(part.test); });
    line.word = write.text(largeWord(verdict, anyLimit, weakest)).toUpper();
    line.reason = write.text(
        verdict    ? REPORT_TEXT("report", "The worst verdict of the tests.")
        : anyLimit ? REPORT_TEXT("report", "The limits agreed do not hold for these tests: no verdict.")
                   : REPORT_TEXT("report", "No limit was agreed: the results have no verdict."));
    line.inAccordance = weakest != Accordance::no;
    line.accordance = accordanceOfAll(accordances, write.language());
    blocks.emplace_back(std::move(line));
}

} // namespace palmer
