// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "document/evaluateddocument.h"

#include <cstddef>
#include <optional>

namespace palmer {

/// True if a test counts for the verdict of the report: all but those as found, or these if there are no
/// others. Drift tests have no verdict and are not others.
[[nodiscard]] bool countsForVerdict(const Document &document, std::size_t test);

/// Returns the test as found to compare with one as left: of the same axis (or plane, with the same radius),
/// zone and edition; of several the last before it, otherwise the first after it. Null if there is none, or
/// if the test is not as left.
[[nodiscard]] std::optional<std::size_t> testAsFound(const Document &document, std::size_t asLeft);

/// True if a test or the acceptance sheet has a verdict other than "conforms"; if rejection must be proven,
/// only for "does not conform" and rows that are not measured. Tests as found do not count if there are
/// others.
[[nodiscard]] bool hasRejection(const EvaluatedDocument &evaluated);

} // namespace palmer
