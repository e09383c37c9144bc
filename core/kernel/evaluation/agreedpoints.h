// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/edition.h"
#include "kernel/measurement/test.h"

#include <string_view>
#include <vector>

namespace palmer {

/// What the parties wrote about a point; null: nothing.
[[nodiscard]] const AgreedPoint *agreedPoint(const Test &test, std::string_view point);

/// The parties agreed on the point.
[[nodiscard]] bool isAgreed(const Test &test, std::string_view point);

/// Points that the test states and its edition does not list, as other editions of the kind name them.
[[nodiscard]] std::vector<const AgreementPoint *> furtherPoints(const Edition &edition, const Test &test);

/// Whether the point is one of those listed for the test, is asked for by a row of the requirements, or does
/// not apply: as stated, and by its rule where nothing is.
[[nodiscard]] PointRole roleOf(const AgreementPoint &point, const Test &test);

/// A recommendation (where the text was not read, a note) for each point of the edition that applies, is
/// asked for by no row of its own and is not agreed, or not declared.
void findNotAgreed(const Edition &edition, const Test &test, std::vector<Finding> &findings);

} // namespace palmer
