#pragma once

#include <nlohmann/json_fwd.hpp>

#include <array>

namespace palmer {

inline constexpr const char *fileFormat = "palmer test report";

// History of the format:
// 1  first version.

/// The step at index v − 1 makes the JSON of version v + 1 of that of version v.
using Migration = void (*)(nlohmann::json &file);
inline constexpr std::array<Migration, 0> migrations{};

inline constexpr long long fileVersion = static_cast<long long>(migrations.size()) + 1;

} // namespace palmer
