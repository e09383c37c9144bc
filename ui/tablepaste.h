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

/// A table pasted into a page: read and put by one edit. Each answer in the bar below the page undoes that
/// edit and puts the table again. The next edit hides the bar.
class TablePaste : public QObject {
    Q_OBJECT

public:
    /// Reads what was pasted and edits the document, unless there are questions; throws Error.
    using Put = std::function<Pasted(const ImportOptions &answers)>;

    TablePaste(DocumentModel &model, QWidget &page);

    /// `counted`: what was pasted, in words: "3 limits pasted".
    void take(Put put, QString (*counted)(int taken));
    /// Hides the bar; what was put stays.
    void end();

signals:
    /// The text cannot be read.
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
