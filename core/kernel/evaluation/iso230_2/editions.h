// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/edition.h"

#include <span>

namespace palmer::iso230_2 {

/// Returns ISO 230-2 of 1988, 1997, 2006, 2014, VDI/DGQ 3441 and the national aliases.
[[nodiscard]] std::span<const Edition> editions();

// Requirements: one table per edition, rows in the order of the printed standard, then good laboratory
// practice, then rows of the program itself.
[[nodiscard]] std::span<const Requirement> requirements1988();
[[nodiscard]] std::span<const Requirement> requirements1997(); ///< practice: as 2006 except uncertainty
[[nodiscard]] std::span<const Requirement> requirements2006();
[[nodiscard]] std::span<const Requirement> requirements2014();    ///< practice: as 2006
[[nodiscard]] std::span<const Requirement> requirementsVdi3441(); ///< nothing of ISO

// Points to be agreed.
[[nodiscard]] std::span<const AgreementPoint> points1988();
[[nodiscard]] std::span<const AgreementPoint> points1997(); ///< and later

} // namespace palmer::iso230_2
