// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/qtforward.h"

#include <QWidget>
#include <array>

namespace palmer::ui {

/// Shown in place of tests and trend before a folder is chosen: the purpose of the register, the only button,
/// what it does to files.
class RegisterFirstUse : public QWidget {
    Q_OBJECT

public:
    explicit RegisterFirstUse(QWidget *parent = nullptr);

signals:
    void folderWanted();

protected:
    void changeEvent(QEvent *event) override;

private:
    struct Fact {
        QLabel *mark = nullptr;
        QLabel *title = nullptr;
        QLabel *text = nullptr;
    };

    QWidget *makeFacts();
    void retranslate();
    void colour();

    QWidget *m_picture;
    QLabel *m_title;
    QLabel *m_text;
    QPushButton *m_choose;
    QLabel *m_drop;
    std::array<Fact, 3> m_facts;
};

/// Placeholder rows of machines, fading downwards.
class GhostRows : public QWidget {
    Q_OBJECT

public:
    using QWidget::QWidget;

protected:
    void paintEvent(QPaintEvent *event) override;
};

} // namespace palmer::ui
