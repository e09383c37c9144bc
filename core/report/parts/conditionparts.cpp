// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/parts/parts.h"

#include "document/fieldvalue.h"
#include "document/statedthings.h"
#include "figures/testfigures.h"
#include "kernel/evaluation/agreedpoints.h"
#include "kernel/evaluation/applylimits.h"
#include "kernel/evaluation/asked.h"
#include "kernel/measurement/testfacts.h"
#include "kernel/uncertainty/statedinputs.h"
#include "kernel/words/characters.h"
#include "language/decimals.h"
#include "report/words/correctiontext.h"
#include "report/words/wording.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace palmer {

namespace {

constexpr double conditionsWidth = 98; ///< mm, next to the environment of 68 mm
constexpr double conditionLabels = 30; ///< mm
constexpr int correctionDecimals = 2;

QString stated(const Writer &write, std::optional<bool> value, const Text &yes, const Text &no) {
    return value ? write.text(*value ? yes : no) : QString();
}

QString specifiedText(const Writer &write, SpecifiedBy by) {
    return by == SpecifiedBy::notStated
               ? QString()
               : write.text(by == SpecifiedBy::maker ? REPORT_TEXT("report", "as the maker specifies")
                                                     : REPORT_TEXT("report", "as agreed"));
}

QString warmUpText(const Writer &write, const WarmUp &warmUp) {
    const QString by = specifiedText(write, warmUp.specifiedBy);
    const bool saysBy = warmUp.kind == WarmUpKind::procedure && !by.isEmpty();
    const bool onlyText = warmUp.kind == WarmUpKind::notStated && !isBlank(warmUp.text);
    return joined({onlyText ? write.text(REPORT_TEXT("report", "not stated"))
                   : saysBy ? QString()
                            : write.text(statedWord("warmUp", warmUp.kind)),
                   warmUp.kind == WarmUpKind::setUpOnly ? QString() : by,
                   QString::fromStdString(warmUp.text)});
}

QString targetChoiceText(const PositioningPart &part) {
    const TargetChoice &choice = part.measurement.targetChoice;
    const Writer &write = part.write;
    const auto distance = [&](double value) { return Number{value, part.along(), -1}; };
    QStringList texts;
    texts << (choice.kind == TargetChoiceKind::polygon && choice.faces
                  ? write.say(REPORT_TEXT("report", "polygon of %1 faces"), {wholeNumber(*choice.faces)})
                  : write.text(statedWord("targetChoice", choice.kind)));
    if (choice.interval)
        texts << write.say(REPORT_TEXT("report", "nominal interval %1"), {distance(*choice.interval)});
    if (choice.period)
        texts << write.say(REPORT_TEXT("report", "period %1"), {distance(*choice.period)});
    if (choice.seed)
        texts << write.say(REPORT_TEXT("report", "random part of seed %1"), {std::to_string(*choice.seed)});
    return joined(texts);
}

QString targetList(const PositioningPart &part) {
    const auto &targets = part.measurement.targets;
    const int decimals = positionDecimals(part.measurement);
    QStringList texts;
    for (const double target : targets)
        texts << part.write.language().number(target, part.along(), decimals);
    return joined(texts, part.write.semicolon()) + QStringLiteral("\u00A0") +
           part.write.language().unit(part.along());
}

QString measuringLineText(const Writer &write, const Conditions &conditions) {
    QStringList lines;
    bool any = false;
    const auto add = [&](const Text &words, const Point3 &point) {
        const QString text = pointText(write, point);
        any = any || !text.isEmpty();
        lines << write.say(words, text.isEmpty() ? QStringLiteral("–") : text + QStringLiteral("\u00A0mm"));
    };
    add(REPORT_TEXT("report", "tool offset: %1"), conditions.toolOffset);
    add(REPORT_TEXT("report", "workpiece offset: %1"), conditions.workpieceOffset);
    return any ? lines.join(u'\n') : QString();
}

/// Conditions that are printed elsewhere in the report or share a row.
constexpr auto placedConditions = std::to_array<std::string_view>(
    {"feedMode", "unloaded", "complete", "levelled", "temperatureControlled", "stabilised", "correctionTo20",
     "airPressure", "airHumidity", "gradientPerHour", "gradientHoursBefore"});
constexpr auto placedOfCircles = std::to_array<std::string_view>(
    {"compensation", "otherAxes", "startPoint", "stopPoint", "smoothing", "recentredBetweenRuns"});

/// Collects the rows of a table of conditions.
class ConditionRows : public LabelledRows {
public:
    explicit ConditionRows(const TestPart &part)
        : LabelledRows(part.write, {{}, conditionLabels})
        , m_test(part.test)
        , m_write(part.write)
        , m_asked(askedStatements(part.test, part.evaluation)) {}

