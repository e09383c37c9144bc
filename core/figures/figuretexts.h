// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "language/language.h"

#include <QByteArray>

namespace palmer {

/// Text alternative of a figure for screen readers: what is drawn, over what, from which value to which, with
/// the texts and in the units of the figure.
[[nodiscard]] QString figureSentence(const Figure &figure, const Language &language);

/// Points of a figure as CSV, UTF-8, one per row: its line, and its coordinates on the axes of the figure (in
/// their units, with no more digits than the values have; circles: angle in degrees and radial deviation in
/// µm about the centre named in the figure; synthetic paths carry a *). The title is a # comment. Cells are
/// separated by `;` with a decimal comma, otherwise by `,`.
[[nodiscard]] QByteArray figureCsv(const Figure &figure, const Language &language, char decimalMark);

} // namespace palmer
