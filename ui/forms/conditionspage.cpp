#include "ui/forms/conditionspage.h"

#include <QCoreApplication>
#include <QStringList>

namespace palmer::ui {

namespace {

constexpr char context[] = "palmer::ui::ConditionsPage";

QString word(const char *source) {
    return QCoreApplication::translate(context, source);
}

const PositioningMeasurement *positioning(const FormSource &source) {
    return source.test ? std::get_if<PositioningMeasurement>(&source.test->measurement) : nullptr;
}

/// What positioning and circular tests state alike.
const Conditions *common(const FormSource &source) {
    if (const auto *measurement = positioning(source))
        return &measurement->conditions.common;
    const auto *circular =
        source.test ? std::get_if<CircularMeasurement>(&source.test->measurement) : nullptr;
    return circular ? &circular->conditions.common : nullptr;
}

template <std::string Conditions::*text>
QString of(const FormSource &source) {
    const Conditions *conditions = common(source);
    return conditions ? stated(conditions->*text) : QString();
}

template <std::optional<bool> Conditions::*answer>
QString yesOrNo(const FormSource &source) {
    const Conditions *conditions = common(source);
    if (!conditions || !(conditions->*answer).has_value())
        return {};
    return *(conditions->*answer) ? word(QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "yes"))
                                  : word(QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "no"));
}

template <Point3 Conditions::*point, std::size_t axis>
QString coordinate(const FormSource &source) {
    const Conditions *conditions = common(source);
    return conditions ? stated((conditions->*point)[axis], Quantity::position, source.language) : QString();
}

template <std::optional<double> PositioningConditions::*value, Quantity quantity>
QString number(const FormSource &source) {
    const auto *measurement = positioning(source);
    return measurement ? stated(measurement->conditions.*value, quantity, source.language) : QString();
}

template <std::optional<double> Expansion::*value>
QString expansion(const FormSource &source) {
    const Conditions *conditions = common(source);
    return conditions ? stated(conditions->expansion.*value, Quantity::expansion, source.language)
                      : QString();
}

/// All sensors of a kind, one after the other.
template <SensorMeasures what>
QString eachSensor(const FormSource &source, QString (*value)(const Sensor &, const Language &)) {
    QStringList values;
    if (const Conditions *conditions = common(source)) {
        for (const Sensor &sensor : conditions->sensors) {
            if (sensor.measures == what)
                values << value(sensor, source.language);
        }
    }
    values.removeAll(QString());
    return values.join(QStringLiteral(" / "));
}

template <SensorMeasures what>
QString start(const FormSource &source) {
    return eachSensor<what>(source, [](const Sensor &sensor, const Language &language) {
        return stated(startTemperature(sensor), Quantity::temperature, language);
    });
}
template <SensorMeasures what>
QString end(const FormSource &source) {
    return eachSensor<what>(source, [](const Sensor &sensor, const Language &language) {
        return stated(endTemperature(sensor), Quantity::temperature, language);
    });
}
template <SensorMeasures what>
QString position(const FormSource &source) {
    return eachSensor<what>(source,
                            [](const Sensor &sensor, const Language &) { return stated(sensor.position); });
}

QString date(const FormSource &source) {
    if (!source.test)
        return {};
    QString text = statedDate(source.test->date, source.language);
    if (source.test->time && !text.isEmpty())
        text += u' ' + stated(*source.test->time);
    return text;
}

QString axisName(const FormSource &source) {
    const auto *measurement = positioning(source);
    return measurement ? stated(measurement->axis.name) : QString();
}
QString axisTravel(const FormSource &source) {
    const auto *measurement = positioning(source);
    const bool linear = !measurement || measurement->axis.motion == Motion::linear;
    if (!measurement || !measurement->axis.travel)
        return {};
    return source.language.quantity(*measurement->axis.travel, linear ? Quantity::position : Quantity::angle);
}
QString feedback(const FormSource &source) {
    if (const auto *measurement = positioning(source))
        return stated(measurement->axis.positionFeedback);
    const auto *circular =
        source.test ? std::get_if<CircularMeasurement>(&source.test->measurement) : nullptr;
    return circular ? stated(circular->positionFeedback) : QString();
}

QString targetChoice(const FormSource &source) {
    const auto *measurement = positioning(source);
    switch (measurement ? measurement->targetChoice.kind : TargetChoiceKind::notStated) {
    case TargetChoiceKind::notStated:
        return {};
    case TargetChoiceKind::free:
        return word(QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "chosen freely"));
    case TargetChoiceKind::polygon:
        return word(QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "faces of the polygon"));
    case TargetChoiceKind::fixed:
        return word(QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "given by the device"));
    }
    return {};
}

QString correction(const FormSource &source) {
    const Conditions *conditions = common(source);
    switch (conditions ? conditions->correctionTo20 : CorrectionTo20::notStated) {
    case CorrectionTo20::notStated:
        return {};
    case CorrectionTo20::notApplied:
        return word(QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "not applied"));
    case CorrectionTo20::appliedByInstrument:
        return word(QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "by the instrument"));
    case CorrectionTo20::appliedHere:
        return word(QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "applied here"));
    }
    return {};
}

QString warmUp(const FormSource &source) {
    const Conditions *conditions = common(source);
    if (!conditions || conditions->warmUp.kind == WarmUpKind::notStated)
        return {};
    const QString text = stated(conditions->warmUp.text);
    if (conditions->warmUp.kind == WarmUpKind::procedure && !text.isEmpty())
        return text;
    const QString kind =
        conditions->warmUp.kind == WarmUpKind::procedure
            ? word(QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "agreed or the maker's procedure"))
        : conditions->warmUp.kind == WarmUpKind::dryRun
            ? word(QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "dry run"))
            : word(QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "set-up movements only"));
    return text.isEmpty() ? kind : kind + QStringLiteral(", ") + text;
}

