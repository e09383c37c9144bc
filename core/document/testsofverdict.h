// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"

#include <cstddef>
#include <optional>

namespace palmer {

/// Whether the verdict of the report rests on a test: on all but those as found, and on these where there are
/// no others. Drift tests have no verdict and do not count as others.
[[nodiscard]] bool countsForVerdict(const Document &document, std::size_t test);

/// The test as found that one as left is to be compared with: of the same axis (or plane, with the same
/// radius), zone and edition; of several the last before it, else the first behind it. Null for a test that
/// is not as left, and where there is none.
[[nodiscard]] std::optional<std::size_t> testAsFound(const Document &document, std::size_t asLeft);

} // namespace palmer
