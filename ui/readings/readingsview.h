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

/// The table of readings: a head of two storeys, and i and P that stay while the rest scrolls. Typing
/// replaces, F2 edits, Esc restores; Enter walks the measuring cycle, Shift+Enter back; Tab goes to the
/// right.
class ReadingsView : public QTableView {
    Q_OBJECT

public:
    ReadingsView(ReadingsModel &model, ReadingsEditor &editor, Selection &selection,
                 QWidget *parent = nullptr);

    /// Widths of columns after the model changed what it shows.
    void fitColumns();
    /// Targets (indices) that rule the result explained.
    void setRuling(const std::vector<std::size_t> &targets);

    /// The places of readings among the cells selected, row by row.
    [[nodiscard]] std::vector<ReadingPlace> selectedPlaces() const;
    /// Rows and columns selected, each once, in order.
    [[nodiscard]] std::vector<int> selectedRows() const;
    [[nodiscard]] std::vector<int> selectedColumns() const;

    void step(ReadingsDelegate::Step step);

    /// Takes back a position that was typed last and cannot be taken; false: none was.
    bool undoRefused();
    /// Says something beside the current cell, until another becomes the current one.
    void say(const QString &sentence);

signals:
    /// Mean and range of what is selected; empty: nothing.
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
    void keyboardSearch(const QString &) override {} ///< digits are typed, they search nothing

private:
    void hover(const QModelIndex &index);
    void showHovered();
    void showCurrent();
    void showNext();
    void showReason();
    void take(const QModelIndex &index, const QString &text);
    void moveTo(const QModelIndex &index);
    /// Whether Tab, or Shift+Tab, leaves the table: nothing lies further on.
    [[nodiscard]] bool isAtEnd(bool forward);
    void placeFrozen();
    [[nodiscard]] int rowHeight() const;
    void setRowHeight();
    /// Of the widest text of the column with its margins; not below that of a usual column unless `tight`.
    [[nodiscard]] int widthOf(int column, bool tight) const;
    void shareWidth();

    ReadingsModel &m_model;
    ReadingsEditor &m_editor;
    Selection &m_selection;
    QTableView *m_frozen;
    QLabel *m_reason;                ///< why a text is no number, beside its cell
    std::vector<int> m_contents;     ///< widths of the texts of the columns, also of those that are hidden
    QPersistentModelIndex m_typed;   ///< the cell typed last
    QPersistentModelIndex m_refused; ///< a position typed since the last step that cannot be taken
    QString m_said;                  ///< of the current cell
    QModelIndex m_hovered;
    bool m_following = false; ///< the selection of the window is what moves the current cell
};

} // namespace palmer::ui
