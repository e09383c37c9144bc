// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "language/language.h"

#include <QByteArray>
#include <QString>

namespace palmer {

/// A figure as a file: white, in its printed size. The same figure always gives the same bytes. Throw
/// std::runtime_error if the device fails. Require a QApplication. SVG: an image with its title and a
/// description in the language.
[[nodiscard]] QByteArray figureAsSvg(const Figure &figure, const QString &title, const Language &language);
[[nodiscard]] QByteArray figureAsPdf(const Figure &figure, const QString &title);
[[nodiscard]] QByteArray figureAsPng(const Figure &figure, int dotsPerInch = 300);

} // namespace palmer