    using LabelledRows::add;
    void addStated(const Text &label, const QString &value) { add(label, value, false); }
    /// The same of a statement that belongs to the certificate only if edition or practice ask for it.
    void addIfAsked(std::string_view key, const Text &label, const QString &value) {
        if (value.isEmpty())
            return;
        add(label, value);
        last().further = std::ranges::find(m_asked, key, &AskedStatement::key) == m_asked.end();
    }
    /// Adds a row named after a StatedThing.
    void add(const char *key, const QString &value) {
        m_keys.emplace_back(key);
        add(statedThing(key)->name, value);
    }
    void addStated(const char *key, const QString &value) {
        m_keys.emplace_back(key);
        addIfAsked(key, statedThing(key)->name, value);
    }
    /// Adds a row with the statement of the test.
    void add(const char *key) { add(key, said(key)); }
    void addStated(const char *key) { addStated(key, said(key)); }
    /// Adds all statements without a row yet, so that none is lost.
    void addRest() {
        for (const std::string_view key : conditionKeys(m_test)) {
            const auto isOneOf = [key](const auto &keys) {
                return std::ranges::find(keys, key) != keys.end();
            };
            const bool placed = isOneOf(placedConditions) || isOneOf(m_keys) ||
                                (isCircle(m_test) && isOneOf(placedOfCircles));
            if (!placed)
                addStated(key.data());
        }
    }
    [[nodiscard]] QString said(std::string_view key) const {
        const FieldValue value = fieldValue(m_test, key);
        if (const auto *text = std::get_if<std::string>(&value))
            return QString::fromStdString(*text);
        if (const auto *answer = std::get_if<std::optional<bool>>(&value))
            return stated(m_write, *answer, REPORT_TEXT("report", "yes"), REPORT_TEXT("report", "no"));
        if (const auto *number = std::get_if<std::optional<double>>(&value))
            return m_write.quantity(*number, quantityOf(*statedThing(key), motionOf(m_test)));
        const auto *word = std::get_if<std::size_t>(&value);
        return word ? m_write.text(statedWord(key, *word)) : QString();
    }

private:
    const Test &m_test;
    const Writer &m_write;
    std::vector<AskedStatement> m_asked;
    std::vector<std::string_view> m_keys; ///< keys of the rows
};

/// True if a contribution of the printed budget uses the number; a 0 does not need to be shown.
bool isInBudget(const TestPart &part, double value) {
    if (!part.annex || part.leavesOut(ReportPart::uncertainty) || !usesBudget(part.evaluation))
        return false;
    const auto isValue = [value](const Argument &argument) {
        const auto *number = std::get_if<Number>(&argument);
        return number && number->value == value;
    };
    const auto &contributions = part.evaluation.uncertainty.contributions;
    return value == 0 || std::ranges::any_of(contributions, [&](const Contribution &contribution) {
               return contribution.expanded && std::ranges::any_of(contribution.inputs.arguments, isValue);
           });
}

/// Statements of the file about uncertainty and decision that no other part of the report shows.
QString furtherStatements(const TestPart &part) {
    const Writer &write = part.write;
    QStringList texts;
    const auto add = [&](const QString &name, const Number &value) {
        texts << name + QStringLiteral("\u00A0") + write.quantity(value.value, value.quantity);
    };
    for (const StatedInput &input : statedInputs(part.test)) {
        if (!isInBudget(part, input.value.value))
            add(write.text(input.name), input.value);
    }
    const Quantity quantity =
        motionOf(part.test) == Motion::rotary ? Quantity::arcSeconds : Quantity::micrometres;
    withUncertainty(part.test, [&](const auto &inputs) {
        for (const auto &[id, expanded] : inputs.expanded) {
            const bool decides =
                std::ranges::any_of(part.evaluation.parameters, [&, &id = id](const Parameter &parameter) {
                    return parameter.decidedBy == UncertaintyMethod::direct &&
                           (parameter.term.id == id || parameter.term.also == id);
                });
            if (!decides)
                add(QStringLiteral("U(%1)").arg(QString::fromStdString(symbolOf(id, part.edition()))),
                    {expanded, quantity});
        }
    });
    const DecisionRule &decision = part.test.decisionRule;
    if ((decision.rule == Rule::simpleAcceptance || !hasLimits(part.test.limits)) &&
        decision.guardFactor != DecisionRule().guardFactor)
        add(write.text(REPORT_TEXT("report", "factor of the guard band")),
            {decision.guardFactor, Quantity::number});
    return texts.join(write.semicolon());
}

void addLoadAndState(ConditionRows &rows, const TestPart &part, const Conditions &conditions) {
    const Writer &write = part.write;
    rows.add("load", joined({stated(write, conditions.unloaded, part.edition().unloaded,
                                    REPORT_TEXT("report", "machine loaded")),
                             QString::fromStdString(conditions.load)}));
    rows.add(
        REPORT_TEXT("report", "State of the machine"),
        joined({stated(write, conditions.complete, REPORT_TEXT("report", "complete and in working order"),
                       REPORT_TEXT("report", "not complete")),
                stated(write, conditions.levelled, REPORT_TEXT("report", "levelled and aligned"),
                       REPORT_TEXT("report", "not levelled"))}));
}

void addPurpose(ConditionRows &rows, const TestPart &part) {
    const Text role = roleText(part.test.role);
    const Text purpose = purposeText(part.test.purpose);
    rows.addStated(statedThing("purpose")->name,
                   joined({purpose.empty() ? QString() : part.write.text(purpose),
                           role.empty() ? QString() : part.write.text(role)}));
    rows.addStated(REPORT_TEXT("report", "Duration of the test"),
                   part.test.duration
                       ? part.write.language().number(certain(*part.test.duration), Quantity::number, -1) +
                             QStringLiteral("\u00A0min")
                       : QString());
    const DeclaredAccordance &declared = part.test.declaredAccordance;
    rows.addStated(REPORT_TEXT("report", "Declared by the laboratory"),
                   joined({joined({QString::fromStdString(declared.by), dateText(part.write, declared.date)}),
                           QString::fromStdString(declared.text)},
                          QStringLiteral("\n")));
}

void addThermalPreparation(ConditionRows &rows, const Writer &write, const Conditions &conditions) {
    rows.addIfAsked("temperatureControlled", REPORT_TEXT("report", "Room temperature"),
                    stated(write, conditions.temperatureControlled,
                           REPORT_TEXT("report", "can be controlled"),
                           REPORT_TEXT("report", "cannot be controlled")));
    rows.addIfAsked("stabilised", REPORT_TEXT("report", "Before the test"),
                    stated(write, conditions.stabilised,
                           REPORT_TEXT("report", "machine and instruments thermally stable"),
                           REPORT_TEXT("report", "machine or instruments not thermally stable")));
    for (const char *key : {"instrumentCompensation", "soak", "shielded", "thermalGuidelines"})
        rows.addStated(key);
}

KeyValues rowsOf(const PositioningPart &part) {
    const Writer &write = part.write;
    const PositioningConditions &conditions = part.measurement.conditions;
    const Conditions &common = conditions.common;
    ConditionRows rows(part);
    addPurpose(rows, part);
    rows.add(REPORT_TEXT("report", "Measuring system"), part.measurement.axis.positionFeedback);
    rows.add("warmUp", warmUpText(write, common.warmUp));
    const QString feed = write.quantity(conditions.feed, feedQuantity(part.test));
    const bool isRapid = conditions.feedMode == FeedMode::rapid;
    rows.add("feed", joined({isRapid || feed.isEmpty() ? rows.said("feedMode") : QString(), feed}));
    rows.add("dwell");
    rows.addStated("approachDistance");
    addLoadAndState(rows, part, common);
    rows.add("compensation");
    rows.add("otherAxes");
    rows.add(REPORT_TEXT("report", "Measuring line"), measuringLineText(write, common));
    rows.add("instrumentPosition");
    rows.add("targetChoice", targetChoiceText(part));
    if (part.leavesOut(ReportPart::targetTable) && part.leavesOut(ReportPart::readings))
        rows.add(REPORT_TEXT("report", "Target positions"), targetList(part)); // otherwise in the tables
    if (const auto &ends = part.measurement.axis.range)
        rows.addStated("range",
                       write.say(REPORT_TEXT("report", "%1 to %2"),
                                 {Number{ends->from, part.along()}, Number{ends->to, part.along()}}));
    const auto &element = part.measurement.axis.scaleElement;
    if (element)
        rows.addStated("scaleElement", *element > 0
                                           ? write.quantity(element, Quantity::position)
                                           : write.text(REPORT_TEXT_FOR("report", "continuous", "scale")));
    rows.addStated("continuousDevice");
    rows.addStated("referencePosition");
    addThermalPreparation(rows, write, common);
    if (conditions.gradientHoursBefore)
        rows.addStated("gradientPerHour",
                       write.say(REPORT_TEXT("report", "over the %1 h before the test and during it"),
                                 {Number{*conditions.gradientHoursBefore, Quantity::number, -1}}));
    rows.addRest();
    rows.addIfAsked({}, REPORT_TEXT("report", "Further statements"), furtherStatements(part));
    return rows.take();
}

/// The circle as specified.
QString specifiedCircle(const CircularPart &part) {
    const SpecifiedCircle &circle = part.measurement.specified;
    QStringList texts;
    if (circle.diameter)
        texts << part.write.say(REPORT_TEXT("report", "diameter %1"),
                                {Number{*circle.diameter, Quantity::position, -1}});
    if (circle.feed)
        texts << part.write.say(REPORT_TEXT_FOR("report", "feed %1", "contouring"),
                                {Number{*circle.feed, Quantity::feed, -1}});
    return texts.join(part.write.semicolon());
}

/// Parts left out of the evaluated ranges, as stated for each arc.
QString leftOut(const CircularPart &part) {
    QStringList texts;
    for (const Arc &arc : part.measurement.arcs) {
        const QString text = QString::fromStdString(arc.cutOff);
        if (!text.isEmpty() && !texts.contains(text))
            texts << text;
    }
    return texts.join(u'\n');
}

QString angleReferenceText(const CircularPart &part) {
    QStringList texts;
    for (const Arc &arc : part.measurement.arcs) {
        const QString text = part.write.text(
            arc.angleReference == AngleReference::commanded
                ? REPORT_TEXT("report", "commanded: of the programmed path; the centring error is taken out")
                : REPORT_TEXT("report", "polar: of the measured points"));
        if (!texts.contains(text))
            texts << text;
    }
    return texts.join(u'\n');
}

KeyValues rowsOf(const CircularPart &part) {
    const Writer &write = part.write;
    const CircularConditions &conditions = part.measurement.conditions;
    const Conditions &common = conditions.common;
    ConditionRows rows(part);
    addPurpose(rows, part);
    rows.add(REPORT_TEXT("report", "Measuring system"), part.measurement.positionFeedback);
    rows.add("warmUp", warmUpText(write, common.warmUp));
    addLoadAndState(rows, part, common);
    rows.addStated(REPORT_TEXT("report", "Specified circle"), specifiedCircle(part));
    rows.addStated(REPORT_TEXT("report", "Left out"), leftOut(part));
    rows.addStated("instrumentPosition");
    rows.addStated(REPORT_TEXT("report", "Angles"), angleReferenceText(part));
    if (!part.feedback() && part.results.paths.size() > 1)
        rows.add(REPORT_TEXT("report", "Between the runs"),
                 stated(write, conditions.recentredBetweenRuns,
                        REPORT_TEXT("report", "instrument re-centred"),
                        REPORT_TEXT("report", "measured consecutively, without re-centring")));
    addThermalPreparation(rows, write, common);
    rows.addRest();
    rows.addIfAsked({}, REPORT_TEXT("report", "Further statements"), furtherStatements(part));
    return rows.take();
}

/// A label within a list: "measuring system", "α machine".
QString withinList(QString label) {
    if (label.size() > 1 && label.at(1).isLower())
        label[0] = label.at(0).toLower();
    return label;
}

void addNotStated(KeyValues &rows, const QString &missing, const Writer &write) {
    if (!missing.isEmpty())
        rows.rows.push_back({write.text(REPORT_TEXT_FOR("report", "Not stated", "conditions")), missing});
}

/// Table of temperatures at start and end and other statements about the environment.
class EnvironmentTable {
public:
    EnvironmentTable(const TestPart &part, const Conditions &conditions)
        : m_write(part.write) {
        m_table.columns = {m_write.flexible(part.edition().environment, 44.5),
                           m_write.column(REPORT_TEXT("report", "Start"), 12, Alignment::decimal),
                           m_write.column(REPORT_TEXT("report", "End"), 11.5, Alignment::decimal)};
        for (const SensorMeasures what :
             {SensorMeasures::machine, SensorMeasures::instrument, SensorMeasures::air})
            addTemperatures(what, temperaturesOf(conditions, what));
    }

