#pragma once

#include "kernel/measurement/positioning.h"

#include <optional>
#include <vector>

/// Correction to 20 °C of linear axes by the nominal differential expansion (NDE).
namespace palmer::iso230_2 {

/// What is added to the deviations of each target, in mm, when the conditions say "applied here":
/// −1e-6·ℓ_i·(α_M·(θ_M − 20) − α_D·(θ_D − 20)), ℓ_i = P_i − P_ref in mm, α in µm/(m·°C), θ the mean of start
/// and end in °C. α_D = 0 needs no θ_D. Null where nothing is asked for, for rotary axes, and where θ or α is
/// missing.
[[nodiscard]] std::optional<std::vector<double>> correctionsTo20(const PositioningMeasurement &measurement);

/// The results hold at 20 °C: corrected by the instrument, or here.
[[nodiscard]] bool isCorrected(const PositioningMeasurement &measurement);

/// A linear axis whose machine (or scale) temperature is stated and is not 20 °C.
[[nodiscard]] bool awayFrom20(const PositioningMeasurement &measurement);

} // namespace palmer::iso230_2
