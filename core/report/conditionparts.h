#pragma once

#include "report/testpart.h"

namespace palmer {

/// The conditions that all tests have in common; none of a single test.
[[nodiscard]] std::vector<KeyValue> commonConditions(const std::vector<TestPart> &parts);

/// These, once for all tests.
void addCommonConditions(std::vector<Block> &blocks, const Writer &write,
                         const std::vector<KeyValue> &common);

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