    void add(const char *key, std::optional<double> value) {
        const Quantity quantity = statedThing(key)->form.quantity.value();
        m_table.rows.push_back(
            {label(statedThing(key)->name, quantity), m_write.number(value, quantity), blankCell()});
    }
    void addExpansion(const Expansion &expansion) {
        m_expansion = m_table.rows.size();
        addCoefficient(REPORT_TEXT("report", "α machine"), expansion.machine);
        addCoefficient(REPORT_TEXT("report", "α instrument"), expansion.instrument);
    }
    /// Without the rows that state nothing, whose names are added to `rows`.
    [[nodiscard]] Table take(KeyValues &rows) {
        QStringList missing;
        Table table{m_table.columns};
        for (std::size_t i = 0; i < m_table.rows.size(); ++i) {
            const std::vector<Cell> &row = m_table.rows[i];
            if (row[1].text.plain().isEmpty() && row[2].text.plain().isEmpty()) {
                const std::vector<Span> &label = row[0].text.spans;
                missing << withinList(label.front().text.trimmed()) + QStringLiteral("\u00A0(") +
                               label.back().text + u')';
                continue;
            }
            if (i >= m_expansion && !table.rows.empty() && table.rulesAfter.empty())
                table.rulesAfter.push_back(table.rows.size() - 1);
            table.rows.push_back(row);
        }
        addNotStated(
            rows,
            joined({takeMissing(rows, m_write), missing.join(m_write.semicolon())}, m_write.semicolon()),
            m_write);
        return table;
    }

private:
    void addCoefficient(const Text &name, std::optional<double> alpha) {
        m_table.rows.push_back({label(name, Quantity::expansion),
                                m_write.numberAtLeast(alpha, Quantity::expansion, expansionDecimals),
                                blankCell()});
    }
    void addTemperatures(SensorMeasures what, const Temperatures &temperatures) {
        m_table.rows.push_back(
            {label(sensorText(what), Quantity::temperature),
             m_write.numberAtLeast(temperatures.start, Quantity::temperature, temperatureDecimals),
             m_write.numberAtLeast(temperatures.end, Quantity::temperature, temperatureDecimals)});
    }
    [[nodiscard]] Phrase label(const Text &name, Quantity quantity) const {
        return Phrase({{m_write.text(name) + QStringLiteral("\u00A0\u00A0")},
                       {m_write.language().unit(quantity), false, false, true}});
    }

