// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/forms/conditionspage.h"

#include "document/conditionsform.h"
#include "document/edits.h"
#include "document/fieldvalue.h"
#include "document/filewords.h"
#include "document/statedthings.h"
#include "language/decimals.h"
#include "report/words/correctiontext.h"
#include "ui/elidedlabel.h"
#include "ui/forms/templatebutton.h"
#include "ui/madewidgets.h"
#include "ui/theme.h"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QShowEvent>
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

Quantity positionsOf(const Test *test) {
    const Axis *axis = test ? axisOf(*test) : nullptr;
    return axis ? positionQuantity(*axis) : Quantity::position;
}

std::size_t shownSensors(const Conditions &conditions, SensorMeasures what) {
    const std::size_t least = what == SensorMeasures::notStated ? 0 : 1;
    return std::max(least, countSensors(conditions, what));
}

} // namespace

ConditionsPage::ConditionsPage(DocumentModel &model, Selection &selection, QWidget *parent)
    : Form(conditionsContext, Page::conditions, model, parent) {
    follow(selection);
    m_like = made<QPushButton>("likeLast", trait::notDefault, this);
    connect(m_like, &QPushButton::clicked, this, &ConditionsPage::likeLastWanted);
    addToBar(m_like);
    addToBar(new TemplateButton(TemplateButton::Kind::conditions, model, selection, this));
    setObjectName(QStringLiteral("conditionsPage"));
    body()->setObjectName(QStringLiteral("conditionsFields"));
    refresh();
}

/// Groups in which the edition misses something come first, as they were when the page came into view or
/// shows another test: nothing moves while the user works.
void ConditionsPage::order(std::vector<FormGroup> &groups) {
    const Test &shown = *shownTest();
    const TestEvaluation &evaluation = *evaluated().tests[test()];
    const QString of = QString::fromStdString(shown.id) + u' ' +
                       QString::fromUtf8(evaluation.edition ? evaluation.edition->word : "");
    if ((m_isOrderDue || of != m_ordered) && !evaluated().isPending(test())) {
        m_isOrderDue = false;
        m_ordered = of;
        m_first.clear();
        for (const FormGroup &group : groups) {
            if (group.lacks)
                m_first.insert(group.name.source);
        }
    }
    std::stable_partition(groups.begin(), groups.end(),
                          [this](const FormGroup &group) { return m_first.contains(group.name.source); });
}

void ConditionsPage::showEvent(QShowEvent *event) {
    if (!event->spontaneous()) {
        m_isOrderDue = true;
        refresh();
    }
    Form::showEvent(event);
}

void ConditionsPage::prepare() {
    const Test *shown = shownTest();
    const Conditions *conditions = shown ? conditionsOf(*shown) : nullptr;
    ConditionsForm form;
    QString wanted = QStringLiteral("none");
    if (conditions) {
        form = conditionsForm(*shown, *evaluated().tests[test()]);
        order(form.asked);
        wanted = QLatin1StringView(fileWord(motionOf(*shown)));
        for (const auto *groups : {&form.asked, &form.usual, &form.other}) {
            wanted += u'/';
            for (const FormGroup &group : *groups) {
                wanted += u' ' + QString::fromUtf8(group.name.source);
                for (const FormCell &cell : group.cells)
                    wanted += u' ' + QString::fromUtf8(cell.key.data());
            }
        }
        for (const SensorMeasures what : kinds)
            wanted += u' ' + QString::number(shownSensors(*conditions, what));
        for (const Instrument &instrument : evaluated().document->instruments)
            wanted += u' ' + QString::fromStdString(instrument.id);
    }
    if (wanted == m_built)
        return;
    m_built = wanted;
    m_instruments.clear();
    m_clauses.clear();
    m_correction = nullptr;
    clear();
    if (!conditions)
        return;
    addGroups(form.asked);
    if (!form.usual.empty()) {
        addFoldingSection(QT_TR_NOOP("Usual in practice"));
        addGroups(form.usual);
    }
    addFoldingSection(QT_TR_NOOP("Further statements"));
    addGroups(form.other);
    addStretch();
}

