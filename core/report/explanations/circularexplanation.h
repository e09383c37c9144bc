// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/explanations/explanation.h"
#include "report/words/printednumbers.h"

namespace palmer {

/// The `explanation` of a parameter of a circular test: formula with the distances from the centre and the
/// correction inserted, the circle with its certificate, the points that rule it. Null if the parameter of
/// the edition has no such explanation. `test` holds a CircularMeasurement, `evaluation` is its evaluation,
/// `printed` are the numbers of the parameter as printed elsewhere.
[[nodiscard]] std::optional<Explanation>
circularExplanation(const Test &test, const TestEvaluation &evaluation, const Parameter &parameter,
                    const PrintedNumbers &printed, const Language &language);

} // namespace palmer