    const Writer &m_write;
    Table m_table;
    std::size_t m_expansion = std::numeric_limits<std::size_t>::max(); ///< its first row
};

EnvironmentTable environment(const PositioningPart &part) {
    const PositioningConditions &conditions = part.measurement.conditions;
    EnvironmentTable table(part, conditions.common);
    table.add("airPressure", conditions.airPressure);
    table.add("airHumidity", conditions.airHumidity);
    table.add("gradientPerHour", conditions.gradientPerHour);
    const Expansion &expansion = conditions.common.expansion;
    if (part.measurement.axis.motion == Motion::linear || expansion.machine || expansion.instrument)
        table.addExpansion(expansion);
    return table;
}

/// True if a table of the sensors adds to that of the environment: positions, or several sensors per mean.
bool saysMore(const std::vector<Sensor> &sensors) {
    std::array<int, kindsOfSensors> counts{};
    return std::ranges::any_of(sensors, [&](const Sensor &sensor) {
        return !sensor.position.empty() || sensor.measures == SensorMeasures::notStated ||
               ++counts.at(static_cast<std::size_t>(sensor.measures)) > 1;
    });
}

void addSensors(std::vector<Block> &blocks, const TestPart &part) {
    auto table = sensorTable(part);
    if (!table)
        return;
    blocks.emplace_back(
        Heading{2, part.write.text(REPORT_TEXT("report", "Temperature sensors")), {}, {}, true});
    blocks.emplace_back(std::move(*table));
}

constexpr double temperatureFigureHeight = 62; ///< mm

/// Adds what is stated, beside it the environment with the `correction`; what is not stated is one row.
void addConditions(std::vector<Block> &blocks, const TestPart &part, std::optional<EnvironmentTable> table,
                   const QString &correction) {
    KeyValues rows = conditionRows(part);
    if (part.annex)
        std::erase_if(rows.rows, std::mem_fn(&KeyValue::further));
    const Table stated = table ? table->take(rows) : Table();
    if (!table)
        addNotStated(rows, takeMissing(rows, part.write), part.write);
    if (!correction.isEmpty() && stated.rows.empty())
        rows.rows.push_back(
            {part.write.text(REPORT_TEXT("report", "Correction to 20 °C")), correctionOf(part)});
    if (rows.rows.empty() && stated.rows.empty())
        return;
    addHeading(blocks, part.write.text(REPORT_TEXT("report", "Test conditions")));
    if (stated.rows.empty()) {
        blocks.emplace_back(std::move(rows));
    } else {
        SideBySide both;
        both.leftWidth = conditionsWidth;
        both.levelled = true;
        both.left.emplace_back(std::move(rows));
        both.right.emplace_back(stated);
        if (!correction.isEmpty())
            both.right.emplace_back(Paragraph{correction, TextSize::small});
        both.right.emplace_back(KeyValues{{}, conditionLabels});
        blocks.emplace_back(std::move(both));
    }
    addSensors(blocks, part);
    addTemperatureCurve(blocks, part);
}

} // namespace

