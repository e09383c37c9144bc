// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/comparedtests.h"
#include "figures/figure.h"
#include "language/language.h"

namespace palmer {

/// The differences of the paths of two circles over the angle, a line per sense. Without lines if there are
/// none.
[[nodiscard]] LineFigure pathDifferenceFigure(const std::vector<ComparedPath> &paths,
                                              const Language &language);

/// The differences of the mean deviations of two tests over the targets, ↑, ↓ and of both, with the band of
/// the latter. Without curves if the comparison has none.
[[nodiscard]] CurveFigure differenceFigure(const TestComparison &comparison, const Language &language);

} // namespace palmer
