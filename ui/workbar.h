// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QProgressBar;
class QPushButton;
class QTimer;

namespace palmer::ui {

/// The bar of what is being done beside the window, with Cancel; what it is stands next to it. Appears only
/// when that takes longer than one waits without asking: what is done before shall not blink.
class WorkBar : public QWidget {
    Q_OBJECT

public:
    explicit WorkBar(QWidget *parent = nullptr);

    /// `text`: what is being done, for those who cannot see it.
    void begin(const QString &text);
    void end();

signals:
    void cancelled();

protected:
    void changeEvent(QEvent *event) override;

private:
    void retranslate();

    QProgressBar *m_bar;
    QPushButton *m_cancel;
    QTimer *m_later;
};

} // namespace palmer::ui