Text sensorText(SensorMeasures what) {
    return inOrder(what, {REPORT_TEXT("report", "Machine"), REPORT_TEXT("report", "Instrument"),
                          REPORT_TEXT("report", "Air"), REPORT_TEXT("report", "not stated")});
}

KeyValues conditionRows(const TestPart &part) {
    return withKind(part, [](const auto &own) { return rowsOf(own); });
}

QString takeMissing(KeyValues &rows, const Writer &write) {
    QStringList missing;
    std::erase_if(rows.rows, [&](const KeyValue &row) {
        const bool isBlank = row.value.trimmed().isEmpty();
        if (isBlank)
            missing << withinList(row.key);
        return isBlank;
    });
    return missing.join(write.semicolon());
}

Temperatures temperaturesOf(const Conditions &conditions, SensorMeasures what) {
    return {statedTemperature(conditions, what, startTemperature),
            statedTemperature(conditions, what, endTemperature)};
}

bool statesTemperatures(const TestPart &part) {
    const Conditions &conditions = *conditionsOf(part.test);
    return axisOf(part.test) || withKind(part, [](const auto &own) { return own.needsLength(); }) ||
           !conditions.sensors.empty() || conditions.expansion.machine || conditions.expansion.instrument;
}

QString correctionOf(const TestPart &part) {
    const CorrectionTo20 correction = conditionsOf(part.test)->correctionTo20;
    const bool counts = correction != CorrectionTo20::notStated ||
                        withKind(part, [](const auto &own) { return own.needsLength(); });
    return counts ? part.write.text(correctionText(part.test)) : QString();
}

