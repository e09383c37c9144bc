// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "language/language.h"

#include <QByteArray>
#include <QString>

namespace palmer {

/// A figure as a file of its own: white, in the size of the printed page. The same figure gives the same
/// bytes at any time and place. Throws std::runtime_error when the device fails. Need a QApplication.
/// SVG: a picture with its title, and with what it shows in words of the language.
[[nodiscard]] QByteArray figureAsSvg(const Figure &figure, const QString &title, const Language &language);
[[nodiscard]] QByteArray figureAsPdf(const Figure &figure, const QString &title);
[[nodiscard]] QByteArray figureAsPng(const Figure &figure, int dotsPerInch = 300);

} // namespace palmer
