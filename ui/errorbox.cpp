// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/errorbox.h"

#include "document/documenterror.h"
#include "ui/windowlanguage.h"

#include <QCoreApplication>

namespace palmer::ui {

QString capitalised(QString text) {
    if (!text.isEmpty())
        text[0] = text[0].toUpper();
    return text;
}

QMessageBox *showError(QWidget *parent, const QString &what, const QString &why, QMessageBox::Icon icon,
                       const QString &title) {
    auto *box = new QMessageBox(icon, title.isEmpty() ? parent->window()->windowTitle() : title, what,
                                QMessageBox::Ok, parent);
    box->setObjectName(QStringLiteral("errorBox"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextFormat(Qt::PlainText); // file names may look like markup
    box->setInformativeText(capitalised(why));
    box->open();
    return box;
}

QMessageBox *showError(QWidget *parent, const QString &what, const Error &error, QMessageBox::Icon icon,
                       const QString &title) {
    QString why = windowLanguage().sentence(error.message);
    if (!error.place.empty())
        why += QStringLiteral("\n\n") + QCoreApplication::translate("palmer::ui::ErrorBox", "Place: %1")
                                            .arg(QString::fromStdString(error.place));
    return showError(parent, what, why, icon, title);
}

} // namespace palmer::ui
