// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/targetstrip.h"
#include "ui/model/selection.h"

#include <QWidget>

namespace palmer::ui {

/// Draws the strip of a target; a hovered reading is highlighted here, in the table and in the figure.
class TargetStripView : public QWidget {
    Q_OBJECT

public:
    explicit TargetStripView(Selection &selection, QWidget *parent = nullptr);

    void setStrip(const TargetStrip &strip, std::size_t target);

    [[nodiscard]] QSize sizeHint() const override { return {320, 160}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {180, 110}; }

protected:
    void paintEvent(QPaintEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void leaveEvent(QEvent *event) override;

private:
    [[nodiscard]] QRectF plot() const;
    [[nodiscard]] double x(double value) const;
    [[nodiscard]] QRectF laneArea(std::size_t lane) const;
    [[nodiscard]] QPointF place(std::size_t lane, std::size_t reading) const;
    [[nodiscard]] std::vector<std::size_t> uncovered(std::size_t lane) const;
    void paintLane(QPainter &painter, std::size_t lane) const;
    void paintReversal(QPainter &painter) const;

    Selection &m_selection;
    TargetStrip m_strip;
    std::size_t m_target = 0;
};

} // namespace palmer::ui
