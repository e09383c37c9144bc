// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/machinehead.h"

#include "ui/measures.h"
#include "ui/windowlanguage.h"

#include <QMenu>
#include <algorithm>

namespace palmer::ui {

MachineHead::MachineHead() {
    constexpr int headHeight = 52;
    setFixedHeight(headHeight);
    auto *names = inColumn(2, {m_name, m_facts});
    inRow(this, {pageMargin, 4, pageMargin, 4}, styleSpacing,
          {{names, 1}, m_intervalLabel, m_interval, m_due});
    connect(m_interval, &QComboBox::activated, this,
            [this] { emit intervalChosen(m_interval->currentData().toInt()); });
}

void MachineHead::retranslate() {
    m_intervalLabel->setText(tr("Interval"));
    m_interval->setAccessibleName(tr("Interval"));
    const int before = m_interval->currentIndex();
    m_interval->clear();
    for (const int months : {0, 1, 3, 6, 12, 18, 24, 36, 60})
        m_interval->addItem(months == 0 ? tr("none") : tr("%n month(s)", nullptr, months), months);
    m_interval->setCurrentIndex(std::max(before, 0));
}

void MachineHead::setMachine(const MachineRow *machine) {
    m_due->setVisible(false);
    m_interval->setEnabled(machine);
    m_name->clear();
    m_facts->clear();
    if (!machine)
        return;
    const ListedMachine &listed = machine->machine;
    m_name->setText(listed.title());
    QStringList facts{listed.manufacturer, listed.model,
                      listed.serialNumber.isEmpty() ? tr("not identified: no serial number")
                                                    : tr("No. %1").arg(listed.serialNumber),
                      listed.location};
    facts.removeAll(QString());
    m_facts->setText(facts.join(QStringLiteral(" · ")));
    m_interval->setCurrentIndex(std::max(m_interval->findData(listed.months.value_or(0)), 0));
    if (const std::optional<QDate> &due = machine->due.test) {
        const bool late = *due < QDate::currentDate();
        const QString day = windowLanguage().shortDate(due->toString(Qt::ISODate).toStdString());
        m_due->setContent(late ? tr("overdue since %1").arg(day) : tr("next test before %1").arg(day),
                          QStringLiteral("clock"), late ? Token::bad : Token::ok,
                          late ? Token::badGround : Token::okGround);
        m_due->setVisible(true);
    }
}

void MachineHead::fillIntervals(QMenu &menu) {
    menu.clear();
    for (int i = 0; i < m_interval->count(); ++i) {
        QAction *action = menu.addAction(m_interval->itemText(i), this, [this, i] {
            m_interval->setCurrentIndex(i);
            emit intervalChosen(m_interval->itemData(i).toInt());
        });
        action->setCheckable(true);
        action->setChecked(i == m_interval->currentIndex());
        action->setEnabled(m_interval->isEnabled());
    }
}

} // namespace palmer::ui
