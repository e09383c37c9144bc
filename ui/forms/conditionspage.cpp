// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/forms/conditionspage.h"

#include "document/edits.h"
#include "document/fieldvalue.h"
#include "document/filewords.h"
#include "document/statedthings.h"
#include "kernel/evaluation/agreedpoints.h"
#include "kernel/evaluation/iso230_4/circularcase.h"
#include "language/decimals.h"
#include "report/words/correctiontext.h"
#include "ui/forms/agreedvalue.h"
#include "ui/forms/templatebutton.h"
#include "ui/madewidgets.h"
#include "ui/theme.h"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <array>

namespace palmer::ui {

namespace {

constexpr const char *conditionsContext = "palmer::ui::ConditionsPage";
constexpr std::array kinds{SensorMeasures::air, SensorMeasures::machine, SensorMeasures::instrument,
                           SensorMeasures::notStated};

/// A member of the conditions shared by positioning and circular tests.
template <auto part, auto member>
auto commonPart() {
    return ofTest([](auto &test) {
        auto *conditions = conditionsOf(test);
        return conditions ? &(conditions->*part.*member) : nullptr;
    });
}

template <auto point, std::size_t axis>
auto coordinate() {
    return ofTest([](auto &test) {
        auto *conditions = conditionsOf(test);
        return conditions ? &(conditions->*point)[axis] : nullptr;
    });
}

/// A member of a positioning test or of a part of it.
template <auto... members>
auto positioning() {
    return ofMeasurement<PositioningMeasurement, members...>();
}

template <auto... members>
auto circular() {
    return ofMeasurement<CircularMeasurement, members...>();
}

/// A member of a sensor; the first statement creates the sensor.
template <auto member>
auto ofSensor(SensorMeasures what, std::size_t ordinal) {
    using T = std::remove_cvref_t<decltype(std::declval<Sensor &>().*member)>;
    return Member<T>{[what, ordinal](const FormSource &source) {
                         const Conditions *conditions = source.test ? conditionsOf(*source.test) : nullptr;
                         const Sensor *sensor = conditions ? sensorOf(*conditions, what, ordinal) : nullptr;
                         return sensor ? sensor->*member : T();
                     },
                     [what, ordinal](Document &document, std::size_t index, const T &value) {
                         editTest(document, index, [&](Test &test) {
                             if (Conditions *conditions = conditionsOf(test))
                                 editSensor(*conditions, what, ordinal,
                                            [&](Sensor &sensor) { sensor.*member = value; });
                         });
                     }};
}

/// Start or end temperature, taken from a series if not stated.
Member<std::optional<double>> startOf(SensorMeasures what, std::size_t ordinal) {
    auto member = ofSensor<&Sensor::start>(what, ordinal);
    member.read = [what, ordinal](const FormSource &source) {
        const Conditions *conditions = source.test ? conditionsOf(*source.test) : nullptr;
        const Sensor *sensor = conditions ? sensorOf(*conditions, what, ordinal) : nullptr;
        return sensor ? startTemperature(*sensor) : std::nullopt;
    };
    return member;
}
Member<std::optional<double>> endOf(SensorMeasures what, std::size_t ordinal) {
    auto member = ofSensor<&Sensor::end>(what, ordinal);
    member.read = [what, ordinal](const FormSource &source) {
        const Conditions *conditions = source.test ? conditionsOf(*source.test) : nullptr;
        const Sensor *sensor = conditions ? sensorOf(*conditions, what, ordinal) : nullptr;
        return sensor ? endTemperature(*sensor) : std::nullopt;
    };
    return member;
}

struct SensorLabels {
    const char *start = nullptr;
    const char *end = nullptr;
};
SensorLabels labelsOf(SensorMeasures what, bool another) {
    switch (what) {
    case SensorMeasures::air:
        return another ? SensorLabels{QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Air %1, start"),
                                      QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Air %1, end")}
                       : SensorLabels{QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Air, start"),
                                      QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Air, end")};
    case SensorMeasures::machine:
        return another ? SensorLabels{QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Machine %1, start"),
                                      QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Machine %1, end")}
                       : SensorLabels{QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Machine, start"),
                                      QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Machine, end")};
    case SensorMeasures::notStated:
        return {QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Unassigned sensor, start"),
                QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Unassigned sensor, end")};
    case SensorMeasures::instrument:
        break;
    }
    return another ? SensorLabels{QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Instrument %1, start"),
                                  QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Instrument %1, end")}
                   : SensorLabels{QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Instrument, start"),
                                  QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Instrument, end")};
}

/// Number of faces of the polygon, an integer.
Member<std::optional<double>> faces() {
    const auto member = positioning<&PositioningMeasurement::targetChoice, &TargetChoice::faces>();
    return {[member](const FormSource &source) -> std::optional<double> {
                const auto value = member.read(source);
                return value ? std::optional<double>(*value) : std::nullopt;
            },
            [member](Document &document, std::size_t index, const std::optional<double> &value) {
                member.write(document, index,
                             value && *value < 1e6 ? std::optional(std::max(1, static_cast<int>(*value)))
                                                   : std::nullopt);
            }};
}

/// A requirement that only a declaration can meet.
struct Declaration {
    const char *id = nullptr;  ///< of its requirement
    const char *key = nullptr; ///< of its field
};
constexpr std::array declarations{Declaration{"soak", "stabilised"}, Declaration{"shielded", "shielded"},
                                  Declaration{"complete", "complete"}, Declaration{"levelled", "levelled"},
                                  Declaration{"unloaded", "unloaded"}};

std::optional<bool> declared(const Test &test, const Declaration &declaration) {
    return std::get<std::optional<bool>>(fieldValue(test, declaration.key));
}

/// The clause of the edition that requires it; empty if the clause is unknown.
std::string clauseOf(const Edition &edition, std::string_view id) {
    const auto in = [id](const auto &rows) -> std::string {
        for (const auto &row : rows) {
            if (row.id == id)
                return row.clause;
        }
        return {};
    };
    return edition.circles ? in(edition.circles->requirements) : in(edition.requirements);
}

std::size_t shownSensors(const Conditions &conditions, SensorMeasures what) {
    const std::size_t least = what == SensorMeasures::notStated ? 0 : 1;
    return std::max(least, countSensors(conditions, what));
}

} // namespace

ConditionsPage::ConditionsPage(DocumentModel &model, Selection &selection, QWidget *parent)
    : Form(conditionsContext, Page::conditions, model, parent) {
    follow(selection);
    addToBar(new TemplateButton(TemplateButton::Kind::conditions, model, selection, this));
    setObjectName(QStringLiteral("conditionsPage"));
    body()->setObjectName(QStringLiteral("conditionsFields"));
    refresh();
}

void ConditionsPage::prepare() {
    const Test *shown = shownTest();
    const Conditions *conditions = shown ? conditionsOf(*shown) : nullptr;
    const Edition *edition = shown ? findEdition(shown->edition) : nullptr;
    QString wanted = QStringLiteral("none");
    if (conditions) {
        wanted = QString::fromLatin1(fileWord(kindOf(*shown))) + u' ' +
                 QLatin1StringView(fileWord(motionOf(*shown)));
        wanted += edition && edition->rangeMethod ? QStringLiteral(" range") : QString();
        wanted += edition ? u' ' + QString::fromUtf8(edition->family) : QString();
        for (const SensorMeasures what : kinds)
            wanted += u' ' + QString::number(shownSensors(*conditions, what));
        for (const Instrument &instrument : evaluated().document->instruments)
            wanted += u' ' + QString::fromStdString(instrument.id);
    }
    if (wanted == m_built)
        return;
    m_built = wanted;
    m_instruments.clear();
    m_correction = nullptr;
    clear();
    if (!conditions)
        return;
    std::visit(
        [this](const auto &measurement) {
            if constexpr (requires { measurement.conditions; })
                addFields(measurement);
        },
        shown->measurement);
}

template <class Measurement>
void ConditionsPage::addFields(const Measurement &measurement) {
    addTestAndPurpose();
    addAxis(measurement);
    addTemperatures(measurement.conditions.common);
    addAir(measurement);
    addDeclarations(findEdition(shownTest()->edition));
    addFoldingSection(QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Cycle and load"));
    beginColumns();
    addCycle(measurement);
    addWarmUp();
    addAgreedCycle(measurement);
    addThings(FieldForm::Section::load);
    addPositions();
    addPlace(measurement);
    addFoldingSection(QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Remarks"));
    beginColumns();
    addLongText({"", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Remarks on the test")},
                ofTest([](auto &test) { return &test.remarks; }), 12);
    addStretch();
}

void ConditionsPage::addSensor(SensorMeasures what, std::size_t ordinal) {
    beginColumns();
    const SensorLabels labels = labelsOf(what, ordinal > 0);
    const QString argument = ordinal > 0 ? QString::number(ordinal + 1) : QString();
    Field *start = addNumber({"sensors", labels.start}, Quantity::temperature, startOf(what, ordinal), 3,
                             Allowed::celsius);
    start->setLabelArgument(argument);
    addNumber({"sensors", labels.end}, Quantity::temperature, endOf(what, ordinal), 3, Allowed::celsius)
        ->setLabelArgument(argument);
    addText({"sensors", QT_TR_NOOP("Sensor position")}, ofSensor<&Sensor::position>(what, ordinal),
            what == SensorMeasures::air && ordinal == 0 ? 6 : 3); // the others have something next to them
    m_lastSensors[what] = start;
}

void ConditionsPage::addTemperatures(const Conditions &conditions) {
    addFoldingSection(QT_TR_NOOP("Temperatures"), [this] { return temperatureSummary(); });
    for (const SensorMeasures what : kinds) {
        const std::size_t count = shownSensors(conditions, what);
        for (std::size_t ordinal = 0; ordinal < count; ++ordinal) {
            addSensor(what, ordinal);
            if (ordinal > 0 || what == SensorMeasures::notStated) {
                addButton(
                    QT_TR_NOOP("Remove the sensor"),
                    [this, what, ordinal] {
                        edit(QT_TRANSLATE_NOOP("edits", "remove a sensor"), [&](Document &document) {
                            editTest(document, this->test(), [&](Test &changed) {
                                removeSensor(*conditionsOf(changed), what, ordinal);
                            });
                        });
                    },
                    3);
            } else if (what == SensorMeasures::machine) {
                addNumber({"expansion", QT_TR_NOOP("Expansion α")}, Quantity::expansion,
                          commonPart<&Conditions::expansion, &Expansion::machine>(), 3, Allowed::coefficient);
            } else if (what == SensorMeasures::instrument) {
                addNumber({"expansion", QT_TR_NOOP("Expansion α")}, Quantity::expansion,
                          commonPart<&Conditions::expansion, &Expansion::instrument>(), 3,
                          Allowed::coefficient);
            }
        }
    }
    addCorrection();
    addSensorButtons();
    addThings(FieldForm::Section::room);
}

/// Adds the correction wide enough for its texts, with its size next to it.
void ConditionsPage::addCorrection() {
    beginColumns();
    addThing("correctionTo20", 5);
    m_correction = made<QLabel>("correctionSize", TextSize::small, trait::secondary, trait::wrapped, body());
    m_correction->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_correction->setContentsMargins(0, Field::headHeight, 0, 0); // level with the field, not its label
    addWidget(m_correction, 7);
}

void ConditionsPage::addSensorButtons() {
    beginRow(); // buttons are as wide as their texts
    const auto addOne = [this](const char *text, SensorMeasures what, const QString &name) {
        addButton(text, [this, what] {
            edit(QT_TRANSLATE_NOOP("edits", "add a sensor"), [&](Document &document) {
                editTest(document, this->test(), [&](Test &changed) {
                    Conditions &kept = *conditionsOf(changed);
                    Sensor sensor;
                    sensor.measures = what;
                    // The first row is shown even without a sensor.
                    const std::size_t rows = shownSensors(kept, what) + 1;
                    while (countSensors(kept, what) < rows)
                        kept.sensors.push_back(sensor);
                });
            });
            focusPart(*m_lastSensors.at(what));
        })->setObjectName(name);
    };
    addOne(QT_TR_NOOP("Another air sensor"), SensorMeasures::air, QStringLiteral("addAirSensor"));
    addOne(QT_TR_NOOP("Another machine sensor"), SensorMeasures::machine, QStringLiteral("addMachineSensor"));
    addOne(QT_TR_NOOP("Another instrument sensor"), SensorMeasures::instrument,
           QStringLiteral("addInstrumentSensor"));
    addWidget(new QWidget(body()));
}

/// Linear and rotary axes alike: statements needed for a laser and for room temperature drift.
void ConditionsPage::addAir(const PositioningMeasurement & /*measurement*/) {
    addThings(FieldForm::Section::air);
    beginColumns();
    addThing("gradientHoursBefore", 6);
    addNumber({"gradient", QT_TR_NOOP("Agreed limit of the gradient")}, Quantity::gradient,
              agreedValue("gradient"), 6);
}

void ConditionsPage::addCycle(const PositioningMeasurement & /*measurement*/) {
    for (const char *thing : {"feed", "feedMode", "dwell", "approachDistance"})
        addThing(thing, 3);
}

void ConditionsPage::addCycle(const CircularMeasurement & /*measurement*/) {
    addNumber({"feed", QT_TR_NOOP("Contouring feed")}, Quantity::feed, circular<&CircularMeasurement::feed>(),
              4);
    addThings(FieldForm::Section::circle, 4);
}

void ConditionsPage::addWarmUp() {
    beginColumns();
    addWords("warmUp", commonPart<&Conditions::warmUp, &WarmUp::kind>(), 6);
    addText({"", QT_TR_NOOP("Warm-up, details")}, commonPart<&Conditions::warmUp, &WarmUp::text>(), 6);
}

void ConditionsPage::addSpecifiedBy(int width) {
    beginColumns();
    addChoice({"warmUp", QT_TR_NOOP("Warm-up specified by")},
              {QT_TR_NOOP("not stated"), QT_TR_NOOP("the maker"), QT_TR_NOOP("agreement")},
              choiceOf<SpecifiedBy>(commonPart<&Conditions::warmUp, &WarmUp::specifiedBy>(),
                                    {SpecifiedBy::notStated, SpecifiedBy::maker, SpecifiedBy::agreement}),
              true, width);
}

void ConditionsPage::addAgreedCycle(const PositioningMeasurement &measurement) {
    const bool isRotary = measurement.axis.motion == Motion::rotary;
    const int width = isRotary ? 4 : 6; // three or two in a row
    addSpecifiedBy(width);
    addNumber({"feed", QT_TR_NOOP("Agreed feed rate")}, feedQuantity(*shownTest()), agreedValue("feed"),
              width);
    if (isRotary)
        addThing("continuousDevice", width);
}

void ConditionsPage::addAgreedCycle(const CircularMeasurement & /*measurement*/) {
    addSpecifiedBy(4);
    addNumber({"", QT_TR_NOOP("Specified diameter")}, Quantity::position,
              circular<&CircularMeasurement::specified, &SpecifiedCircle::diameter>(), 4, Allowed::positive);
    addNumber({"", QT_TR_NOOP("Specified feed")}, Quantity::feed,
              circular<&CircularMeasurement::specified, &SpecifiedCircle::feed>(), 4, Allowed::positive);
}

void ConditionsPage::addDeclarations(const Edition *edition) {
    addFoldingSection(QT_TR_NOOP("Declarations"), [this] { return declarationSummary(); });
    addSectionButton(QT_TR_NOOP("All of these apply"), [this] {
        edit(QT_TRANSLATE_NOOP("edits", "declare what was not declared"), [&](Document &document) {
            editTest(document, this->test(), [](Test &changed) {
                for (const Declaration &declaration : declarations)
                    setFieldValue(changed, declaration.key,
                                  std::optional(declared(changed, declaration).value_or(true)));
            });
        });
    })->setObjectName(QStringLiteral("allApply"));
    std::vector<std::string> clauses;
    for (const Declaration &declaration : declarations) {
        const std::string clause = edition ? clauseOf(*edition, declaration.id) : std::string();
        if (std::ranges::find(clauses, clause) == clauses.end())
            clauses.push_back(clause);
    }
    for (const std::string &clause : clauses)
        addDeclarationsOf(edition, clause);
    beginColumns();
    addText({"", QT_TR_NOOP("Rest of the requirements declared met by")},
            ofTest([](auto &test) { return &test.declaredAccordance.by; }), 6);
    addDate({"", QT_TR_NOOP("Declared on")}, ofTest([](auto &test) { return &test.declaredAccordance.date; }),
            6);
    beginColumns();
    addText({"", QT_TR_NOOP("Text of the declaration")},
            ofTest([](auto &test) { return &test.declaredAccordance.text; }), 12);
}

/// The declarations of one clause next to its number, two per row because of their long labels.
void ConditionsPage::addDeclarationsOf(const Edition *edition, const std::string &clause) {
    constexpr int inRow = 2;
    int count = 0;
    for (const Declaration &declaration : declarations) {
        if (clause != (edition ? clauseOf(*edition, declaration.id) : std::string()))
            continue;
        const bool begins = count++ % inRow == 0;
        if (begins) {
            beginColumns();
            if (!clause.empty()) {
                auto *label = new QLabel(count == 1 ? QString::fromStdString(clause) : QString(), body());
                label->setProperty("secondary", true);
                addWidget(label);
            }
        }
        addThing(declaration.key, begins && !clause.empty() ? 5 : 6);
    }
}

void ConditionsPage::addPositions() {
    constexpr auto position = Quantity::position;
    addFoldingSection(QT_TR_NOOP("Positions"));
    addThings(FieldForm::Section::positions);
    beginColumns();
    addNumber({"toolOffset", QT_TR_NOOP("Offset to tool, X")}, position,
              coordinate<&Conditions::toolOffset, 0>(), 4);
    addNumber({"toolOffset", QT_TR_NOOP("Offset to tool, Y")}, position,
              coordinate<&Conditions::toolOffset, 1>(), 4);
    addNumber({"toolOffset", QT_TR_NOOP("Offset to tool, Z")}, position,
              coordinate<&Conditions::toolOffset, 2>(), 4);
    beginColumns();
    addNumber({"workpieceOffset", QT_TR_NOOP("Offset to workpiece, X")}, position,
              coordinate<&Conditions::workpieceOffset, 0>(), 4);
    addNumber({"workpieceOffset", QT_TR_NOOP("Offset to workpiece, Y")}, position,
              coordinate<&Conditions::workpieceOffset, 1>(), 4);
    addNumber({"workpieceOffset", QT_TR_NOOP("Offset to workpiece, Z")}, position,
              coordinate<&Conditions::workpieceOffset, 2>(), 4);
}

void ConditionsPage::addPlace(const CircularMeasurement & /*measurement*/) {
    constexpr auto position = Quantity::position;
    const auto centre = []<std::size_t axis>() {
        return circular<&CircularMeasurement::conditions, &CircularConditions::centre, axis>();
    };
    beginColumns();
    addNumber({"centre", QT_TR_NOOP("Centre of the circle, X")}, position, centre.operator()<0>(), 4);
    addNumber({"centre", QT_TR_NOOP("Centre of the circle, Y")}, position, centre.operator()<1>(), 4);
    addNumber({"centre", QT_TR_NOOP("Centre of the circle, Z")}, position, centre.operator()<2>(), 4);
    addThings(FieldForm::Section::points);
}

void ConditionsPage::addTestAndPurpose() {
    addFoldingSection(QT_TR_NOOP("Test and axis"));
    beginColumns();
    addText({"", QT_TR_NOOP("Title of the test")}, ofTest([](auto &test) { return &test.title; }), 5);
    addDate("date", ofTest([](auto &test) { return &test.date; }), 4);
    addTime({"", QT_TR_NOOP("Time")}, ofTest([](auto &test) { return &test.time; }), 3);
    beginColumns();
    addThing("purpose", 6);
    addThing("role", 6);
    addInstruments();
}

void ConditionsPage::addAxis(const CircularMeasurement & /*measurement*/) {
    beginColumns();
    addThing("positionFeedback", 6);
    addYesNo({"referenceLength", QT_TR_NOOP("Reference length calibrated")},
             circular<&CircularMeasurement::referenceLength, &ReferenceLength::calibrated>(), 6);
}

void ConditionsPage::addAxis(const PositioningMeasurement &measurement) {
    using Measurement = PositioningMeasurement;
    const Quantity position = positionQuantity(measurement.axis);
    beginColumns();
    addText({"name", QT_TR_NOOP("Axis")}, positioning<&Measurement::axis, &Axis::name>(), 2);
    addChoice(
        {"", QT_TR_NOOP("Motion")}, {QT_TR_NOOP("linear"), QT_TR_NOOP("rotary")},
        choiceOf<Motion>(positioning<&Measurement::axis, &Axis::motion>(), {Motion::linear, Motion::rotary}),
        false, 3);
    addNumber("travel", position, positioning<&Measurement::axis, &Axis::travel>(), 3, Allowed::positive);
    addInterval("range", position, positioning<&Measurement::axis, &Axis::range>(), 4);
    beginColumns();
    addText("positionFeedback", positioning<&Measurement::axis, &Axis::positionFeedback>(), 4);
    addInterval("zone", position, positioning<&Measurement::zone>(), 4);
    addThing("referencePosition", 4);
    addTargets(measurement);
}

void ConditionsPage::addTargets(const PositioningMeasurement &measurement) {
    using Measurement = PositioningMeasurement;
    const Quantity position = positionQuantity(measurement.axis);
    beginColumns();
    addWords("targetChoice", positioning<&Measurement::targetChoice, &TargetChoice::kind>(), 4);
    addNumber({"", QT_TR_NOOP("Nominal interval")}, position,
              positioning<&Measurement::targetChoice, &TargetChoice::interval>(), 4);
    addNumber({"", QT_TR_NOOP("Period of the error")}, position,
              positioning<&Measurement::targetChoice, &TargetChoice::period>(), 4);
    beginColumns();
    addNumber({"faces", QT_TR_NOOP("Faces of the polygon, number")}, Quantity::count, faces(), 6,
              Allowed::positive);
    if (measurement.axis.motion == Motion::linear)
        addNumber({"scaleElement", QT_TR_NOOP("Element of the scale (0: continuous)")}, position,
                  positioning<&Measurement::axis, &Axis::scaleElement>(), 6, Allowed::notNegative);
    beginColumns();
    addThing("cycle", 6);
    if (m_built.contains(QStringLiteral(" range"))) {
        addChoice({"", QT_TR_NOOP("Standard deviation")},
                  {QT_TR_NOOP("by calculation"), QT_TR_NOOP("by the range method")},
                  choiceOf<DeviationMethod>(positioning<&Measurement::standardDeviation>(),
                                            {DeviationMethod::calculation, DeviationMethod::range}),
                  false, 6);
    }
}

/// Checkboxes for the instruments used in the test.
void ConditionsPage::addInstruments() {
    const auto &instruments = evaluated().document->instruments;
    if (instruments.empty())
        return;
    for (const Instrument &instrument : instruments) {
        beginColumns();
        auto *box = made<QCheckBox>(QStringLiteral("uses.") + QString::fromStdString(instrument.id), body());
        addWidget(box, 12);
        m_instruments.push_back(box);
        connect(box, &QCheckBox::clicked, this, [this, id = instrument.id](bool used) {
            edit(QT_TRANSLATE_NOOP("edits", "change the instruments of the test"), [&](Document &document) {
                editTest(document, this->test(), [&](Test &changed) {
                    std::erase(changed.instruments, id);
                    if (used)
                        changed.instruments.push_back(id);
                });
            });
        });
    }
    sectionNeeds("instruments");
}

/// The first sensor of each kind.
QString ConditionsPage::temperatureSummary() const {
    const Test *shown = shownTest();
    const Conditions *conditions = shown ? conditionsOf(*shown) : nullptr;
    QStringList parts;
    for (const SensorMeasures what : kinds) {
        const Sensor *sensor = conditions ? sensorOf(*conditions, what, 0) : nullptr;
        const auto start = sensor ? startTemperature(*sensor) : std::nullopt;
        const auto end = sensor ? endTemperature(*sensor) : std::nullopt;
        if (!start && !end)
            continue;
        const double from = start.value_or(end.value_or(0));
        const double until = end.value_or(from);
        const QString last = language().quantity(until, Quantity::temperature);
        const QString range =
            from == until ? last
                          : language().number(from, Quantity::temperature) + QStringLiteral(" … ") + last;
        parts << (what == SensorMeasures::air          ? tr("air %1").arg(range)
                  : what == SensorMeasures::machine    ? tr("machine %1").arg(range)
                  : what == SensorMeasures::instrument ? tr("instrument %1").arg(range)
                                                       : range);
    }
    return parts.join(QStringLiteral(" · "));
}

/// Lists declarations that do not apply by name and counts the others.
QString ConditionsPage::declarationSummary() const {
    const Test *shown = shownTest();
    QStringList parts;
    int apply = 0;
    for (const Declaration &declaration : declarations) {
        const std::optional<bool> applies = shown ? declared(*shown, declaration) : std::nullopt;
        apply += applies == true;
        if (applies == false)
            parts << tr("%1: no").arg(word(statedThing(declaration.key)->name.source));
    }
    parts << tr("%1 of %2 apply").arg(apply).arg(declarations.size());
    return parts.join(QStringLiteral(" · "));
}

bool ConditionsPage::focusField(const QString &id) {
    if (id != QLatin1StringView("instruments") || m_instruments.empty())
        return Form::focusField(id);
    showPart(*m_instruments.front());
    m_instruments.front()->setFocus(Qt::OtherFocusReason);
    return true;
}

void ConditionsPage::refreshOthers() {
    const Test *shown = shownTest();
    if (shown && m_correction) {
        const QString size = correctionSizeText(*shown, language());
        m_correction->setVisible(motionOf(*shown) == Motion::linear);
        m_correction->setText(size.isEmpty()
                                  ? tr("Its size is known when temperatures and expansions are stated.")
                                  : tr("Correction to 20 °C: %1.").arg(size));
    }
    const auto &instruments = evaluated().document->instruments;
    for (std::size_t i = 0; shown && i < m_instruments.size() && i < instruments.size(); ++i) {
        const QString name = QString::fromStdString(
            instruments[i].description.empty() ? instruments[i].id : instruments[i].description);
        m_instruments[i]->setText(
            tr("Measured with: %1").arg(QString(name).replace(u'&', QStringLiteral("&&"))));
        m_instruments[i]->setChecked(std::ranges::find(shown->instruments, instruments[i].id) !=
                                     shown->instruments.end());
    }
}

} // namespace palmer::ui
