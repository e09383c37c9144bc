// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "language/language.h"
#include "ui/model/documentmodel.h"
#include "ui/model/selection.h"
#include "ui/qtforward.h"
#include "ui/readings/readingseditor.h"
#include "ui/readings/readingsmodel.h"

#include <QWidget>

namespace palmer::ui {

class ReadingsView;
class TablePaste;
struct SaidPaste;

/// The page "Readings" of a positioning test: choice of unit and grouping, and the table in which readings
/// are typed, pasted and excluded, and targets and runs added and removed. Over 500 lines: one function for
/// each command on the table.
class ReadingsPage : public QWidget {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(ReadingsPage)

public:
    ReadingsPage(DocumentModel &model, Selection &selection, QWidget *parent = nullptr);
    ~ReadingsPage() override; ///< destroys the table before its model

    void show(const EvaluatedDocument &evaluated, std::size_t test);
    void setLanguage(const Language &language);

    /// Actions of the page, with separators, for the window's menus. Shortcuts work in the table.
    [[nodiscard]] const QList<QAction *> &editActions() const { return m_editActions; }
    [[nodiscard]] const QList<QAction *> &testActions() const { return m_testActions; }

    /// Refused target positions, which are not in the document; refused readings are stored in it.
    [[nodiscard]] QStringList refusedTexts() const { return m_model.refusedTargets().texts(); }

    /// Undoes the last refused position. False if there is none.
    bool undoRefused();
    /// Makes a reading current and the only selected cell.
    void showReading(const ReadingPlace &place);
    /// Makes the position of a target the current cell.
    void showTarget(std::size_t target);
    /// Pastes the text of the clipboard at the current cell.
    void paste();
    /// The selected cells for a spreadsheet: tab-separated, with the decimal mark of the window's language.
    [[nodiscard]] QString copied() const;

signals:
    /// Mean and range of the selected readings, for the status bar; empty if none are selected.
    void summaryChanged(const QString &text);

protected:
    void changeEvent(QEvent *event) override;

private:
    QAction *addAction(QList<QAction *> &list, const QString &name, const QKeySequence &shortcut = {});
    void addSeparator(QList<QAction *> &list);
    void makeActions();
    void connectActions();
    void arrange();
    void connectParts();
    void retranslate();
    void nameUnits();
    void markRuling();
    void enableActions();
    SaidPaste pasteBlock(const QString &block, const BlockPlace &place, BlockChoices &choices);
    void fill(bool down);
    void askReason();
    QToolButton *addSegment(QButtonGroup &group, const char *segment, const char *name, int id);

    Selection &m_selection;
    ReadingsEditor m_editor;
    ReadingsModel m_model;
    ReadingsView *m_view = nullptr;
    TablePaste *m_pasted; ///< what was pasted last
    EvaluatedDocument m_evaluated;
    std::size_t m_test = 0;
    QToolButton *m_deviations = nullptr;
    QToolButton *m_positions = nullptr;
    QToolButton *m_byRun = nullptr;
    QToolButton *m_byDirection = nullptr;
    QToolButton *m_leaveOut = nullptr; ///< shown if there are such targets
    QToolButton *m_pasteButton = nullptr;
    QToolButton *m_addRunButton = nullptr;
    QList<QAction *> m_editActions;
    QList<QAction *> m_testActions;
    QAction *m_cut = nullptr;
    QAction *m_copy = nullptr;
    QAction *m_paste = nullptr;
    QAction *m_clear = nullptr;
    QAction *m_fillDown = nullptr;
    QAction *m_fillRight = nullptr;
    QAction *m_setAside = nullptr;
    QAction *m_bringBack = nullptr;
    QAction *m_insertAbove = nullptr;
    QAction *m_insertBelow = nullptr;
    QAction *m_removeTargets = nullptr;
    QAction *m_addRuns = nullptr;
    QAction *m_insertRun = nullptr;
    QAction *m_removeRuns = nullptr;
};

} // namespace palmer::ui
