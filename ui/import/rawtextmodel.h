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

/// A piece of a line and its role.
struct RawPiece {
    QString text;
    CellRole role = CellRole::ignored;
};

/// Start offsets of the lines of a text of at most 1 GiB.
struct TextLines {
    std::vector<std::uint32_t> begins;
    int longest = 0; ///< bytes
};

/// The lines of the text as read; empty for a workbook, which has rows. Takes milliseconds for 10⁶ lines.
[[nodiscard]] TextLines linesOf(const Imported &imported);

/// The lines of a measurement file as read: table text, sheet rows or text lines. The pieces of a line are
/// made on request, so that a million lines cost nothing.
class RawTextModel : public QAbstractListModel {
    Q_OBJECT

public:
    using QAbstractListModel::QAbstractListModel;

    /// The data as read and their lines; both must stay alive and unchanged while shown.
    void show(const Imported &imported, const TextLines &lines);
    void clear();

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;

    [[nodiscard]] std::vector<RawPiece> pieces(int row) const;
    [[nodiscard]] std::size_t lineNumber(int row) const; ///< in the file, from 1
    [[nodiscard]] bool isProblem(int row) const;
    /// Index from 0 of the row's table; null if it is in none, or the text has only one.
    [[nodiscard]] std::optional<std::size_t> tableAt(int row) const;
    [[nodiscard]] bool isRead(std::size_t table) const { return table == m_imported->readTable; }
    /// The row of a line of the file; -1 if there is none.
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
    bool m_sheet = false; ///< a workbook: rows instead of text
    std::set<std::size_t> m_problems;
};

/// Draws a line with its number, each cell in the colour of its role.
class RawTextDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override;
};

} // namespace palmer::ui
