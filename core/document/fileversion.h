// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <array>

namespace palmer {

inline constexpr const char *fileFormat = "palmer test report";

// History of the format:
// 1  first version.
// 2  what the texts of the editions ask of a test: purpose, role, declared accordance, further conditions,
//    numbers agreed; the state of a point agreed is obligatory; a diagnosis is not left out but asked for.

/// The step at index v − 1 makes the JSON of version v + 1 of that of version v.
using Migration = void (*)(nlohmann::json &file);
/// 1 → 2: a point without a state was not agreed; that a diagnosis was left out means nothing.
void stateAgreements(nlohmann::json &file);

inline constexpr std::array<Migration, 1> migrations{stateAgreements};

inline constexpr long long firstVersion = 1;
inline constexpr long long fileVersion = static_cast<long long>(migrations.size()) + 1;

} // namespace palmer