namespace {

/// The correction where the results are lengths, `ofLengths`; elsewhere what is stated of one, if anything.
QString correctionSentence(const auto &part, const Text &ofLengths) {
    const QString correction = correctionOf(part);
    return correction.isEmpty()
               ? QString()
               : part.write.say(part.needsLength() ? ofLengths
                                                   : REPORT_TEXT("report", "Correction to 20 °C: %1."),
                                {correction.toStdString()});
}

} // namespace

std::optional<Table> sensorTable(const TestPart &part) {
    const Writer &write = part.write;
    const std::vector<Sensor> &sensors = conditionsOf(part.test)->sensors;
    if (!saysMore(sensors))
        return std::nullopt;
    Table table;
    table.columns = {
        write.column(REPORT_TEXT("report", "Temperature of"), 30),
        write.flexible(REPORT_TEXT("report", "Position of the sensor"), 105),
        write.column(REPORT_TEXT("report", "Start"), 20, Alignment::decimal, QStringLiteral("°C")),
        write.column(REPORT_TEXT("report", "End"), 20, Alignment::decimal, QStringLiteral("°C"))};
    int decimals = 0;
    for (const Sensor &sensor : sensors) {
        for (const auto &value : {startTemperature(sensor), endTemperature(sensor)}) {
            if (value)
                decimals = std::max(decimals, decimalsOf(*value, Quantity::temperature));
        }
    }
    const auto shown = [&](std::optional<double> value) {
        return Cell(value ? write.language().number(*value, Quantity::temperature, decimals) : QString());
    };
    for (const Sensor &sensor : sensors)
        table.rows.push_back({write.text(sensorText(sensor.measures)),
                              QString::fromStdString(sensor.position), shown(startTemperature(sensor)),
                              shown(endTemperature(sensor))});
    return table;
}

void addTemperatureCurve(std::vector<Block> &blocks, const TestPart &part) {
    if (part.leavesOut(ReportPart::temperatureCurve))
        return;
    LineFigure figure = temperatureFigure(conditionsOf(part.test)->sensors, part.write.language());
    if (figure.lines.empty())
        return;
    blocks.emplace_back(Heading{2, figure.title, {}, {}, true});
    FigureBlock block{std::move(figure)};
    block.height = temperatureFigureHeight;
    block.least = temperatureFigureHeight;
    blocks.emplace_back(std::move(block));
}

void addConditions(std::vector<Block> &blocks, const PositioningPart &part) {
    addConditions(
        blocks, part, environment(part),
        correctionSentence(part, REPORT_TEXT("report", "Nominal differential expansion (NDE): %1.")));
}

void addConditions(std::vector<Block> &blocks, const CircularPart &part) {
    const Conditions &conditions = part.measurement.conditions.common;
    EnvironmentTable table(part, conditions);
    table.addExpansion(conditions.expansion);
    addConditions(blocks, part, statesTemperatures(part) ? std::optional(std::move(table)) : std::nullopt,
                  correctionSentence(part, REPORT_TEXT("report", "F and D at 20 °C: correction %1.")));
}

void addFurtherConditions(std::vector<Block> &blocks, const TestPart &part) {
    KeyValues rows = conditionRows(part);
    std::erase_if(rows.rows, std::not_fn(std::mem_fn(&KeyValue::further)));
    if (rows.rows.empty())
        return;
    addHeading(blocks, part.write.text(REPORT_TEXT("report", "Further conditions")));
    addStated(blocks, rows.rows);
}

/// Text of an agreement, followed by its number if the text does not contain it.
QString agreedText(const TestPart &part, const AgreedPoint &agreed) {
    QString text = QString::fromStdString(agreed.text);
    if (!agreed.value)
        return text;
    const Quantity quantity = agreed.point == "gradient" ? Quantity::gradient
                              : agreed.point != "feed"   ? Quantity::number
                                                         : feedQuantity(part.test);
    const QString value = part.write.language().quantity(*agreed.value, quantity);
    return text.contains(value) ? text : text.isEmpty() ? value : value + part.write.semicolon() + text;
}

