// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/edition.h"
#include "kernel/measurement/test.h"

#include <string_view>
#include <vector>

namespace palmer {

/// Returns the parties' statement about a point, or null.
[[nodiscard]] const AgreedPoint *agreedPoint(const Test &test, std::string_view point);

/// True if the parties agreed on the point.
[[nodiscard]] bool isAgreed(const Test &test, std::string_view point);

/// Returns the points stated by the test that its edition does not list, under their names in other editions.
[[nodiscard]] std::vector<const AgreementPoint *> furtherPoints(const Edition &edition, const Test &test);

/// Returns whether the point is listed for the test, covered by a row of the requirements, or not applicable:
/// as stated, otherwise by the rule of the point.
[[nodiscard]] PointRole roleOf(const AgreementPoint &point, const Test &test);

/// Adds a recommendation (a note if the text was not read) for each point of the edition that applies, has no
/// requirement row of its own and is not agreed or not declared.
void findNotAgreed(const Edition &edition, const Test &test, std::vector<Finding> &findings);

} // namespace palmer
