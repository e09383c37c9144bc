// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/readprogress.h"

#include <QWidget>
#include <memory>

class QLabel;
class QProgressBar;
class QPushButton;
class QTimer;

namespace palmer::ui {

/// The bar of what is being done beside the window, with how much of it is done and Cancel; what it is stands
/// next to it. Appears only when that takes longer than one waits without asking: what is done before shall
/// not blink.
class WorkBar : public QWidget {
    Q_OBJECT

public:
    explicit WorkBar(QWidget *parent = nullptr);

    /// `text`: what is being done, for those who cannot see it. `progress`: null where nothing is counted.
    void begin(const QString &text, std::shared_ptr<const ReadProgress> progress = {});
    void end();

signals:
    void cancelled();

protected:
    void changeEvent(QEvent *event) override;

private:
    void showProgress();
    void retranslate();

    QLabel *m_count;
    QProgressBar *m_bar;
    QPushButton *m_cancel;
    QTimer *m_later;
    QTimer *m_look;
    std::shared_ptr<const ReadProgress> m_progress;
};

} // namespace palmer::ui
