// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "ui/picturewidget.h"

namespace palmer::ui {

/// Shows a line figure in the window's theme.
class LineView : public PictureWidget {
    Q_OBJECT

public:
    using PictureWidget::PictureWidget;

    void setFigure(const LineFigure &figure);
    [[nodiscard]] const LineFigure &figure() const { return m_figure; }

    [[nodiscard]] QSize minimumSizeHint() const override { return {240, 160}; }
    [[nodiscard]] QSize sizeHint() const override { return {480, 270}; }

protected:
    void drawPicture(QPainter &painter) override;

private:
    LineFigure m_figure;
};

} // namespace palmer::ui
