// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/noticebar.h"

#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace palmer::ui {

NoticeBar::NoticeBar(QWidget *parent)
    : QFrame(parent)
    , m_sentence(made<QLabel>("noticeSentence", trait::wrapped, trait::plainText, this))
    , m_row(new QHBoxLayout(this)) {
    setObjectName(QStringLiteral("notice"));
    setProperty("notice", true);
    m_row->setContentsMargins(pageMargin, 6, pageMargin, 6);
    m_row->setSpacing(8);
    m_row->addWidget(m_sentence, 1);
    hide();
}

QString NoticeBar::sentence() const {
    return m_sentence->text();
}

void NoticeBar::show(std::function<Notice()> notice) {
    m_notice = std::move(notice);
    fill();
    QFrame::show();
}

void NoticeBar::changeEvent(QEvent *event) {
    if (event->type() == QEvent::LanguageChange && isVisibleTo(parentWidget()))
        fill();
    QFrame::changeEvent(event);
}

void NoticeBar::fill() {
    for (QWidget *old : std::as_const(m_answers))
        old->deleteLater();
    m_answers.clear();
    const Notice notice = m_notice();
    m_sentence->setText(QStringLiteral("⚠ ") + notice.sentence);
    setAccessibleName(notice.sentence);
    for (const Answer &answer : notice.answers) {
        auto *button = made<QPushButton>(answer.name, answer.text, this);
        connect(button, &QPushButton::clicked, this, [this, action = answer.action] {
            hide();
            if (action)
                action();
        });
        m_row->addWidget(button);
        m_answers << button;
    }
}

} // namespace palmer::ui
