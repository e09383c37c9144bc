// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/edition.h"

#include <span>

/// Parameters of the editions of ISO 230-2 and related standards: one table per edition, in printing order.
namespace palmer::iso230_2 {

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

} // namespace palmer::iso230_2
