// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/readprogress.h"
#include "ui/qtforward.h"
#include "ui/translated.h"

#include <QWidget>
#include <memory>

namespace palmer::ui {

/// Progress bar of a background job with its count and Cancel; the job is named next to it. Appears after a
/// delay, so that short jobs do not flash it.
class WorkBar : public Translated<QWidget> {
    Q_OBJECT

public:
    explicit WorkBar(QWidget *parent = nullptr);

    /// `text`: the job, for screen readers. `progress`: null if nothing is counted.
    void begin(const QString &text, std::shared_ptr<const ReadProgress> progress = {});
    void end();

signals:
    void cancelled();

private:
    void showProgress();
    void retranslate() final;

    QLabel *m_count;
    QProgressBar *m_bar;
    QPushButton *m_cancel;
    QTimer *m_later;
    QTimer *m_look;
    std::shared_ptr<const ReadProgress> m_progress;
};

} // namespace palmer::ui
