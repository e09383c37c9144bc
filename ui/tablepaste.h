// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editing/pastedtable.h"

#include <QObject>
#include <functional>

class QWidget;

namespace palmer::ui {

class DocumentModel;
class PasteBar;

/// A table that was pasted into a page: read and put by one edit, and anew in its place where the bar below
/// the page is answered. The bar goes with the next edit.
class TablePaste : public QObject {
    Q_OBJECT

public:
    /// Reads what was pasted and edits the document, unless there are questions; throws Error.
    using Put = std::function<Pasted(const ImportOptions &answers)>;

    TablePaste(DocumentModel &model, QWidget &page);

    /// `counted`: what was pasted, in words: "3 limits pasted".
    void take(Put put, QString (*counted)(int taken));
    /// Leaves what was put as it is.
    void end();

signals:
    /// Nothing could be read.
    void refused(const QString &sentence);
    void undone();

private:
    void read();
    PasteBar &bar();

    DocumentModel &m_model;
    QWidget &m_page;
    PasteBar *m_bar = nullptr;
    Put m_put;
    QString (*m_counted)(int) = nullptr;
    ImportOptions m_answers;
    int m_index = -1; ///< of the stack of edits, behind the paste
};

} // namespace palmer::ui
