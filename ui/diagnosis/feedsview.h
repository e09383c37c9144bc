// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/diagnosisfigure.h"
#include "language/language.h"
#include "print/figures/drawfigure.h"
#include "print/figures/style.h"

#include <QPixmap>
#include <QWidget>
#include <optional>
#include <span>

namespace palmer::ui {

/// The circles of several feeds, superimposed in the available space; zooms and pans like a test's figure.
class FeedsView : public QWidget {
    Q_OBJECT

public:
    explicit FeedsView(QWidget *parent = nullptr);

    /// Both spans must stay alive until others are shown; empty spans show nothing.
    void show(std::span<const DiagnosedTest> tests, std::span<const PathProfile> paths,
              const Language &language);
    /// The figure as drawn.
    [[nodiscard]] CircleFigure figure();
    [[nodiscard]] const CircleView &view() const { return m_view; }
    void setView(const CircleView &view);
    void fit() { setView({}); }

    [[nodiscard]] QSize minimumSizeHint() const override { return {180, 150}; }
    [[nodiscard]] QSize sizeHint() const override { return {240, 220}; }

protected:
    void paintEvent(QPaintEvent *event) override;
    void changeEvent(QEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    void makeWhole();
    void drawAnew();
    void zoom(double factor, const QPointF &about);
    void pan(const QPointF &by);
    void drawKey(QPainter &painter, const std::vector<CircleLegendEntry> &entries, Medium medium) const;

    std::span<const DiagnosedTest> m_tests;
    std::span<const PathProfile> m_paths;
    Language m_language{Language::Id::english};
    std::optional<CircleFigure> m_whole; ///< for the widget's size; null if outdated
    CircleView m_view;
    FigureTransform m_transform;
    std::optional<QPointF> m_drag; ///< last position of the pointer
    QPixmap m_drawn;               ///< null if outdated
};

} // namespace palmer::ui
