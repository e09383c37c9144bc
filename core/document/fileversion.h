// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <array>

namespace palmer {

inline constexpr const char *fileFormat = "palmer test report";

// History of the format:
// 1  first version.
// 2  requirements of the texts of the editions: purpose, role, declared accordance, further conditions,
//    agreed numbers; the state of an agreed point is obligatory; a diagnosis is requested, not omitted.
// 3  what an accredited laboratory states: traceability, reason of a revision, country, contact, rounding;
//    the acceptance sheet; the test that a test is compared with; its
//    duration; channels and temperatures of a drift test.

/// The step at index v − 1 converts the JSON of version v to version v + 1.
using Migration = void (*)(nlohmann::json &file);
/// 1 → 2: a point without a state was not agreed; an omitted diagnosis has no meaning.
void stateAgreements(nlohmann::json &file);

/// 2 → 3: keys were only added.
inline void keepAll(nlohmann::json & /*file*/) {}

inline constexpr std::array<Migration, 2> migrations{stateAgreements, keepAll};

inline constexpr long long firstVersion = 1;
inline constexpr long long fileVersion = static_cast<long long>(migrations.size()) + 1;

} // namespace palmer
