// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "language/language.h"
#include "register/machinetype.h"
#include "report/blocks/report.h"

#include <QByteArray>

namespace palmer {

/// Returns the type test as one line of JSON (palmer-type-1.schema.json); values in mm or degrees.
[[nodiscard]] QByteArray typeTestJson(const TypeTest &test);

/// The machines by value, named, as dots with their U and agreed limits; both tolerance limits across them.
[[nodiscard]] BarFigure typeFigure(const TypeTest &test, const Language &language);

/// The sorted values, or their logarithms, over their normal scores, with the straight line that lies nearest
/// to them: on it if they are normal. Empty for logarithms where a value is not > 0.
[[nodiscard]] LineFigure quantileFigure(const TypeTest &test, bool logarithms, const Language &language);

/// Returns a readable report: the limits, then the machines with their values and U; for paper with figures
/// and footers.
[[nodiscard]] Report composeTypeTest(const TypeTest &test, const Language &language, bool onPaper = false);

} // namespace palmer
