// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/edition.h"

#include <span>

namespace palmer::iso230_2 {

/// Returns ISO 230-2 of 1988, 1997, 2006, 2014, VDI/DGQ 3441 and the national aliases.
[[nodiscard]] std::span<const Edition> editions();

// Parameters and target terms: one table per edition, in printing order.
[[nodiscard]] std::span<const Row> rows1988();
[[nodiscard]] std::span<const Row> rows2006();
[[nodiscard]] std::span<const Row> rows2006WithoutClauses(); ///< 1997 and the aliases of 1997 and 2006
[[nodiscard]] std::span<const Row> rows2014();
[[nodiscard]] std::span<const Row> rows2014WithoutClauses(); ///< aliases of 2014
[[nodiscard]] std::span<const Row> rowsVdi3441();

[[nodiscard]] std::span<const TargetTerm> targetTerms1988();
[[nodiscard]] std::span<const TargetTerm> targetTerms2006();
[[nodiscard]] std::span<const TargetTerm> targetTerms2006WithoutClauses();
[[nodiscard]] std::span<const TargetTerm> targetTermsVdi3441();
[[nodiscard]] std::span<const TargetTerm> targetTerms2014();
[[nodiscard]] std::span<const TargetTerm> targetTerms2014WithoutClauses();

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
