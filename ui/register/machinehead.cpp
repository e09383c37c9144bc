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
    m_name->setText(machine->title());
    m_facts->setText(machine->facts().join(QStringLiteral(" · ")));
    const int months = machine->machine.months.value_or(0);
    if (m_interval->findData(months) < 0) // said on the command line
        m_interval->addItem(tr("%n month(s)", nullptr, months), months);
    m_interval->setCurrentIndex(m_interval->findData(months));
    const auto dayText = [](const QDate &date) {
        return windowLanguage().shortDate(date.toString(Qt::ISODate).toStdString());
    };
    const auto isLate = [](const QDate &due) { return due < QDate::currentDate(); };
    const auto dueText = [&](const QString &axes, const QDate &due) {
        return (isLate(due) ? tr("%1: overdue since %2") : tr("%1: next test before %2"))
            .arg(axes, dayText(due));
    };
    if (const std::optional<QDate> due = machine->due.test()) {
        const bool late = isLate(*due);
        m_due->setContent(dueText(machine->due.axesDue(*due), *due), QStringLiteral("clock"),
                          late ? Token::bad : Token::ok, late ? Token::badGround : Token::okGround);
        QStringList all;
        for (const auto &[axis, date] : machine->due.tests)
            all << dueText(axis, date);
        if (machine->due.certificate)
            all << tr("certificate expires on %1").arg(dayText(*machine->due.certificate));
        m_due->setToolTip(all.join(u'\n'));
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
    if (!m_due->isVisible())
        return;
    menu.addSeparator(); // the tooltip needs a pointer
    for (const QString &line : m_due->toolTip().split(u'\n'))
        menu.addAction(line)->setEnabled(false);
}

} // namespace palmer::ui
