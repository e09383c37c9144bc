// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/translated.h"

#include <QWidget>

class QToolButton;

namespace palmer::ui {

/// Buttons next to a figure for zooming out and in and showing the whole, as wheel and keys do.
class ZoomButtons : public Translated<QWidget> {
    Q_OBJECT

public:
    explicit ZoomButtons(QWidget *parent = nullptr);

signals:
    /// Zoom in by so many wheel steps, or out if negative.
    void zoomWanted(int steps);
    void fitWanted();

private:
    void retranslate() final;

    QToolButton *m_out;
    QToolButton *m_in;
    QToolButton *m_fit;
};

} // namespace palmer::ui
