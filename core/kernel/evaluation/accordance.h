// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/finding.h"

#include <span>

namespace palmer {

struct Edition;

/// Whether a test was carried out as its edition asks; the first that holds. notChecked: the text of the
/// edition was not read; no: a requirement is unmet; notShown: one is undeclared; partly: the text was read
/// in part; yes: else.
enum class Accordance { notChecked, no, notShown, partly, yes };

/// What counts for accordance, and what departs from practice where the text was not read.
struct RequirementCounts {
    int unmet = 0;
    int undeclared = 0;
    int departures = 0; ///< of practice, unmet

    bool operator==(const RequirementCounts &) const = default;
};

[[nodiscard]] RequirementCounts countRequirements(std::span<const Finding> findings);

/// What practice asks for and is not declared.
[[nodiscard]] int countOpenInPractice(std::span<const Finding> findings);

/// A pure function of findings and edition; null for drift tests, which have no edition.
[[nodiscard]] Accordance accordanceOf(std::span<const Finding> findings, const Edition *edition);

} // namespace palmer
