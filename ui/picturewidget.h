// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPixmap>
#include <QWidget>

namespace palmer::ui {

/// A widget whose content is drawn once per size, pixel ratio, theme and language; whatever follows the
/// pointer is painted over that picture.
class PictureWidget : public QWidget {
    Q_OBJECT

public:
    using QWidget::QWidget;

protected:
    /// Draws the content over the background.
    virtual void drawPicture(QPainter &painter) = 0;
    virtual void paintOver(QPainter & /*painter*/) {}
    /// Draws the picture now if it is outdated.
    void drawAnew();
    /// Draws the picture anew with the next repaint.
    void discardPicture();

    void paintEvent(QPaintEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    QPixmap m_picture; ///< null if outdated
};

/// Frames a canvas while it has the keyboard focus.
void paintFocus(QPainter &painter, const QWidget &canvas);

} // namespace palmer::ui
