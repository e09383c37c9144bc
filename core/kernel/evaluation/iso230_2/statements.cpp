#include "kernel/evaluation/iso230_2/requirements.h"

#include "kernel/evaluation/positioningcase.h"
#include "kernel/evaluation/stated.h"

#include <array>

namespace palmer::iso230_2 {

namespace {

template <auto member>
bool ofConditions(const PositioningCase &test) {
    return (test.conditions().*member).has_value();
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
bool expansion(const PositioningCase &test) {
    const Expansion &alpha = test.conditions().common.expansion;
    return !test.linear() || (alpha.machine && alpha.instrument);
}
bool correctionTo20(const PositioningCase &test) {
    return !test.linear() || test.conditions().common.correctionTo20 != CorrectionTo20::notStated;
}
bool feed(const PositioningCase &test) {
    return test.conditions().feed || test.conditions().feedMode == FeedMode::rapid;
}

// clang-format off
constexpr std::array statementsOfTest{
    Statement{"date",             REPORT_TEXT("report", "date of the test"), stated::date},
    Statement{"manufacturer",     REPORT_TEXT("report", "manufacturer of the machine"), stated::ofMachine<&Machine::manufacturer>},
    Statement{"model",            REPORT_TEXT("report", "type of the machine"), stated::ofMachine<&Machine::model>},
    Statement{"serialNumber",     REPORT_TEXT("report", "serial number of the machine"), stated::ofMachine<&Machine::serialNumber>},
    Statement{"name",             REPORT_TEXT("report", "name of the axis"), axisName},
    Statement{"positionFeedback", REPORT_TEXT("report", "measuring system of the axis"), positionFeedback},
    Statement{"targetChoice",     REPORT_TEXT("report", "how the targets were chosen"), targetChoice},
    Statement{"instruments",      REPORT_TEXT("report", "instrument"), stated::instruments},
    Statement{"serialNumber",     REPORT_TEXT("report", "serial number of each instrument"), stated::instrumentSerial},
    Statement{"certificate",      REPORT_TEXT("report", "calibration certificate of each instrument"), stated::certificate},
    Statement{"calibrationDate",  REPORT_TEXT("report", "calibration date of each instrument"), stated::calibrationDate},
    Statement{"toolOffset",       REPORT_TEXT("report", "measuring line: offset to the tool reference"), stated::offset<&Conditions::toolOffset>},
    Statement{"workpieceOffset",  REPORT_TEXT("report", "measuring line: offset to the workpiece reference"), stated::offset<&Conditions::workpieceOffset>},
    Statement{"otherAxes",        REPORT_TEXT("report", "position of the axes not under test"), stated::common<&Conditions::otherAxes>},
    Statement{"sensors",          REPORT_TEXT("report", "temperature of the machine at start and end"), stated::temperature<SensorMeasures::machine>},
    Statement{"sensors",          REPORT_TEXT("report", "temperature of the instrument at start and end"), stated::temperature<SensorMeasures::instrument>},
    Statement{"sensors",          REPORT_TEXT("report", "temperature of the air at start and end"), stated::temperature<SensorMeasures::air>},
    Statement{"sensors",          REPORT_TEXT("report", "position of the temperature sensors"), stated::sensorPositions},
    Statement{"expansion",        REPORT_TEXT("report", "coefficients of thermal expansion of machine and instrument"), expansion},
    Statement{"correctionTo20",   REPORT_TEXT("report", "compensation of the nominal differential expansion (NDE)"), correctionTo20},
    Statement{"airPressure",      REPORT_TEXT("report", "air pressure"), ofConditions<&PositioningConditions::airPressure>},
    Statement{"airHumidity",      REPORT_TEXT("report", "air humidity"), ofConditions<&PositioningConditions::airHumidity>},
    Statement{"gradientPerHour",  REPORT_TEXT("report", "temperature gradient"), ofConditions<&PositioningConditions::gradientPerHour>},
    Statement{"warmUp",           REPORT_TEXT("report", "warm-up done"), stated::warmUp},
    Statement{"feed",             REPORT_TEXT("report", "feed rate"), feed},
    Statement{"dwell",            REPORT_TEXT("report", "dwell at each target"), ofConditions<&PositioningConditions::dwell>},
    Statement{"complete",         REPORT_TEXT("report", "machine complete and in working order"), stated::common<&Conditions::complete>},
    Statement{"levelled",         REPORT_TEXT("report", "machine levelled and aligned"), stated::common<&Conditions::levelled>},
    Statement{"unloaded",         REPORT_TEXT("report", "machine unloaded"), stated::common<&Conditions::unloaded>},
};
// clang-format on

} // namespace

std::span<const Statement> statements() {
    return statementsOfTest;
}

} // namespace palmer::iso230_2