void ConditionsPage::addGroups(const std::vector<FormGroup> &groups) {
    for (const FormGroup &group : groups) {
        beginGroup(group.name.source);
        for (const FormCell &cell : group.cells)
            addCell(cell);
    }
}

/// A statement under its key alone, or one that has several parts or does not belong to test or conditions.
void ConditionsPage::addCell(const FormCell &cell) {
    using M = PositioningMeasurement;
    using C = CircularMeasurement;
    using Make = void (*)(ConditionsPage &, const Topic &, int columns);
    struct Own {
        std::string_view key;
        std::string_view part;
        Make make;
    };
    // clang-format off
    static const std::array own{
        Own{"title", "", [](auto &p, auto &t, int n) { p.addText(t, ofTest([](auto &test) { return &test.title; }), n); }},
        Own{"date", "", [](auto &p, auto &t, int n) { p.addDate(t, ofTest([](auto &test) { return &test.date; }), n); }},
        Own{"time", "", [](auto &p, auto &t, int n) { p.addTime(t, ofTest([](auto &test) { return &test.time; }), n); }},
        Own{"instruments", "", [](auto &p, auto &, int) { p.addInstruments(); }},
        Own{"name", "", [](auto &p, auto &t, int n) { p.addText(t, positioning<&M::axis, &Axis::name>(), n); }},
        Own{"motion", "", [](auto &p, auto &t, int n) { p.addChoice(t, {QT_TR_NOOP("linear"), QT_TR_NOOP("rotary")}, choiceOf<Motion>(positioning<&M::axis, &Axis::motion>(), {Motion::linear, Motion::rotary}), false, n); }},
        Own{"travel", "", [](auto &p, auto &t, int n) { p.addNumber(t, positionsOf(p.shownTest()), positioning<&M::axis, &Axis::travel>(), n, Allowed::positive); }},
        Own{"range", "", [](auto &p, auto &t, int n) { p.addInterval(t, positionsOf(p.shownTest()), positioning<&M::axis, &Axis::range>(), n); }},
        Own{"positionFeedback", "", [](auto &p, auto &t, int n) { axisOf(*p.shownTest()) ? p.addText(t, positioning<&M::axis, &Axis::positionFeedback>(), n) : p.addText(t, circular<&C::positionFeedback>(), n); }},
        Own{"zone", "", [](auto &p, auto &t, int n) { p.addInterval(t, positionsOf(p.shownTest()), positioning<&M::zone>(), n); }},
        Own{"scaleElement", "", [](auto &p, auto &t, int n) { p.addNumber(t, positionsOf(p.shownTest()), positioning<&M::axis, &Axis::scaleElement>(), n, Allowed::notNegative); }},
        Own{"standardDeviation", "", [](auto &p, auto &t, int n) { p.addChoice(t, {QT_TR_NOOP("by calculation"), QT_TR_NOOP("by the range method")}, choiceOf<DeviationMethod>(positioning<&M::standardDeviation>(), {DeviationMethod::calculation, DeviationMethod::range}), false, n); }},
        Own{"targetChoice", "kind", [](auto &p, auto &t, int n) { p.addWords(t, positioning<&M::targetChoice, &TargetChoice::kind>(), n); }},
        Own{"targetChoice", "interval", [](auto &p, auto &t, int n) { p.addNumber({"", t.label}, positionsOf(p.shownTest()), positioning<&M::targetChoice, &TargetChoice::interval>(), n, Allowed::positive); }},
        Own{"targetChoice", "period", [](auto &p, auto &t, int n) { p.addNumber({"", t.label}, positionsOf(p.shownTest()), positioning<&M::targetChoice, &TargetChoice::period>(), n, Allowed::positive); }},
        Own{"faces", "", [](auto &p, auto &t, int n) { p.addNumber(t, Quantity::count, faces(), n, Allowed::positive); }},
        Own{"referenceLength", "", [](auto &p, auto &t, int n) { p.addYesNo(t, circular<&C::referenceLength, &ReferenceLength::calibrated>(), n); }},
        Own{"specified", "diameter", [](auto &p, auto &t, int n) { p.addNumber({"", t.label}, Quantity::position, circular<&C::specified, &SpecifiedCircle::diameter>(), n, Allowed::positive); }},
        Own{"specified", "feed", [](auto &p, auto &t, int n) { p.addNumber({"", t.label}, Quantity::feed, circular<&C::specified, &SpecifiedCircle::feed>(), n, Allowed::positive); }},
        Own{"sensors", "", [](auto &p, auto &, int) { p.addTemperatures(*conditionsOf(*p.shownTest())); }},
        Own{"warmUp", "kind", [](auto &p, auto &t, int n) { p.addWords(t, commonPart<&Conditions::warmUp, &WarmUp::kind>(), n); }},
        Own{"warmUp", "text", [](auto &p, auto &t, int n) { p.addText({"", t.label}, commonPart<&Conditions::warmUp, &WarmUp::text>(), n); }},
        Own{"warmUp", "by", [](auto &p, auto &t, int n) { p.addChoice(t, {QT_TR_NOOP("not stated"), QT_TR_NOOP("the maker"), QT_TR_NOOP("agreement")}, choiceOf<SpecifiedBy>(commonPart<&Conditions::warmUp, &WarmUp::specifiedBy>(), {SpecifiedBy::notStated, SpecifiedBy::maker, SpecifiedBy::agreement}), true, n); }},
        Own{"toolOffset", "0", [](auto &p, auto &t, int n) { p.addNumber(t, Quantity::position, coordinate<&Conditions::toolOffset, 0>(), n); }},
        Own{"toolOffset", "1", [](auto &p, auto &t, int n) { p.addNumber(t, Quantity::position, coordinate<&Conditions::toolOffset, 1>(), n); }},
        Own{"toolOffset", "2", [](auto &p, auto &t, int n) { p.addNumber(t, Quantity::position, coordinate<&Conditions::toolOffset, 2>(), n); }},
        Own{"workpieceOffset", "0", [](auto &p, auto &t, int n) { p.addNumber(t, Quantity::position, coordinate<&Conditions::workpieceOffset, 0>(), n); }},
        Own{"workpieceOffset", "1", [](auto &p, auto &t, int n) { p.addNumber(t, Quantity::position, coordinate<&Conditions::workpieceOffset, 1>(), n); }},
        Own{"workpieceOffset", "2", [](auto &p, auto &t, int n) { p.addNumber(t, Quantity::position, coordinate<&Conditions::workpieceOffset, 2>(), n); }},
        Own{"centre", "0", [](auto &p, auto &t, int n) { p.addNumber(t, Quantity::position, circular<&C::conditions, &CircularConditions::centre, std::size_t(0)>(), n); }},
        Own{"centre", "1", [](auto &p, auto &t, int n) { p.addNumber(t, Quantity::position, circular<&C::conditions, &CircularConditions::centre, std::size_t(1)>(), n); }},
        Own{"centre", "2", [](auto &p, auto &t, int n) { p.addNumber(t, Quantity::position, circular<&C::conditions, &CircularConditions::centre, std::size_t(2)>(), n); }},
        Own{"allApply", "", [](auto &p, auto &, int n) { p.addAllApply(n); }},
        Own{"declaredAccordance", "by", [](auto &p, auto &t, int n) { p.addText({"", t.label}, ofTest([](auto &test) { return &test.declaredAccordance.by; }), n); }},
        Own{"declaredAccordance", "date", [](auto &p, auto &t, int n) { p.addDate({"", t.label}, ofTest([](auto &test) { return &test.declaredAccordance.date; }), n); }},
        Own{"declaredAccordance", "text", [](auto &p, auto &t, int n) { p.addText({"", t.label}, ofTest([](auto &test) { return &test.declaredAccordance.text; }), n); }},
        Own{"remarks", "", [](auto &p, auto &t, int n) { p.addLongText({"", t.label}, ofTest([](auto &test) { return &test.remarks; }), n); }},
    };
    // clang-format on
    const char *key = cell.key.data();
    const StatedThing *thing = statedThing(cell.key);
    const Topic topic(key, !cell.name.empty() ? cell.name.source : thing ? thing->name.source : "");
    const auto found = std::ranges::find_if(
        own, [&](const Own &one) { return one.key == cell.key && one.part == cell.part; });
    if (found != own.end())
        found->make(*this, topic, cell.columns);
    else if (cell.part == "answer")
        m_clauses[key] = addAnswer(topic, cell.columns);
    else
        addThing(topic, cell.columns);
}

