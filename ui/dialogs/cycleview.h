// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/planning/cycleprogram.h"

#include <QWidget>

namespace palmer::ui {

/// Diagram of the measuring cycle over its axis: positions from left to right, time from top to bottom. A dot
/// wherever the axis stops for a reading; each direction in its colour with arrows.
class CycleView : public QWidget {
    Q_OBJECT

public:
    explicit CycleView(QWidget *parent = nullptr);

    /// `over`: what of it lies beyond the axis, hatched in red.
    void show(const CycleProgram &program, const Overtravel &over);

    [[nodiscard]] QSize sizeHint() const override { return {460, 300}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    CycleProgram m_program;
    Overtravel m_over;
};

} // namespace palmer::ui
