// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/parts/testpart.h"

namespace palmer {

/// What a test states of its conditions, a row each; a value that is missing is empty.
[[nodiscard]] KeyValues conditionRows(const TestPart &part);

/// Temperatures of what the sensors measure: the mean over all of them, null unless each has a value.
struct Temperatures {
    std::optional<double> start;
    std::optional<double> end;
};
[[nodiscard]] Temperatures temperaturesOf(const Conditions &conditions, SensorMeasures what);

/// "Machine", "Instrument", "Air".
[[nodiscard]] Text sensorText(SensorMeasures what);

/// Whether temperatures count for the test, or are stated all the same.
[[nodiscard]] bool statesTemperatures(const TestPart &part);

/// The correction to 20 °C in words; empty where none can be asked for.
[[nodiscard]] QString correctionOf(const TestPart &part);

/// The sensors with their positions; null where the environment says as much.
[[nodiscard]] std::optional<Table> sensorTable(const TestPart &part);

/// The temperatures over time, where a sensor has a series and the curve is wanted.
void addTemperatureCurve(std::vector<Block> &blocks, const TestPart &part);

/// The points to be agreed with what was agreed, and between whom, after which clause.
struct AgreedPoints {
    QString note;
    Table table;
    std::size_t keys = 1; ///< columns that say which point it is
};
/// Null: the edition has none.
[[nodiscard]] std::optional<AgreedPoints> agreedPointsOf(const TestPart &part);

/// The test conditions with the environment and the temperature sensors.
void addConditions(std::vector<Block> &blocks, const PositioningPart &part);

/// The same of a circular test, apart from the parameters that stand beside its figure.
void addConditions(std::vector<Block> &blocks, const CircularPart &part);

/// The points to be agreed between supplier/manufacturer and user, each with its state.
void addAgreedPoints(std::vector<Block> &blocks, const TestPart &part);

/// What stands behind the U of the results, where there is any or the edition asks for it.
void addUncertainty(std::vector<Block> &blocks, const TestPart &part, UncertaintyMethod method);

/// The correction to 20 °C where it was to be made here, and what was added to each target. Linear axes only;
/// in all other cases the conditions say what there is to say.
void addCorrection(std::vector<Block> &blocks, const PositioningPart &part);

/// The same of F and D, with C and what it follows from; nothing where neither is asked for.
void addCorrection(std::vector<Block> &blocks, const CircularPart &part);

/// "X 0; Y –; Z 150"; empty where nothing is stated.
[[nodiscard]] QString pointText(const Writer &write, const Point3 &point);

} // namespace palmer
