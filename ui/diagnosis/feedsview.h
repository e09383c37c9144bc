// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/diagnosisfigure.h"
#include "print/figures/style.h"
#include "ui/figures/circleplot.h"

#include <span>

namespace palmer::ui {

/// The circles of several feeds, superimposed in the available space; zooms and pans like a test's figure.
class FeedsView : public CirclePlot {
    Q_OBJECT

public:
    explicit FeedsView(QWidget *parent = nullptr);

    /// Both spans must stay alive until others are shown; empty spans show nothing.
    void show(std::span<const DiagnosedTest> tests, std::span<const PathProfile> paths,
              const Language &language);
    /// The figure as drawn.
    [[nodiscard]] CircleFigure figure();

    [[nodiscard]] QSize minimumSizeHint() const override { return {180, 150}; }
    [[nodiscard]] QSize sizeHint() const override { return {240, 220}; }

protected:
    [[nodiscard]] CircleFigure wholeFigure(QSizeF size, double pointStep) const override;
    [[nodiscard]] std::span<const PathProfile> paths() const override { return m_paths; }
    [[nodiscard]] QRectF plotArea() const override;
    void drawPicture(QPainter &painter) override;

private:
    void drawKey(QPainter &painter, const std::vector<CircleLegendEntry> &entries, Medium medium) const;

    std::span<const DiagnosedTest> m_tests;
    std::span<const PathProfile> m_paths;
};

} // namespace palmer::ui
