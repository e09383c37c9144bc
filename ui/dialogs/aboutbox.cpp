// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/aboutbox.h"

#include <QCoreApplication>
#include <QIcon>
#include <QMessageBox>

namespace palmer::ui {

void showAbout(QWidget *parent) {
    auto *box = new QMessageBox(QMessageBox::NoIcon,
                                QCoreApplication::translate("palmer::ui::MainWindow", "About Palmer"),
                                QStringLiteral("Palmer " PALMER_VERSION), QMessageBox::Ok, parent);
    box->setObjectName(QStringLiteral("aboutBox"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setIconPixmap(QIcon(QStringLiteral(":/icons/palmer.svg")).pixmap(QSize(64, 64)));
    box->setInformativeText(QCoreApplication::translate(
        "palmer::ui::MainWindow",
        "Evaluates tests of machine tools after ISO 230-2 and ISO 230-4 and prints the "
        "report. Free software under the GNU General Public License, version 3 or later; "
        "without any warranty."));
    box->open();
}

} // namespace palmer::ui
