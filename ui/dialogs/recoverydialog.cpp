// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/recoverydialog.h"

#include "ui/madewidgets.h"
#include "ui/windowlanguage.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <algorithm>

namespace palmer::ui {

RecoveryDialog::RecoveryDialog(std::vector<Recovery> recoveries, QWidget *parent)
    : QDialog(parent)
    , m_recoveries(std::move(recoveries))
    , m_list(made<QListWidget>("recoveryList", trait::wrapped, this)) {
    setObjectName(QStringLiteral("recoveryDialog"));
    setWindowTitle(tr("Unsaved changes"));
    m_list->setAccessibleName(tr("Documents with unsaved changes"));
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setResizeMode(QListView::Adjust);
    for (const Recovery &recovery : m_recoveries) {
        QString name =
            recovery.origin.path.isEmpty()
                ? tr("Never saved: %1").arg(recovery.title.isEmpty() ? tr("Untitled") : recovery.title)
                : QFileInfo(recovery.origin.path).fileName();
        if (recovery.refusal)
            name = tr("%1 cannot be read: %2")
                       .arg(recovery.origin.path.isEmpty() ? QFileInfo(recovery.file).fileName() : name,
                            windowLanguage().sentence(recovery.refusal->message));
        const QString time = QLocale().toString(recovery.origin.saved.toLocalTime(), QLocale::ShortFormat);
        auto *item = new QListWidgetItem(tr("%1 — changes up to %2", "file, time").arg(name, time), m_list);
        item->setToolTip(recovery.refusal ? recovery.file : recovery.origin.path);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        item->setCheckState(recovery.refusal ? Qt::Unchecked : Qt::Checked);
    }
    m_list->setCurrentRow(0);
    auto *sentence =
        new QLabel(tr("Palmer ended without saving these documents. Open them with their changes? "
                      "The files themselves are as they were saved last."),
                   this);
    sentence->setWordWrap(true);
    auto *buttons = new QDialogButtonBox(this);
    m_recover = buttons->addButton(tr("&Open with changes"), QDialogButtonBox::AcceptRole);
    m_discard = buttons->addButton(tr("&Discard the changes"), QDialogButtonBox::DestructiveRole);
    auto *later = buttons->addButton(tr("&Later"), QDialogButtonBox::RejectRole);
    m_recover->setObjectName(QStringLiteral("recover"));
    m_discard->setObjectName(QStringLiteral("discardRecovery"));
    later->setObjectName(QStringLiteral("recoverLater"));
    m_recover->setProperty("primary", true);
    m_recover->setDefault(true);
    inColumn(this, styleMargins, styleSpacing, {sentence, m_list, buttons});
    resize(560, 280);
    connect(m_recover, &QPushButton::clicked, this, &RecoveryDialog::recover);
    connect(m_discard, &QPushButton::clicked, this, &RecoveryDialog::discard);
    connect(later, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_list, &QListWidget::itemChanged, this, &RecoveryDialog::enableButtons);
    enableButtons();
}

void RecoveryDialog::enableButtons() {
    const std::vector<std::size_t> chosen = checked();
    m_discard->setEnabled(!chosen.empty());
    m_recover->setEnabled(
        std::ranges::any_of(chosen, [&](std::size_t index) { return !m_recoveries[index].refusal; }));
}

std::vector<std::size_t> RecoveryDialog::checked() const {
    std::vector<std::size_t> result;
    for (int row = 0; row < m_list->count(); ++row) {
        if (m_list->item(row)->checkState() == Qt::Checked)
            result.push_back(static_cast<std::size_t>(row));
    }
    return result;
}

void RecoveryDialog::recover() {
    for (const std::size_t index : checked()) {
        if (!m_recoveries[index].refusal)
            emit recovered(m_recoveries[index]);
    }
    accept();
}

void RecoveryDialog::discard() {
    for (const std::size_t index : checked())
        discardRecovery(m_recoveries[index].file);
    accept();
}

} // namespace palmer::ui
