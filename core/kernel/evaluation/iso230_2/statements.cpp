#include "kernel/evaluation/iso230_2/requirements.h"

#include "kernel/evaluation/positioningcase.h"

#include <algorithm>
#include <array>

namespace palmer::iso230_2 {

namespace {

template <std::string Machine::*text>
bool ofMachine(const PositioningCase &test) {
    return test.surroundings.machine && !(test.surroundings.machine->*text).empty();
}

template <auto member>
bool common(const PositioningCase &test) {
    const auto &value = test.conditions().common.*member;
    if constexpr (requires { value.empty(); })
        return !value.empty();
    else
        return value.has_value();
}

template <auto member>
bool ofConditions(const PositioningCase &test) {
    return (test.conditions().*member).has_value();
}

template <Point3 Conditions::*point>
bool offset(const PositioningCase &test) {
    const Point3 &value = test.conditions().common.*point;
    return std::ranges::all_of(value, [](const auto &x) { return x.has_value(); });
}

template <SensorMeasures what>
bool temperature(const PositioningCase &test) {
    return meanTemperature(test.conditions().common, what).has_value();
}

/// Whether every named instrument has what `stated` asks for; without any, the row "instruments" says so.
template <typename Stated>
bool everyInstrument(const PositioningCase &test, Stated stated) {
    return std::ranges::all_of(test.surroundings.instruments,
                               [&](const Instrument *i) { return stated(*i); });
}

bool date(const PositioningCase &test) {
    return test.test.date.has_value();
}
bool axisName(const PositioningCase &test) {
    return !test.measurement.axis.name.empty();
}
bool positionFeedback(const PositioningCase &test) {
    return !test.measurement.axis.positionFeedback.empty();
}
bool targetChoice(const PositioningCase &test) {
    return test.measurement.targetChoice.kind != TargetChoiceKind::notStated;
}
bool instruments(const PositioningCase &test) {
    return !test.surroundings.instruments.empty();
}
bool instrumentSerial(const PositioningCase &test) {
    return everyInstrument(test, [](const Instrument &i) { return !i.serialNumber.empty(); });
}
bool certificate(const PositioningCase &test) {
    return everyInstrument(test, [](const Instrument &i) { return !i.certificate.empty(); });
}
bool calibrationDate(const PositioningCase &test) {
    return everyInstrument(test, [](const Instrument &i) { return i.calibrationDate.has_value(); });
}
bool sensorPositions(const PositioningCase &test) {
    const auto &sensors = test.conditions().common.sensors;
    return !sensors.empty() &&
           std::ranges::none_of(sensors, [](const Sensor &s) { return s.position.empty(); });
}
bool expansion(const PositioningCase &test) {
    const Expansion &alpha = test.conditions().common.expansion;
    return !test.linear() || (alpha.machine && alpha.instrument);
}
bool correctionTo20(const PositioningCase &test) {
    return !test.linear() || test.conditions().common.correctionTo20 != CorrectionTo20::notStated;
}
bool warmUp(const PositioningCase &test) {
    return test.conditions().common.warmUp.kind != WarmUpKind::notStated;
}
bool feed(const PositioningCase &test) {
    return test.conditions().feed || test.conditions().feedMode == FeedMode::rapid;
}

// clang-format off
constexpr std::array statementsOfTest{
    Statement{"date",             REPORT_TEXT("report", "date of the test"), date},
    Statement{"manufacturer",     REPORT_TEXT("report", "manufacturer of the machine"), ofMachine<&Machine::manufacturer>},
    Statement{"model",            REPORT_TEXT("report", "type of the machine"), ofMachine<&Machine::model>},
    Statement{"serialNumber",     REPORT_TEXT("report", "serial number of the machine"), ofMachine<&Machine::serialNumber>},
    Statement{"name",             REPORT_TEXT("report", "name of the axis"), axisName},
    Statement{"positionFeedback", REPORT_TEXT("report", "measuring system of the axis"), positionFeedback},
    Statement{"targetChoice",     REPORT_TEXT("report", "how the targets were chosen"), targetChoice},
    Statement{"instruments",      REPORT_TEXT("report", "instrument"), instruments},
    Statement{"serialNumber",     REPORT_TEXT("report", "serial number of each instrument"), instrumentSerial},
    Statement{"certificate",      REPORT_TEXT("report", "calibration certificate of each instrument"), certificate},
    Statement{"calibrationDate",  REPORT_TEXT("report", "calibration date of each instrument"), calibrationDate},
    Statement{"toolOffset",       REPORT_TEXT("report", "measuring line: offset to the tool reference"), offset<&Conditions::toolOffset>},
    Statement{"workpieceOffset",  REPORT_TEXT("report", "measuring line: offset to the workpiece reference"), offset<&Conditions::workpieceOffset>},
    Statement{"otherAxes",        REPORT_TEXT("report", "position of the axes not under test"), common<&Conditions::otherAxes>},
    Statement{"sensors",          REPORT_TEXT("report", "temperature of the machine at start and end"), temperature<SensorMeasures::machine>},
    Statement{"sensors",          REPORT_TEXT("report", "temperature of the instrument at start and end"), temperature<SensorMeasures::instrument>},
    Statement{"sensors",          REPORT_TEXT("report", "temperature of the air at start and end"), temperature<SensorMeasures::air>},
    Statement{"sensors",          REPORT_TEXT("report", "position of the temperature sensors"), sensorPositions},
    Statement{"expansion",        REPORT_TEXT("report", "coefficients of thermal expansion of machine and instrument"), expansion},
    Statement{"correctionTo20",   REPORT_TEXT("report", "compensation of the nominal differential expansion (NDE)"), correctionTo20},
    Statement{"airPressure",      REPORT_TEXT("report", "air pressure"), ofConditions<&PositioningConditions::airPressure>},
    Statement{"airHumidity",      REPORT_TEXT("report", "air humidity"), ofConditions<&PositioningConditions::airHumidity>},
    Statement{"gradientPerHour",  REPORT_TEXT("report", "temperature gradient"), ofConditions<&PositioningConditions::gradientPerHour>},
    Statement{"warmUp",           REPORT_TEXT("report", "warm-up done"), warmUp},
    Statement{"feed",             REPORT_TEXT("report", "feed rate"), feed},
    Statement{"dwell",            REPORT_TEXT("report", "dwell at each target"), ofConditions<&PositioningConditions::dwell>},
    Statement{"complete",         REPORT_TEXT("report", "machine complete and in working order"), common<&Conditions::complete>},
    Statement{"levelled",         REPORT_TEXT("report", "machine levelled and aligned"), common<&Conditions::levelled>},
    Statement{"unloaded",         REPORT_TEXT("report", "machine unloaded"), common<&Conditions::unloaded>},
};
// clang-format on

} // namespace

std::span<const Statement> statements() {
    return statementsOfTest;
}

} // namespace palmer::iso230_2