/// A sensor in one line: its name, start, end, its expansion or a button that removes it, position.
void ConditionsPage::addSensor(SensorMeasures what, std::size_t ordinal, bool first) {
    beginColumns();
    const SensorLabels labels = labelsOf(what, ordinal > 0);
    const QString argument = ordinal > 0 ? QString::number(ordinal + 1) : QString();
    auto *name = made<QLabel>(TextSize::small, body());
    name->setContentsMargins(0, first ? Field::headHeight - 4 : 0, 0, 0); // level with the fields
    m_sensorNames.push_back({name, what, argument});
    addWidget(name, 2);
    const auto head = [first, &argument](Field *field) {
        field->setLabelArgument(argument);
        if (!first)
            field->hideLabel();
        return field;
    };
    Field *start = head(addNumber({"sensors", labels.start}, Quantity::temperature, startOf(what, ordinal), 2,
                                  Allowed::celsius));
    Field *end = head(
        addNumber({"sensors", labels.end}, Quantity::temperature, endOf(what, ordinal), 2, Allowed::celsius));
    if (first) {
        m_start = start;
        m_end = end;
    }
    m_lastSensors[what] = start;
    if (ordinal > 0 || what == SensorMeasures::notStated)
        addButton(
            QT_TR_NOOP("Remove"),
            [this, what, ordinal] {
                edit(QT_TRANSLATE_NOOP("edits", "remove a sensor"), [&](Document &document) {
                    editTest(document, this->test(),
                             [&](Test &changed) { removeSensor(*conditionsOf(changed), what, ordinal); });
                });
            },
            3);
    else if (what == SensorMeasures::air)
        addWidget(m_expansion = made<QLabel>(trait::secondary, body()), 3);
    else
        addNumber({"expansion", QT_TR_NOOP("Expansion α")}, Quantity::expansion,
                  what == SensorMeasures::machine
                      ? commonPart<&Conditions::expansion, &Expansion::machine>()
                      : commonPart<&Conditions::expansion, &Expansion::instrument>(),
                  3, Allowed::coefficient)
            ->hideLabel();
    head(addText({"sensors", QT_TR_NOOP("Sensor position")}, ofSensor<&Sensor::position>(what, ordinal), 3));
}

