// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"

#include <QPalette>
#include <QString>

class QCategoryAxis;

namespace palmer::ui {

/// An axis of a chart with the ticks of `range`: their numbers have the decimals, the point and the minus of
/// the language, which those of Qt's own axis have not.
[[nodiscard]] QCategoryAxis *makeNumberAxis(const FigureAxis &range, const QPalette &palette,
                                            const QString &title = {});

/// Those of the ticks that lie in what the axis shows.
void fillTicks(QCategoryAxis &axis, const FigureAxis &range);

} // namespace palmer::ui
