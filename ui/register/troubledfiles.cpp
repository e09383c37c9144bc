// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/troubledfiles.h"

#include "register/storedsentence.h"
#include "ui/madewidgets.h"
#include "ui/windowlanguage.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>

namespace palmer::ui {

TroubledFiles::TroubledFiles(const std::vector<ListedSource> &files, QWidget *parent)
    : QDialog(parent) {
    constexpr QSize usual(760, 400);
    setObjectName(QStringLiteral("troubledFilesDialog"));
    setWindowTitle(tr("Files of the register"));
    auto *list = made<QTreeWidget>("troubledList");
    list->setAccessibleName(tr("Files of the register"));
    list->setColumnCount(2);
    list->setHeaderLabels({tr("File"), tr("Reason")});
    list->setRootIsDecorated(false);
    list->setUniformRowHeights(true);
    list->setTextElideMode(Qt::ElideMiddle);
    bool anyGone = false;
    QList<QTreeWidgetItem *> rows;
    for (const ListedSource &file : files) {
        const bool isGone = file.state == QLatin1StringView("notFound");
        anyGone = anyGone || isGone;
        const QString path = QString(file.path).replace(u'\n', u' ');
        const QString why = isGone ? tr("not found any more")
                                   : sentenceFrom(file.error, windowLanguage()).replace(u'\n', u' ');
        rows << new QTreeWidgetItem({path, why});
        rows.back()->setToolTip(0, path);
        rows.back()->setToolTip(1, why);
    }
    list->addTopLevelItems(rows);
    list->header()->setSectionResizeMode(0, QHeaderView::Interactive);
    list->header()->resizeSection(0, usual.width() / 2);
    auto *words =
        new QLabel(files.empty() ? tr("All files of the register can be read.")
                                 : tr("They change nothing else. What is not found keeps its tests in "
                                      "the register until it is removed."));
    words->setWordWrap(true);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    auto *remove = buttons->addButton(tr("&Remove what is not found"), QDialogButtonBox::AcceptRole);
    remove->setObjectName(QStringLiteral("removeNotFound"));
    remove->setEnabled(anyGone);
    remove->setAutoDefault(false);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    inColumn(this, styleMargins, styleSpacing, {words, {list, 1}, buttons});
    resize(usual);
}

} // namespace palmer::ui
