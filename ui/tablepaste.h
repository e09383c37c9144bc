// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editing/pastedtable.h"

#include <QObject>
#include <functional>
#include <optional>

class QWidget;

namespace palmer::ui {

class DocumentModel;
class PasteBar;

/// The outcome in words: "3 limits pasted".
struct SaidPaste : Pasted {
    QString summary;
    std::optional<Motion> motion; ///< of readings, whose content can be chosen
};

/// A table pasted into a page: read and put by one edit. Each answer in the bar below the page undoes that
/// edit and puts the table again. The next edit hides the bar.
class TablePaste : public QObject {
    Q_OBJECT

public:
    /// Reads what was pasted and edits the document, unless there are questions; throws Error.
    using Put = std::function<SaidPaste(const ImportOptions &answers)>;

    TablePaste(DocumentModel &model, QWidget &page);

    void paste(Put put);
    /// Hides the bar; what was put stays.
    void end();

signals:
    /// The text cannot be read.
    void refused(const QString &sentence);
    void undone();

private:
    bool read();
    PasteBar &bar();

    DocumentModel &m_model;
    QWidget &m_page;
    PasteBar *m_bar = nullptr;
    Put m_put;
    ImportOptions m_answers;
    int m_index = -1; ///< of the stack of edits, behind the paste
    bool m_isReading = false;
};

/// Lets the keys of Paste and Delete call these in a table, although the window has them as shortcuts for
/// other kinds of test. Paste is heard from the whole window while the table is in view, but for fields of
/// text.
void takeTableKeys(QWidget &table, std::function<void()> paste, std::function<void()> remove);

} // namespace palmer::ui
