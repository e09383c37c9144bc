#pragma once

#include "report/testpart.h"

namespace palmer {

/// The test conditions with the environment and the temperature sensors.
void addConditions(std::vector<Block> &blocks, const PositioningPart &part);

/// The points to be agreed between supplier/manufacturer and user, each with its state.
void addAgreedPoints(std::vector<Block> &blocks, const TestPart &part);

/// What stands behind the U of the results, where there is any or the edition asks for it.
void addUncertainty(std::vector<Block> &blocks, const PositioningPart &part);

/// Which of the cases of the correction to 20 °C holds, and what was added to each target. Linear axes only.
void addCorrection(std::vector<Block> &blocks, const PositioningPart &part);

} // namespace palmer
