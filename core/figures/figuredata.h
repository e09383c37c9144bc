// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "language/language.h"

#include <QByteArray>

namespace palmer {

/// The points a figure draws as CSV, UTF-8, one a line: the line it belongs to, its place on the axes of the
/// figure (in their units, no more digits than the values have; circles: angle in degrees and radial
/// deviation in µm about the centre the figure names; synthetic paths carry a *). A comment with # says the
/// title. `;` between the cells under a decimal comma, else `,`.
[[nodiscard]] QByteArray figureCsv(const Figure &figure, const Language &language, char decimalMark);

} // namespace palmer
