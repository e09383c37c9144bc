#pragma once

#include "kernel/evaluation/edition.h"

/// What the editions of ISO 230-2 ask of a test: tables in the order of the standard. Grades as verified: a
/// rule that is practice only, not read in the text of the edition, is a note and says so in its sentence.
namespace palmer::iso230_2 {

[[nodiscard]] std::span<const Scheme> schemes1988();
[[nodiscard]] std::span<const Scheme> schemes2006();
[[nodiscard]] std::span<const Scheme> schemesWithoutClauses(); ///< 1997, 2014 and aliases

[[nodiscard]] std::span<const Requirement> requirements1988();
[[nodiscard]] std::span<const Requirement> requirements1997();
[[nodiscard]] std::span<const Requirement> requirements2006();
[[nodiscard]] std::span<const Requirement> requirements2014(); ///< as 2006, without clauses
[[nodiscard]] std::span<const Requirement> requirementsVdi3441();

/// What the report of a positioning test states, under any edition.
[[nodiscard]] std::span<const Statement> statements();

[[nodiscard]] std::span<const AgreementPoint> points1988();
[[nodiscard]] std::span<const AgreementPoint> points1997(); ///< and later

} // namespace palmer::iso230_2