std::optional<AgreedPoints> agreedPointsOf(const TestPart &part) {
    const Edition &edition = part.edition();
    const std::vector<const AgreementPoint *> further = furtherPoints(edition, part.test);
    if (edition.points.empty() && further.empty())
        return std::nullopt;
    const Writer &write = part.write;
    QString note = write.text(edition.agreedBetween);
    if (*edition.pointsClause != 0)
        note +=
            QStringLiteral(", ") + write.say(REPORT_TEXT("report", "%1, clause %2"),
                                             {std::string(edition.word), std::string(edition.pointsClause)});
    const bool letters =
        std::ranges::any_of(edition.points, [](const AgreementPoint &p) { return *p.letter != 0; });

    Table table;
    if (letters)
        table.columns.push_back(columnOf(QString(), 8));
    table.columns.push_back(write.flexible(REPORT_TEXT("report", "Point"), 82));
    table.columns.push_back(write.column(REPORT_TEXT("report", "Agreement"), 30));
    table.columns.push_back(write.column(REPORT_TEXT("report", "Agreed text"), 55));
    const auto add = [&](const AgreementPoint &point, bool asked) {
        const auto found = std::ranges::find(part.test.agreedPoints, point.point, &AgreedPoint::point);
        const bool listed = found != part.test.agreedPoints.end();
        Cell agreement;
        if (listed ? found->state == AgreementState::notApplicable
                   : roleOf(point, part.test) == PointRole::notApplicable) {
            agreement = write.text(REPORT_TEXT("report", "not applicable"));
        } else if (!listed) {
            agreement = write.text(REPORT_TEXT("report", "not declared"));
        } else if (found->state == AgreementState::agreed) {
            agreement = write.text(REPORT_TEXT("report", "agreed"));
            agreement.mark = Mark::check;
        } else {
            agreement = write.text(REPORT_TEXT("report", "not agreed"));
            agreement.mark = Mark::cross;
            agreement.bold = true;
        }
        std::vector<Cell> row;
        if (letters)
            row.emplace_back(asked ? QString::fromUtf8(point.letter) + u')' : QString());
        QString name = write.text(point.name);
        if (!name.isEmpty())
            name[0] = name[0].toUpper();
        row.emplace_back(name);
        row.push_back(agreement);
        row.emplace_back(listed ? agreedText(part, *found) : QString());
        table.rows.push_back(std::move(row));
    };
    for (const AgreementPoint &point : edition.points)
        add(point, true);
    for (const AgreementPoint *point : further) // stated, although this edition does not ask for them
        add(*point, false);
    return AgreedPoints{note, std::move(table), letters ? std::size_t(2) : std::size_t(1)};
}

void addAgreedPoints(std::vector<Block> &blocks, const TestPart &part) {
    auto points = agreedPointsOf(part);
    if (!points)
        return;
    addHeading(blocks, part.write.text(REPORT_TEXT("report", "Points to be agreed")), points->note);
    blocks.emplace_back(std::move(points->table));
}

namespace {

/// The correction added to the readings of each target.
Table correctionTable(const PositioningPart &part) {
    const Writer &write = part.write;
    const auto &targets = part.measurement.targets;
    const double reference =
        part.measurement.conditions.referencePosition.value_or(targets.empty() ? 0 : targets.front());
    const int places = positionDecimals(part.measurement);
    const QString lengthUnit = write.language().unit(part.along());
    Table table;
    const QString letter = letterOfTargets(part.edition());
    table.columns = {
        columnOf(Phrase({{letter, false, true}}), 7, Alignment::right),
        columnOf(Phrase({{QStringLiteral("P")}, {letter, true}}), 19, Alignment::decimal, lengthUnit),
        columnOf(Phrase({{QStringLiteral("P")},
                         {letter, true},
                         {QStringLiteral(" − P")},
                         {QStringLiteral("0"), true}}),
                 30, Alignment::decimal, lengthUnit),
        write.column(REPORT_TEXT("report", "Added to the readings"), 45, Alignment::decimal,
                     write.language().unit(part.deviation())),
        flexibleColumn(QString(), 74)};
    for (std::size_t i = 0; i < std::min(targets.size(), part.results.corrections.size()); ++i) {
        if (i > 0 && i % 5 == 0)
            table.rulesAfter.push_back(i - 1);
        table.rows.push_back(
            {QString::number(i + 1), write.language().number(targets[i], part.along(), places),
             write.language().number(targets[i] - reference, part.along(), places),
             write.language().number(part.results.corrections[i], part.deviation(), correctionDecimals),
             blankCell()});
    }
    return table;
}

} // namespace

