// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/edition.h"

namespace palmer::iso230_4 {

/// Returns ISO 230-4 of 1996, 2005 and 2022.
[[nodiscard]] std::span<const Edition> editions();

} // namespace palmer::iso230_4
