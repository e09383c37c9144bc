// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "ui/picturewidget.h"

#include <optional>

namespace palmer::ui {

/// A static figure with background and colours of the theme.
class FigureCard : public PictureWidget {
    Q_OBJECT

public:
    using PictureWidget::PictureWidget;

    /// A null figure clears the card.
    void setFigure(std::optional<Figure> figure);
    [[nodiscard]] const std::optional<Figure> &figure() const { return m_figure; }

protected:
    void drawPicture(QPainter &painter) override;

private:
    std::optional<Figure> m_figure;
};

/// A card with the proportions of a line figure.
class LineView : public FigureCard {
    Q_OBJECT

public:
    using FigureCard::FigureCard;

    [[nodiscard]] QSize minimumSizeHint() const override { return {240, 160}; }
    [[nodiscard]] QSize sizeHint() const override { return {480, 270}; }
};

} // namespace palmer::ui
