// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"

#include <QPalette>
#include <QString>

class QCategoryAxis;
class QChart;

namespace palmer::ui {

/// A chart axis with the ticks of `range`, whose labels follow the language in decimals, decimal mark and
/// minus, unlike those of Qt's own axis.
[[nodiscard]] QCategoryAxis *makeNumberAxis(const FigureAxis &range, const QPalette &palette,
                                            const QString &title = {});

/// Sets the ticks that lie within the axis's range.
void fillTicks(QCategoryAxis &axis, const FigureAxis &range);

/// Takes away its series and axes.
void clear(QChart &chart);

} // namespace palmer::ui
