// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/conditions.h"
#include "kernel/words/unit.h"

#include <optional>
#include <string>
#include <string_view>

namespace palmer {

/// Facts of a test that the lines around a table state with a label.
enum class NoteFact {
    machine,
    serialNumber, ///< of the machine, unless an instrument was named before
    operatorName,
    axis,
    plane,
    date,
    day, ///< a word that names the day only where a date follows: "Measured", "Start"
    time,
    radius,   ///< of a circle, or the length of a ballbar
    diameter, ///< of a circle
    feed,
    airPressure,
    airHumidity,
    temperature,
    correctionTo20,
    calibration, ///< of the length of a ballbar
};

/// Returns the fact that a label names as a whole: "Machine", "Serial no. of the machine", "Date d'essai".
/// Null for "Calibrated by", "Reference temperature", "Encoder serial no": a label with other words names
/// something else.
[[nodiscard]] std::optional<NoteFact> factOf(std::string_view label);

/// The plane that a text names: "YZ", "Y-Z", "X1-Y1", "G19"; empty if it names none.
[[nodiscard]] std::string planeIn(std::string_view text);

/// The fact that a label or the heading of a column names, if it is one for all readings of a test, so that
/// another value is of another test: machine, serial number, operator, date, plane, feed. Null for any other
/// words.
[[nodiscard]] std::optional<NoteFact> factOfWholeTest(std::string_view label);

/// True for a label that names an instrument and no machine: "Laser", "Messgerät".
[[nodiscard]] bool namesInstrument(std::string_view label);
[[nodiscard]] bool namesMachine(std::string_view label);
[[nodiscard]] bool namesSerialNumber(std::string_view label);

/// The unit of temperatures at the end of a text: "°F", "(K)", "Air temp. [F]"; null if there is none.
[[nodiscard]] const Unit *temperatureUnitIn(std::string_view text);
/// False for the 85 or −127 °C of a broken sensor.
[[nodiscard]] bool isPlausibleTemperature(double celsius);

/// The sensor that the label of a temperature names; `isEnd`: its value is that at the end of the test.
struct TemperatureLabel {
    std::string position; ///< the label without the words for start and end
    SensorMeasures measures = SensorMeasures::notStated;
    bool isEnd = false;
};
[[nodiscard]] TemperatureLabel temperatureLabel(std::string_view label);

/// True if a label with a date says no more than that it is the day of the test: "Test 1", "Essai du".
[[nodiscard]] bool labelsDayOfTest(std::string_view label);
/// True if words before a date, without a label, name another day: "Printed on", "Purchased".
[[nodiscard]] bool namesOtherDay(std::string_view text);

/// The thing that a sensor measures, from its name: the air, the instrument, else the machine.
[[nodiscard]] SensorMeasures measuredBy(std::string_view name);

} // namespace palmer
