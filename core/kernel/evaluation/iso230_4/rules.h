// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/iso230_4/circularcase.h"

/// The tables of ISO 230-4: results, requirements and statements of each edition.
namespace palmer::iso230_4 {

[[nodiscard]] const CircularRules &rules1996();
[[nodiscard]] const CircularRules &rules2005();
[[nodiscard]] const CircularRules &rules2022();

} // namespace palmer::iso230_4
