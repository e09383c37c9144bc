// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/statementsbox.h"

namespace palmer::ui {

StatementsBox::StatementsBox(QWidget *parent)
    : QCheckBox(parent) {
    setObjectName(QStringLiteral("takeStatements"));
    hide();
}

void StatementsBox::offer(const QString &test) {
    QString name = test;
    name.replace(u'&', QStringLiteral("&&"));
    setText(tr("Take &over what is stated of “%1”").arg(name));
    setToolTip(
        tr("Instruments, state of the machine, places of the sensors, agreed points that name no axis, "
           "decision rule; nothing that was measured, no limits."));
    setChecked(true);
    show();
}

} // namespace palmer::ui
