// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/imported.h"

#include <QAbstractListModel>
#include <QStyledItemDelegate>
#include <cstdint>
#include <optional>
#include <set>
#include <vector>

namespace palmer::ui {

/// A piece of a line and what it was read as.
struct RawPiece {
    QString text;
    CellRole role = CellRole::ignored;
};

/// Where the lines of a text begin, which has at most 1 GiB.
struct TextLines {
    std::vector<std::uint32_t> begins;
    int longest = 0; ///< bytes
};

/// Those of what was read; none of a workbook, which has rows. Of 10⁶ lines in some milliseconds.
[[nodiscard]] TextLines linesOf(const Imported &imported);

/// The lines of a measurement file as they were read: text of a table, rows of a sheet, lines of a text. The
/// pieces of a line are made when it is looked at, so that a million lines cost nothing.
class RawTextModel : public QAbstractListModel {
    Q_OBJECT

public:
    using QAbstractListModel::QAbstractListModel;

    /// What was read and its lines; both must stay alive and unchanged while they are shown.
    void show(const Imported &imported, const TextLines &lines);
    void clear();

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;

    [[nodiscard]] std::vector<RawPiece> pieces(int row) const;
    [[nodiscard]] std::size_t lineNumber(int row) const; ///< of the file, from 1
    [[nodiscard]] bool isProblem(int row) const;
    /// Which table of a text that has several a row belongs to, from 0; null: none, or there is but one.
    [[nodiscard]] std::optional<std::size_t> tableAt(int row) const;
    [[nodiscard]] bool isRead(std::size_t table) const { return table == m_imported->readTable; }
    /// The row that shows a line of the file; -1 for none.
    [[nodiscard]] int rowOf(std::size_t line) const;
    [[nodiscard]] int longestLine() const { return m_lines ? m_lines->longest : 0; } ///< bytes

private:
    struct Line {
        std::size_t begin = 0;
        std::size_t size = 0;
    };

    [[nodiscard]] Line line(int row) const;
    [[nodiscard]] const TableRow *tableRow(int row) const;

    const Imported *m_imported = nullptr;
    const TextLines *m_lines = nullptr;
    bool m_sheet = false; ///< rows of a workbook, which has no text of its own
    std::set<std::size_t> m_problems;
};

/// Draws a line with its number, the cells in the colours of what they were read as.
class RawTextDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override;
};

} // namespace palmer::ui
