#pragma once

namespace palmer {

/// The temperature that lengths are stated at, °C.
inline constexpr double referenceTemperature = 20;

} // namespace palmer