QString feed(const FormSource &source) {
    if (const auto *circular =
            source.test ? std::get_if<CircularMeasurement>(&source.test->measurement) : nullptr)
        return stated(circular->feed, Quantity::feed, source.language);
    const auto *measurement = positioning(source);
    if (!measurement)
        return {};
    if (measurement->conditions.feedMode == FeedMode::rapid)
        return word(QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "rapid"));
    if (!measurement->conditions.feed)
        return {};
    return source.language.quantity(*measurement->conditions.feed, measurement->axis.motion == Motion::linear
                                                                       ? Quantity::feed
                                                                       : Quantity::angularFeed);
}

} // namespace

ConditionsPage::ConditionsPage(Selection &selection, QWidget *parent)
    : Form(context, Page::conditions, parent) {
    follow(selection);
    setObjectName(QStringLiteral("conditionsPage"));
    const QString celsius = QStringLiteral("°C");
    const QString alpha = QStringLiteral("µm/(m·°C)");
    const QString mm = QStringLiteral("mm");
    constexpr auto air = SensorMeasures::air;
    constexpr auto machine = SensorMeasures::machine;
    constexpr auto instrument = SensorMeasures::instrument;

    addSection(QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Temperatures"));
    beginRow();
    addNumber("sensors", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Air, start"), celsius, start<air>,
              2);
    addNumber("sensors", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Air, end"), celsius, end<air>, 2);
    addText("sensors", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Position of the sensor"),
            position<air>, 3);
    addText("correctionTo20", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Correction to 20 °C"),
            correction, 3);
    beginRow();
    addNumber("sensors", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Machine, start"), celsius,
              start<machine>, 2);
    addNumber("sensors", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Machine, end"), celsius,
              end<machine>, 2);
    addText("sensors", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Position of the sensor"),
            position<machine>, 3);
    addNumber("expansion", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Expansion α"), alpha,
              expansion<&Expansion::machine>, 3);
    beginRow();
    addNumber("sensors", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Instrument, start"), celsius,
              start<instrument>, 2);
    addNumber("sensors", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Instrument, end"), celsius,
              end<instrument>, 2);
    addText("sensors", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Position of the sensor"),
            position<instrument>, 3);
    addNumber("expansion", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Expansion α"), alpha,
              expansion<&Expansion::instrument>, 3);
    beginRow();
    addNumber("airPressure", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Air pressure"),
              QStringLiteral("hPa"), number<&PositioningConditions::airPressure, Quantity::pressure>);
    addNumber("airHumidity", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Relative humidity"),
              QStringLiteral("%"), number<&PositioningConditions::airHumidity, Quantity::percent>);
    addNumber("gradientPerHour", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Temperature gradient"),
              QStringLiteral("°C/h"), number<&PositioningConditions::gradientPerHour, Quantity::gradient>);

    addSection(QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Cycle and load"));
    beginRow();
    addNumber("feed", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Feed rate"), {}, feed);
    addNumber("dwell", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Dwell at the target"),
              QStringLiteral("s"), number<&PositioningConditions::dwell, Quantity::time>);
    addText("", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Load"), of<&Conditions::load>);
    beginRow();
    addText("warmUp", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Warm-up"), warmUp);
    addText("compensation", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Active compensation"),
            of<&Conditions::compensation>);
    beginRow();
    addText("complete", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Complete, in working order"),
            yesOrNo<&Conditions::complete>);
    addText("levelled", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Levelled and aligned"),
            yesOrNo<&Conditions::levelled>);
    addText("unloaded", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Unloaded"),
            yesOrNo<&Conditions::unloaded>);

    addSection(QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Positions"));
    beginRow();
    addText("", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Position of the instrument"),
            of<&Conditions::instrumentPosition>);
    addText("otherAxes", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Axes not under test"),
            of<&Conditions::otherAxes>);
    beginRow();
    addNumber("toolOffset", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Offset to tool, X"), mm,
              coordinate<&Conditions::toolOffset, 0>);
    addNumber("toolOffset", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Offset to tool, Y"), mm,
              coordinate<&Conditions::toolOffset, 1>);
    addNumber("toolOffset", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Offset to tool, Z"), mm,
              coordinate<&Conditions::toolOffset, 2>);
    beginRow();
    addNumber("workpieceOffset", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Offset to workpiece, X"),
              mm, coordinate<&Conditions::workpieceOffset, 0>);
    addNumber("workpieceOffset", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Offset to workpiece, Y"),
              mm, coordinate<&Conditions::workpieceOffset, 1>);
    addNumber("workpieceOffset", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Offset to workpiece, Z"),
              mm, coordinate<&Conditions::workpieceOffset, 2>);

    addSection(QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Test and axis"));
    beginRow();
    addText("date", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Date of test"), date);
    addText("name", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Axis"), axisName);
    addText("travel", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Axis travel"), axisTravel);
    beginRow();
    addText("positionFeedback",
            QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Measuring system of the axis"), feedback);
    addText("targetChoice", QT_TRANSLATE_NOOP("palmer::ui::ConditionsPage", "Choice of targets"),
            targetChoice);
    addStretch();
    refresh();
}

} // namespace palmer::ui
