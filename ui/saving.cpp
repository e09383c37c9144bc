// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/saving.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QLineEdit>
#include <QMainWindow>
#include <QStatusBar>
#include <algorithm>

namespace palmer::ui {

namespace {

/// "pdf" of "PDF documents (*.pdf)"; empty for "(*)".
QString endingOf(const QString &filter) {
    return filter.section(QStringLiteral("(*."), 1).chopped(filter.contains(QStringLiteral("(*.")) ? 1 : 0);
}

} // namespace

SaveDialog::SaveDialog(QWidget *parent, const QString &title, const QStringList &filters,
                       const QString &folder)
    : QFileDialog(parent, title, folder) {
    setAcceptMode(AcceptSave);
    setNameFilters(filters);
    // It must be known before the dialog asks about replacing a file.
    const auto follow = [this](const QString &filter) { setDefaultSuffix(endingOf(filter)); };
    follow(filters.front());
    connect(this, &QFileDialog::filterSelected, this, follow);
}

qsizetype SaveDialog::filterOf(const QString &name) const {
    const QStringList filters = nameFilters();
    const auto fits = [&](const QString &filter) {
        return name.endsWith(u'.' + endingOf(filter), Qt::CaseInsensitive);
    };
    const QString chosen = selectedNameFilter();
    if (endingOf(chosen).isEmpty() || fits(chosen))
        return filters.indexOf(chosen);
    const auto found = std::ranges::find_if(filters, fits);
    return found == filters.end() ? -1 : found - filters.begin();
}

void SaveDialog::accept() {
    auto *name = findChild<QLineEdit *>(QStringLiteral("fileNameEdit"));
    const QString text = name ? name->text() : QString();
    if (!text.isEmpty() && !QFileInfo(directory(), text).isDir() && filterOf(text) < 0)
        name->setText(text + u'.' + defaultSuffix());
    QFileDialog::accept();
}

QString askForPdf(QWidget *parent, const QString &title, const QString &name) {
    SaveDialog dialog(parent, title,
                      {QCoreApplication::translate("palmer::ui::Saving", "PDF documents (*.pdf)")});
    dialog.setObjectName(QStringLiteral("savePdfDialog"));
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
