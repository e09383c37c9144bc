// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/saving.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QMainWindow>
#include <QStatusBar>

namespace palmer::ui {

QString askForPdf(QWidget *parent, const QString &title, const QString &name) {
    QFileDialog dialog(parent, title, QString(),
                       QCoreApplication::translate("palmer::ui::Saving", "PDF documents (*.pdf)"));
    dialog.setObjectName(QStringLiteral("savePdfDialog"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("pdf"));
    dialog.selectFile(QString(name).replace(u'/', u'-') + QStringLiteral(".pdf"));
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().constFirst() : QString();
}

void saySaved(QWidget *from, const QString &path) {
    constexpr int shown = 10'000; // ms
    while (from && !qobject_cast<QMainWindow *>(from))
        from = from->parentWidget();
    if (auto *window = qobject_cast<QMainWindow *>(from))
        window->statusBar()->showMessage(QCoreApplication::translate("palmer::ui::Saving", "Saved: %1")
                                             .arg(QDir::toNativeSeparators(path)),
                                         shown);
}

} // namespace palmer::ui
