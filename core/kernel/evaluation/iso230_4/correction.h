#pragma once

#include "kernel/measurement/circular.h"

#include <optional>

namespace palmer::iso230_4 {

/// C = R·[α_i·(T_i − 20) − α_m·(T_m − 20)] in mm, added to F and D; R nominal radius in mm, α in µm/(m·°C), T
/// the mean of start and end in °C, i instrument, m machine. A coefficient of 0 needs no temperature. Null
/// unless the conditions say "applied here" and all of it is stated.
[[nodiscard]] std::optional<double> correctionTo20(const CircularMeasurement &measurement);

/// Machine or instrument was stated to be away from 20 °C.
[[nodiscard]] bool awayFrom20(const CircularMeasurement &measurement);

/// The lengths hold at 20 °C: corrected by the instrument, or here.
[[nodiscard]] bool isCorrected(const CircularMeasurement &measurement);

} // namespace palmer::iso230_4