void addCorrection(std::vector<Block> &blocks, const PositioningPart &part) {
    const Conditions &conditions = part.measurement.conditions.common;
    if (part.measurement.axis.motion != Motion::linear ||
        conditions.correctionTo20 != CorrectionTo20::appliedHere)
        return; // the conditions state it
    const Writer &write = part.write;
    const Expansion &alpha = conditions.expansion;
    const bool corrected = !part.results.corrections.empty();
    const auto temperature = [&](SensorMeasures what) {
        return Number{meanTemperature(conditions, what).value_or(0), Quantity::temperature, 2};
    };
    const auto expansion = [](std::optional<double> value) {
        return Number{value.value_or(0), Quantity::expansion, -1};
    };
    QString words;
    if (!corrected)
        words = write.text(
            REPORT_TEXT("report", "The correction was to be made here, but temperatures or coefficients of "
                                  "expansion are missing: nothing is corrected."));
    else if (alpha.instrument == 0.0)
        words = write.say(REPORT_TEXT("report",
                                      "Made here for the expansion of the machine (α = %1, θ = %2); the "
                                      "instrument compensates the air only."),
                          {expansion(alpha.machine), temperature(SensorMeasures::machine)});
    else
        words = write.say(
            REPORT_TEXT("report", "Made here for the expansion of the machine (α = %1, θ = %2) and of the "
                                  "instrument (α = %3, θ = %4)."),
            {expansion(alpha.machine), temperature(SensorMeasures::machine), expansion(alpha.instrument),
             temperature(SensorMeasures::instrument)});
    addHeading(blocks, write.text(REPORT_TEXT("report", "Correction to 20 °C")),
               write.text(REPORT_TEXT("report", "nominal differential expansion (NDE)")));
    blocks.emplace_back(Paragraph{words});
    if (!corrected)
        return;
    blocks.emplace_back(correctionTable(part));
}

void addCorrection(std::vector<Block> &blocks, const CircularPart &part) {
    const Conditions &conditions = part.measurement.conditions.common;
    if (!part.needsLength() || conditions.correctionTo20 != CorrectionTo20::appliedHere)
        return; // the conditions state it
    const Writer &write = part.write;
    const std::optional<double> &correction = part.results.correction;
    const QString words = write.text(
        correction
            ? REPORT_TEXT("report", "Made here for F and D; temperatures are means of those stated.")
            : REPORT_TEXT("report", "The correction was to be made here, but temperatures or coefficients of "
                                    "expansion are missing: nothing is corrected."));
    addHeading(blocks, write.text(REPORT_TEXT("report", "Correction to 20 °C")),
               correction ? phraseFrom(QStringLiteral("C = R·[α_i·(T_i − 20) − α_m·(T_m − 20)]")) : Phrase());
    blocks.emplace_back(Paragraph{words});
    if (!correction)
        return;
    struct Factor {
        const char *symbol = nullptr;
        Quantity quantity = Quantity::number;
        std::optional<double> value;
        int decimals = 0;
    };
    const std::array factors{
        Factor{"R", Quantity::position, part.measurement.nominalRadius, -1},
        Factor{"α_i", Quantity::expansion, conditions.expansion.instrument, -1},
        Factor{"T_i", Quantity::temperature, meanTemperature(conditions, SensorMeasures::instrument), 2},
        Factor{"α_m", Quantity::expansion, conditions.expansion.machine, -1},
        Factor{"T_m", Quantity::temperature, meanTemperature(conditions, SensorMeasures::machine), 2},
        Factor{"C", Quantity::deviation, correction, correctionDecimals}};
    Table table;
    table.rows.emplace_back();
    for (const Factor &factor : factors) {
        table.columns.push_back(columnOf(phraseFrom(QString::fromUtf8(factor.symbol)), 22, Alignment::decimal,
                                         write.language().unit(factor.quantity)));
        table.rows.front().emplace_back(
            factor.value ? write.language().number(certain(*factor.value), factor.quantity, factor.decimals)
                         : QString());
    }
    table.columns.push_back(flexibleColumn(QString(), 43));
    table.rows.front().push_back(blankCell());
    blocks.emplace_back(std::move(table));
}

QString pointText(const Writer &write, const Point3 &point) {
    if (std::ranges::none_of(point, [](const auto &x) { return x.has_value(); }))
        return {};
    constexpr std::array letters{'X', 'Y', 'Z'};
    QStringList texts;
    for (std::size_t i = 0; i < point.size(); ++i)
        texts << QLatin1Char(letters[i]) + QStringLiteral("\u00A0") +
                     (point[i] ? write.language().number(certain(*point[i]), Quantity::position)
                               : QStringLiteral("–"));
    return texts.join(write.semicolon());
}

} // namespace palmer
