// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/diagnosisfigure.h"
#include "language/language.h"
#include "ui/figures/style.h"

#include <QPixmap>
#include <QWidget>
#include <span>

namespace palmer::ui {

/// The circles of several feeds over one another, as large as there is room.
class FeedsView : public QWidget {
    Q_OBJECT

public:
    explicit FeedsView(QWidget *parent = nullptr);

    /// Both spans have to live until other ones are shown; empty: nothing.
    void show(std::span<const DiagnosedTest> tests, std::span<const PathProfile> paths,
              const Language &language);
    /// As it is drawn.
    [[nodiscard]] CircleFigure figure() const;

    [[nodiscard]] QSize minimumSizeHint() const override { return {180, 150}; }
    [[nodiscard]] QSize sizeHint() const override { return {240, 220}; }

protected:
    void paintEvent(QPaintEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void drawKey(QPainter &painter, const std::vector<CircleLegendEntry> &entries, Medium medium) const;

    std::span<const DiagnosedTest> m_tests;
    std::span<const PathProfile> m_paths;
    Language m_language{Language::Id::english};
    QPixmap m_drawn; ///< null: to be drawn
};

} // namespace palmer::ui
