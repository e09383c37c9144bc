// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/comparison.h"

#include <QWidget>

namespace palmer::ui {

/// The mean deviations or paths of several tests superimposed. Lines differ by colour, dashes and markers.
class ComparisonView : public QWidget {
    Q_OBJECT

public:
    explicit ComparisonView(QWidget *parent = nullptr);

    void show(const ComparisonFigure &figure);

    [[nodiscard]] QSize sizeHint() const override { return {640, 260}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    ComparisonFigure m_figure;
};

} // namespace palmer::ui
