// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>

namespace palmer::ui {

namespace {

constexpr int showAfter = 300; ///< ms
constexpr int barWidth = 96;
constexpr int barHeight = 4;

} // namespace

WorkBar::WorkBar(QWidget *parent)
    : QWidget(parent)
    , m_bar(new QProgressBar(this))
    , m_cancel(new QPushButton(this))
    , m_later(new QTimer(this)) {
    setObjectName(QStringLiteral("workBar"));
    m_bar->setTextVisible(false);
    m_bar->setFixedSize(barWidth, barHeight);
    m_bar->setRange(0, 0); // how much is left no reader of files can tell
    m_cancel->setObjectName(QStringLiteral("cancelWork"));
    m_cancel->setAutoDefault(false);
    m_cancel->setProperty("link", true); // flat: it has room in a status bar
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    row->addWidget(m_bar);
    row->addWidget(m_cancel);
    m_later->setSingleShot(true);
    m_later->setInterval(showAfter);
    connect(m_later, &QTimer::timeout, this, &QWidget::show);
    connect(m_cancel, &QPushButton::clicked, this, &WorkBar::cancelled);
    retranslate();
    hide();
}

void WorkBar::begin(const QString &text) {
    m_bar->setAccessibleName(text);
    if (isHidden() && !m_later->isActive())
        m_later->start();
}

void WorkBar::end() {
    m_later->stop();
    hide();
}

void WorkBar::changeEvent(QEvent *event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

void WorkBar::retranslate() {
    m_cancel->setText(tr("Cancel"));
    m_cancel->setAccessibleName(tr("Cancel reading"));
    m_cancel->setToolTip(tr("Cancel reading: all stays as it was"));
}

} // namespace palmer::ui
