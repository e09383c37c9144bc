#pragma once

#include "document/document.h"

#include <cstddef>

namespace palmer {

/// Whether the verdict of the report rests on a test: on all but those as found, and on these where there are
/// no others. Drift tests have no verdict and do not count as others.
[[nodiscard]] bool countsForVerdict(const Document &document, std::size_t test);

} // namespace palmer
