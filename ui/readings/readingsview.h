// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/model/selection.h"
#include "ui/readings/readingsdelegate.h"
#include "ui/readings/readingsmodel.h"

#include <QTableView>
#include <vector>

class QLabel;

namespace palmer::ui {

class ReadingsEditor;

/// The table of readings: a two-row header, and the columns i and P that stay while the rest scrolls.
/// Typing replaces, F2 edits, Esc restores; Enter follows the measuring cycle, Shift+Enter backwards; Tab
/// goes right. Over 500 lines: header, fixed columns and keys of one table.
class ReadingsView : public QTableView {
    Q_OBJECT

public:
    ReadingsView(ReadingsModel &model, ReadingsEditor &editor, Selection &selection,
                 QWidget *parent = nullptr);

    /// Adapts the column widths after the model has changed.
    void fitColumns();
    /// Indices of the targets that determine the explained result.
    void setRuling(const std::vector<std::size_t> &targets);

    /// Places of the selected readings, row by row.
    [[nodiscard]] std::vector<ReadingPlace> selectedPlaces() const;
    /// Selected rows and columns, sorted without repetition.
    [[nodiscard]] std::vector<int> selectedRows() const;
    [[nodiscard]] std::vector<int> selectedColumns() const;

    void step(ReadingsDelegate::Step step);

    /// Undoes the last refused position. False if there is none.
    bool undoRefused();
    /// Shows a sentence next to the current cell until another cell becomes current.
    void say(const QString &sentence);

signals:
    /// Mean and range of the selection; empty if there is none.
    void summaryChanged(const QString &text);
    /// A text was typed into a cell.
    void typed();

protected:
    void resizeEvent(QResizeEvent *event) override;
    void selectionChanged(const QItemSelection &selected, const QItemSelection &deselected) override;
    void currentChanged(const QModelIndex &current, const QModelIndex &previous) override;
    void keyPressEvent(QKeyEvent *event) override;
    bool viewportEvent(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;
    void scrollTo(const QModelIndex &index, ScrollHint hint) override;
    void scrollContentsBy(int dx, int dy) override;
    void updateGeometries() override;
    bool edit(const QModelIndex &index, EditTrigger trigger, QEvent *event) override;
    void keyboardSearch(const QString &) override {} ///< digits are input, not a search

private:
    void hover(const QModelIndex &index);
    void showHovered();
    void showCurrent();
    void showNext();
    void showReason();
    void take(const QModelIndex &index, const QString &text);
    void moveTo(const QModelIndex &index);
    /// True if Tab, or Shift+Tab, leaves the table at its end.
    [[nodiscard]] bool isAtEnd(bool forward);
    void placeFrozen();
    [[nodiscard]] int rowHeight() const;
    void setRowHeight();
    /// Width of the column's widest text with margins, at least that of a usual column unless `tight`.
    [[nodiscard]] int widthOf(int column, bool tight) const;
    void shareWidth();

    ReadingsModel &m_model;
    ReadingsEditor &m_editor;
    Selection &m_selection;
    QTableView *m_frozen;
    QLabel *m_reason;                ///< why a text is not a number, next to its cell
    std::vector<int> m_contents;     ///< widths of the texts per column, including hidden ones
    QPersistentModelIndex m_typed;   ///< the last typed cell
    QPersistentModelIndex m_refused; ///< a position refused since the last undo step
    QString m_said;                  ///< sentence at the current cell
    QModelIndex m_hovered;
    bool m_following = false; ///< the selection is moving the current cell
};

} // namespace palmer::ui
