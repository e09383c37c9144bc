#pragma once

#include "kernel/diagnosis/diagnosis.h"
#include "language/language.h"
#include "report/report.h"

namespace palmer {

/// The diagnosis of a circle to be read: heading that says what it is (an interpretation, no result of the
/// standard), how well the circle tells its sources, the sources with value, u and part of G(b), what each
/// means, remarks. Nothing for a circle that gives no diagnosis.
[[nodiscard]] std::vector<Block> diagnosisParts(const Diagnosis &diagnosis, const Language &language);

/// Digits after the point of a value with that standard uncertainty: two significant ones of u; 0 … 4.
[[nodiscard]] int decimalsOfEstimate(double standardUncertainty);

} // namespace palmer
