// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/registerstatus.h"

#include "register/storedsentence.h"
#include "ui/measures.h"
#include "ui/register/registerservice.h"
#include "ui/windowlanguage.h"

#include <QEvent>
#include <QPainter>
#include <cmath>

namespace palmer::ui {

RegisterStatus::RegisterStatus(RegisterService &service)
    : m_service(service) {
    constexpr int statusHeight = 27;
    m_unreadable->setProperty("bad", true);
    m_progress->setFixedSize(140, 6);
    m_progress->setTextVisible(false);
    m_progress->hide();
    for (QPushButton *link : {m_unreadable, m_stop})
        link->setFixedHeight(statusHeight - 4);
    m_stop->hide();
    for (QFrame *rule : m_rules) {
        rule->setProperty("rule", true);
        rule->setFixedSize(1, 14);
    }
    for (QWidget *one : std::initializer_list<QWidget *>{m_total, m_rules[0], m_state, m_progress, m_stop,
                                                         m_rules[1], m_unreadable})
        addWidget(one);
    addPermanentWidget(m_shown);
    setContentsMargins(pageMargin, 0, pageMargin, 0);
    setFixedHeight(statusHeight);
    setSizeGripEnabled(false);
    connect(m_unreadable, &QPushButton::clicked, this, &RegisterStatus::troubledFilesAsked);
    connect(m_stop, &QPushButton::clicked, &m_service, &RegisterService::stop);
    connect(&m_service, &RegisterService::progressed, this, &RegisterStatus::showProgress);
}

void RegisterStatus::changeEvent(QEvent *event) {
    QStatusBar::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) // the colour of the mark is set once
        showTroubled();
}

void RegisterStatus::retranslate() {
    m_stop->setText(tr("Stop"));
    m_stop->setToolTip(tr("Stop reading: what was read stays, Rescan goes on"));
}

void RegisterStatus::showState(int machines, int tests) {
    m_total->setText(withGroups(tr("%n machine(s)", nullptr, machines), machines) + QStringLiteral(" · ") +
                     withGroups(tr("%n test(s)", nullptr, tests), tests));
    m_total->setVisible(tests > 0);
    m_rules[0]->setVisible(tests > 0);
    showScan();
    showTroubled();
}

void RegisterStatus::showScan() {
    const auto folders = static_cast<int>(m_service.folders().size());
    const bool isScanning = m_service.isScanning();
    const QDateTime &scannedAt = m_service.scannedAt();
    QStringList said{folders == 0 ? tr("No folder is watched")
                                  : tr("%n folder(s) watched", nullptr, folders)};
    if (isScanning)
        said << tr("being read");
    else if (m_service.isStopped())
        said << tr("reading stopped");
    else if (scannedAt.isValid())
        said << tr("up to date at %1").arg(scannedAt.toString(QStringLiteral("HH:mm")));
    const QString &trouble = m_service.trouble();
    m_state->setText(trouble.isEmpty() ? said.join(QStringLiteral(", ")) : trouble);
    m_progress->setVisible(m_progress->isVisible() && isScanning);
    m_stop->setVisible(m_progress->isVisible());
}

void RegisterStatus::showProgress(int done, int total) {
    constexpr double soonest = 2; // s; before that the pace is unknown
    if (!m_service.isScanning())
        return;
    m_progress->setRange(0, total);
    m_progress->setValue(done);
    m_progress->setVisible(done < total);
    m_stop->setVisible(done < total);
    const auto grouped = [](int number) { return windowLanguage().number(number, Quantity::count); };
    QString said = tr("reading %1 of %2 file(s)", nullptr, total).arg(grouped(done), grouped(total));
    const double passed = m_service.secondsOfScan();
    if (done > 0 && passed >= soonest)
        said +=
            QStringLiteral(" · ") + tr("%1 s left").arg(std::ceil(passed * (total - done) / done), 0, 'f', 0);
    m_state->setText(said);
}

void RegisterStatus::showTroubled() {
    const ScanResult &result = m_service.result();
    const auto unreadable = static_cast<int>(result.unreadable.size());
    QStringList said;
    if (unreadable > 0)
        said << withGroups(tr("%n unreadable file(s)", nullptr, unreadable), unreadable);
    if (result.notFound > 0)
        said << withGroups(tr("%n file(s) not found", nullptr, result.notFound), result.notFound);
    m_unreadable->setVisible(!said.isEmpty());
    m_rules[1]->setVisible(!said.isEmpty());
    m_unreadable->setText(said.join(QStringLiteral(" · ")));
    QPixmap mark(QSize(16, 16) * devicePixelRatioF());
    mark.setDevicePixelRatio(devicePixelRatioF());
    mark.fill(Qt::transparent);
    QPainter painter(&mark);
    drawLineIcon(painter, QRect(0, 0, 16, 16), QStringLiteral("miss"), token(Token::bad, palette()));
    painter.end();
    m_unreadable->setIcon(QIcon(mark));
    QStringList reasons;
    constexpr std::size_t most = 12;
    for (std::size_t i = 0; i < std::min(result.unreadable.size(), most); ++i)
        reasons << result.unreadable[i].path + QStringLiteral(": ") +
                       sentenceFrom(result.unreadable[i].error, windowLanguage());
    m_unreadable->setToolTip(reasons.join(u'\n'));
}

void RegisterStatus::showTests(int shown, int chosen) {
    m_shown->setText(withGroups(tr("%n test(s) shown", nullptr, shown), shown) +
                     (chosen == 0 ? QString() : QStringLiteral(" · ") + tr("%n chosen", nullptr, chosen)));
}

void RegisterStatus::showHelpKey() {
    m_shown->setText(tr("F1 help"));
}

} // namespace palmer::ui