void ConditionsPage::addTemperatures(const Conditions &conditions) {
    m_sensorNames.clear();
    for (const SensorMeasures what : kinds) {
        for (std::size_t ordinal = 0; ordinal < shownSensors(conditions, what); ++ordinal)
            addSensor(what, ordinal, what == kinds.front() && ordinal == 0);
    }
    auto *row = new QHBoxLayout;
    row->setContentsMargins(0, 0, 0, 0);
    const auto addOne = [this, row](const char *text, SensorMeasures what, const QString &name) {
        QPushButton *button = addLink(text, [this, what] {
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
        });
        button->setObjectName(name);
        row->addWidget(button);
    };
    addOne(QT_TR_NOOP("+ air"), SensorMeasures::air, QStringLiteral("addAirSensor"));
    addOne(QT_TR_NOOP("+ machine"), SensorMeasures::machine, QStringLiteral("addMachineSensor"));
    addOne(QT_TR_NOOP("+ instrument"), SensorMeasures::instrument, QStringLiteral("addInstrumentSensor"));
    m_correction = made<ElidedLabel>("correctionSize", TextSize::small, trait::secondary, body());
    row->addWidget(m_correction, 1);
    addToGroup(row);
}

/// Answers all that is not declared with yes.
void ConditionsPage::addAllApply(int columns) {
    auto *button = addLink(QT_TR_NOOP("All of these apply"), [this] {
        edit(QT_TRANSLATE_NOOP("edits", "declare what was not declared"), [&](Document &document) {
            editTest(document, this->test(), [](Test &changed) {
                for (const std::string_view key : declarationKeys()) {
                    const auto declared = std::get<std::optional<bool>>(fieldValue(changed, key));
                    setFieldValue(changed, key, std::optional(declared.value_or(true)));
                }
            });
        });
    });
    button->setObjectName(QStringLiteral("allApply"));
    addWidget(button, columns);
}

