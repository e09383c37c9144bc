// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/drift/driftmodel.h"
#include "ui/model/documentmodel.h"
#include "ui/model/selection.h"
#include "ui/qtforward.h"
#include "ui/translated.h"

#include <QWidget>

namespace palmer::ui {

class TablePaste;

/// The page of a drift test: E_VE, the tests that use it, and the readings, typed or pasted, next to their
/// curve.
class DriftPage : public Translated<QWidget, QEvent::FontChange> {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(DriftPage)

public:
    DriftPage(DocumentModel &model, Selection &selection, QWidget *parent = nullptr);
    ~DriftPage() override; ///< destroys the table before its model

    /// Shows a drift test; empty for any other.
    void show(const EvaluatedDocument &evaluated, std::size_t test);
    void setLanguage(const Language &language);

    /// Texts typed that are not in the document.
    [[nodiscard]] QStringList refusedTexts() const { return m_readings.unfinishedTexts(); }

    /// Undoes the last refused typing. False if there is none.
    bool undoRefused() { return m_readings.undoRefused(); }

protected:
private:
    void makeTable();
    void connectParts();
    void arrange();
    void refresh();
    void retranslate() final { refresh(); }
    void paste();
    void removeRows();
    void goOn();
    void showReason(const QString &reason);
    void write(std::size_t row, const std::vector<DriftReading> &readings);
    [[nodiscard]] QString takenBy() const;
    [[nodiscard]] const Test *test() const;

    DocumentModel &m_model;
    Selection &m_selection;
    EvaluatedDocument m_evaluated;
    std::size_t m_test = 0;
    Language m_language{Language::Id::english};
    DriftModel m_readings;
    QLabel *m_range;
    QLabel *m_explained;
    QLabel *m_taken;
    QLabel *m_reason;
    QToolButton *m_paste;
    QToolButton *m_remove;
    QTableView *m_table;
    TablePaste *m_pasted;     ///< what was pasted last
    bool m_following = false; ///< the selection of the window is what moves the current cell
};

} // namespace palmer::ui
