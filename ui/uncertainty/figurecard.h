// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"

#include <QPixmap>
#include <QWidget>
#include <optional>

namespace palmer::ui {

/// A static figure with background and colours of the theme.
class FigureCard : public QWidget {
    Q_OBJECT

public:
    explicit FigureCard(QWidget *parent = nullptr);

    /// A null figure clears the card.
    void setFigure(std::optional<Figure> figure);
    [[nodiscard]] const std::optional<Figure> &figure() const { return m_figure; }

protected:
    void paintEvent(QPaintEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    std::optional<Figure> m_figure;
    QPixmap m_drawn; ///< null if outdated
};

} // namespace palmer::ui
