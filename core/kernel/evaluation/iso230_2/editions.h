// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/edition.h"

namespace palmer::iso230_2 {

/// Returns ISO 230-2 of 1988, 1997, 2006, 2014, VDI/DGQ 3441 and the national aliases.
[[nodiscard]] std::span<const Edition> editions();

} // namespace palmer::iso230_2
