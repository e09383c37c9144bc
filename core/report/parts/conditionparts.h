// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/parts/testpart.h"

namespace palmer {

/// The conditions stated by a test, one row each; missing values are empty.
[[nodiscard]] KeyValues conditionRows(const TestPart &part);

/// Temperatures of a kind of sensor: the mean of all of them, null unless each has a value.
struct Temperatures {
    std::optional<double> start;
    std::optional<double> end;
};
[[nodiscard]] Temperatures temperaturesOf(const Conditions &conditions, SensorMeasures what);

/// "Machine", "Instrument", "Air".
[[nodiscard]] Text sensorText(SensorMeasures what);

/// True if temperatures matter for the test or are stated.
[[nodiscard]] bool statesTemperatures(const TestPart &part);

/// The correction to 20 °C in words; empty if it cannot be required.
[[nodiscard]] QString correctionOf(const TestPart &part);

/// The sensors with their positions; null if the environment table already shows everything.
[[nodiscard]] std::optional<Table> sensorTable(const TestPart &part);

/// Adds the temperatures over time if a sensor has a series and the curve is wanted.
void addTemperatureCurve(std::vector<Block> &blocks, const TestPart &part);

/// The points to be agreed, with the agreement, its parties and its clause.
struct AgreedPoints {
    QString note;
    Table table;
    std::size_t keys = 1; ///< columns that identify the point
};
/// Null if the edition has none.
[[nodiscard]] std::optional<AgreedPoints> agreedPointsOf(const TestPart &part);

/// Adds the test conditions with the environment and the temperature sensors.
void addConditions(std::vector<Block> &blocks, const PositioningPart &part);

/// The same for a circular test, without the parameters printed next to its figure.
void addConditions(std::vector<Block> &blocks, const CircularPart &part);

/// Adds the points to be agreed between supplier/manufacturer and user, each with its state.
void addAgreedPoints(std::vector<Block> &blocks, const TestPart &part);

/// Adds the origin of the U of the results, if there is any or the edition requires it.
void addUncertainty(std::vector<Block> &blocks, const TestPart &part, UncertaintyMethod method);

/// Adds the correction to 20 °C if it was to be made here, and its value at each target. Linear axes only; in
/// all other cases the conditions state it.
void addCorrection(std::vector<Block> &blocks, const PositioningPart &part);

/// The same for F and D, with C and its inputs; nothing if neither is required.
void addCorrection(std::vector<Block> &blocks, const CircularPart &part);

/// "X 0; Y –; Z 150"; empty if nothing is stated.
[[nodiscard]] QString pointText(const Writer &write, const Point3 &point);

} // namespace palmer
