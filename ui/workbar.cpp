// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbar.h"

#include "ui/madewidgets.h"
#include "ui/theme.h"
#include "ui/windowlanguage.h"

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <algorithm>
#include <utility>

namespace palmer::ui {

namespace {

QString sizeText(long long bytes) {
    constexpr double mebibyte = 1 << 20; // the unit of sizes in file dialogs
    return windowLanguage().number(static_cast<double>(bytes) / mebibyte, Quantity::count, 1);
}

QString countText(long long count) {
    return windowLanguage().number(static_cast<double>(count), Quantity::count, 0);
}

constexpr int showAfter = 300; ///< ms
constexpr int lookEach = 100;  ///< ms
constexpr int steps = 1000;    ///< of the bar's range
constexpr int barWidth = 96;
constexpr int workBarHeight = 4;

} // namespace

WorkBar::WorkBar(QWidget *parent)
    : Translated(parent)
    , m_count(made<QLabel>("workCount", TextSize::small, trait::secondary, this))
    , m_bar(new QProgressBar(this))
    , m_cancel(made<QPushButton>("cancelWork", trait::notDefault, this))
    , m_later(new QTimer(this))
    , m_look(new QTimer(this)) {
    setObjectName(QStringLiteral("workBar"));
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred); // keeps its parts together in an empty bar
    m_bar->setTextVisible(false);
    m_bar->setFixedSize(barWidth, workBarHeight);
    m_cancel->setProperty("link", true); // flat, to fit into a status bar
    inRow(this, noMargins, 8, {m_count, m_bar, m_cancel});
    m_later->setSingleShot(true);
    m_later->setInterval(showAfter);
    connect(m_later, &QTimer::timeout, this, &QWidget::show);
    m_look->setInterval(lookEach);
    connect(m_look, &QTimer::timeout, this, &WorkBar::showProgress);
    connect(m_cancel, &QPushButton::clicked, this, &WorkBar::cancelled);
    retranslate();
    hide();
}

void WorkBar::begin(const QString &text, std::shared_ptr<const ReadProgress> progress) {
    m_bar->setAccessibleName(text);
    if (isHidden())
        m_count->setMinimumWidth(0);
    m_progress = std::move(progress);
    showProgress();
    m_look->start();
    if (isHidden() && !m_later->isActive())
        m_later->start();
}

void WorkBar::end() {
    m_later->stop();
    m_look->stop();
    hide();
}

/// The bar is indeterminate while nothing is counted, and when all is read but not yet interpreted.
void WorkBar::showProgress() {
    const long long done = m_progress ? m_progress->done.load() : 0;
    const long long of = m_progress ? m_progress->of.load() : 0;
    QString text;
    if (m_progress && m_progress->unit == ReadProgress::Unit::trials)
        text = of > 0 ? tr("%1 of %2 trials").arg(countText(done), countText(of))
                      : tr("%1 trials").arg(countText(done));
    else if (of > 0)
        text = tr("%1 of %2 MiB").arg(sizeText(done), sizeText(of));
    m_count->setVisible(!text.isEmpty());
    m_count->setText(text);
    m_count->setMinimumWidth(std::max(m_count->minimumWidth(), m_count->sizeHint().width())); // never shrinks
    const bool known = of > 0 && done < of;
    m_bar->setRange(0, known ? steps : 0);
    if (known)
        m_bar->setValue(static_cast<int>(done * steps / of));
}

void WorkBar::retranslate() {
    showProgress();
    m_cancel->setText(tr("Cancel"));
    m_cancel->setAccessibleName(tr("Cancel reading"));
    m_cancel->setToolTip(tr("Cancel reading: all stays as it was"));
}

} // namespace palmer::ui
