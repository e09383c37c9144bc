// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QToolButton;

namespace palmer::ui {

/// Out, in and the whole, beside a figure that can be zoomed: what wheel and keys do, to be seen.
class ZoomButtons : public QWidget {
    Q_OBJECT

public:
    explicit ZoomButtons(QWidget *parent = nullptr);

signals:
    /// In by so many steps of the wheel, out where negative.
    void zoomWanted(int steps);
    void fitWanted();

protected:
    void changeEvent(QEvent *event) override;

private:
    void retranslate();

    QToolButton *m_out;
    QToolButton *m_in;
    QToolButton *m_fit;
};

} // namespace palmer::ui