/// Check boxes for the instruments used in the test.
void ConditionsPage::addInstruments() {
    for (const Instrument &instrument : evaluated().document->instruments) {
        auto *box = made<QCheckBox>(QStringLiteral("uses.") + QString::fromStdString(instrument.id), body());
        box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        auto *cell = new QWidget(body());
        inColumn(cell, {0, Field::headHeight - 4, 0, 0}, 0, {box});
        addWidget(cell, m_instruments.empty() ? 7 : 6);
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
}

bool ConditionsPage::focusField(const QString &id) {
    if (id != QLatin1StringView("instruments") || m_instruments.empty())
        return Form::focusField(id);
    showPart(*m_instruments.front());
    m_instruments.front()->setFocus(Qt::OtherFocusReason);
    return true;
}

/// Short, beside what only practice asks for and the buttons.
QString ConditionsPage::missingText(int count) const {
    return tr("%n missing", nullptr, count);
}

QString ConditionsPage::nameOf(const SensorName &sensor) {
    const QString name = sensor.what == SensorMeasures::air          ? tr("Air")
                         : sensor.what == SensorMeasures::machine    ? tr("Machine")
                         : sensor.what == SensorMeasures::instrument ? tr("Instrument")
                                                                     : tr("Unassigned");
    return sensor.argument.isEmpty() ? name : name + QChar(u'\u00A0') + sensor.argument;
}

void ConditionsPage::refreshOthers() {
    m_like->setText(tr("Like the last test"));
    m_like->setToolTip(
        tr("Fills what is open as for the last test of this machine, in this file or in the register; "
           "what is measured on the day stays open"));
    const Test *shown = shownTest();
    if (shown && m_correction) {
        const QString size = correctionSizeText(*shown, language());
        m_correction->setText(size.isEmpty() || motionOf(*shown) != Motion::linear
                                  ? QString()
                                  : tr("Correction to 20 °C: %1.").arg(size));
        m_start->setHeading(tr("Start"));
        m_end->setHeading(tr("End"));
        m_expansion->setText(word("Expansion α"));
        m_expansion->setFont(themeFont(TextSize::small));
        m_expansion->setAlignment(Qt::AlignLeft | Qt::AlignTop);
        for (const SensorName &sensor : m_sensorNames)
            sensor.name->setText(nameOf(sensor));
    }
    const Edition *edition = shown ? evaluated().tests[test()]->edition : nullptr;
    for (const auto &[key, field] : m_clauses)
        field->setUnit(edition ? QString::fromStdString(clauseOfDeclaration(*edition, key)) : QString());
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
