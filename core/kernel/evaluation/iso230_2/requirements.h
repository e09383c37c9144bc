// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/edition.h"

/// Requirements of the editions of ISO 230-2: one table per edition, rows in the order of the printed
/// standard, then good laboratory practice, then rows of the program itself.
namespace palmer::iso230_2 {

[[nodiscard]] std::span<const Requirement> requirements1988();
[[nodiscard]] std::span<const Requirement> requirements1997(); ///< practice: as 2006 except uncertainty
[[nodiscard]] std::span<const Requirement> requirements2006();
[[nodiscard]] std::span<const Requirement> requirements2014();    ///< practice: as 2006
[[nodiscard]] std::span<const Requirement> requirementsVdi3441(); ///< nothing of ISO

[[nodiscard]] std::span<const AgreementPoint> points1988();
[[nodiscard]] std::span<const AgreementPoint> points1997(); ///< and later

} // namespace palmer::iso230_2
