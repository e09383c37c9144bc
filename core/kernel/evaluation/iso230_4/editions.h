// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/edition.h"
#include "kernel/evaluation/iso230_4/circularcase.h"

namespace palmer::iso230_4 {

/// Returns ISO 230-4 of 1996, 2005 and 2022.
[[nodiscard]] std::span<const Edition> editions();

// The tables of each edition: results, requirements and statements.
[[nodiscard]] const CircularRules &rules1996();
[[nodiscard]] const CircularRules &rules2005();
[[nodiscard]] const CircularRules &rules2022();

} // namespace palmer::iso230_4
