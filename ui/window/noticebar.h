// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/qtforward.h"

#include <QFrame>
#include <functional>

namespace palmer::ui {

/// A non-modal bar above the workplace with a sentence and buttons for answers.
class NoticeBar : public QFrame {
    Q_OBJECT

public:
    explicit NoticeBar(QWidget *parent = nullptr);

    struct Answer {
        QString name; ///< of the object, for tests
        QString text; ///< with mnemonic
        std::function<void()> action;
    };

    struct Notice {
        QString sentence;
        QList<Answer> answers;
    };

    /// Shows a notice in the language of the window, also when that changes; every answer closes the bar. A
    /// new notice replaces the former.
    void show(std::function<Notice()> notice);

    [[nodiscard]] QString sentence() const;

protected:
    void changeEvent(QEvent *event) override;

private:
    void fill();

    std::function<Notice()> m_notice;
    QLabel *m_sentence;
    QHBoxLayout *m_row;
    QList<QWidget *> m_answers;
};

} // namespace palmer::ui
