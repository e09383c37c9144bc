#pragma once

#include "language/language.h"
#include "report/report.h"
#include "validation/validation.h"

namespace palmer {

/// What selftest and the help print: of each set of reference data computed and expected values.
[[nodiscard]] Report composeValidation(const std::vector<SetValidation> &sets, const Language &language);

} // namespace palmer
