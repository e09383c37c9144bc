// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/finding.h"

#include <span>

namespace palmer {

struct Edition;

/// Accordance of a test with its edition; the first state that applies. notChecked: the text of the edition
/// was not read; no: a requirement is unmet; notShown: one is undeclared; partly: the text was read in part;
/// yes: otherwise.
enum class Accordance { notChecked, no, notShown, partly, yes };

/// Returns true for findings that accordance counts: what the text of the edition requires; if it was not
/// read, what practice does.
[[nodiscard]] bool countsForAccordance(const Finding &finding, bool wasRead);

/// Requirements that count for accordance, and departures from practice if the text was not read.
struct RequirementCounts {
    int unmet = 0;
    int undeclared = 0;
    int departures = 0; ///< of practice, unmet

    bool operator==(const RequirementCounts &) const = default;
};

[[nodiscard]] RequirementCounts countRequirements(std::span<const Finding> findings);

/// Returns the number of practice requirements that are not declared.
[[nodiscard]] int countOpenInPractice(std::span<const Finding> findings);

/// The one that asks for a missing statement: the edition, its agreements, the head of a report or the
/// computation, or only good practice (of the conditions), which is marked and never counted.
enum class Lack { none, required, usual };

/// The kind of lack that a finding states. Badges, chips, marks and the walk through what is missing all
/// follow it.
[[nodiscard]] Lack lackOf(const Finding &finding);

/// Depends on findings and edition only; null for drift tests, which have no edition.
[[nodiscard]] Accordance accordanceOf(std::span<const Finding> findings, const Edition *edition);

} // namespace palmer
