// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QHeaderView>
#include <QStyledItemDelegate>
#include <QTableView>
#include <algorithm>
#include <functional>
#include <vector>

namespace palmer::ui {

/// A plain header: small words over their columns, aligned and coloured by the model, with a rule below.
class QuietHeader : public QHeaderView {
    Q_OBJECT

public:
    explicit QuietHeader(QWidget *parent = nullptr);

protected:
    void paintEvent(QPaintEvent *event) override;
};

/// Gives a table a QuietHeader and no grid, row numbers or cells reached with Tab.
void makeQuiet(QTableView &table, int rowHeight, int headHeight);

/// A column of a RowModel; without data(), the model overrides cell().
template <typename Row>
struct RowColumn {
    QString title = {};
    Qt::Alignment side = {}; ///< of header and cells; none: the view decides
    std::function<QVariant(const Row &row, int role)> data = {};
    QString toolTip = {}; ///< of the header
};

/// Rows of a plain struct as a table, or as a list if no columns are given.
template <typename Row>
class RowModel : public QAbstractTableModel {
public:
    using QAbstractTableModel::QAbstractTableModel;

    [[nodiscard]] const Row &row(int at) const { return m_rows[static_cast<std::size_t>(at)]; }

    [[nodiscard]] QModelIndex index(int row, int column = 0, const QModelIndex &parent = {}) const override {
        return QAbstractTableModel::index(row, column, parent);
    }
    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override {
        return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
    }
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override {
        return parent.isValid() ? 0 : std::max(1, static_cast<int>(m_columns.size()));
    }
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const final {
        if (!checkIndex(index, CheckIndexOption::IndexIsValid))
            return {};
        if (role == Qt::TextAlignmentRole)
            return sideOf(index.column());
        return cell(row(index.row()), index.column(), role);
    }
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override {
        if (orientation != Qt::Horizontal || section < 0 || section >= static_cast<int>(m_columns.size()))
            return {};
        const RowColumn<Row> &column = m_columns[static_cast<std::size_t>(section)];
        if (role == Qt::TextAlignmentRole)
            return sideOf(section);
        return role == Qt::DisplayRole                                ? column.title
               : role == Qt::ToolTipRole && !column.toolTip.isEmpty() ? column.toolTip
                                                                      : QVariant();
    }

protected:
    [[nodiscard]] virtual QVariant cell(const Row &row, int column, int role) const {
        return m_columns[static_cast<std::size_t>(column)].data(row, role);
    }
    void reset(std::vector<Row> rows) {
        beginResetModel();
        m_rows = std::move(rows);
        endResetModel();
    }

    std::vector<Row> m_rows;
    std::vector<RowColumn<Row>> m_columns;

private:
    [[nodiscard]] QVariant sideOf(int column) const {
        const auto at = static_cast<std::size_t>(column);
        return at < m_columns.size() && m_columns[at].side
                   ? QVariant(static_cast<int>(m_columns[at].side | Qt::AlignVCenter))
                   : QVariant();
    }
};

/// A row of a list or a cell of a table: background, rule, focus. A subclass draws the content.
class RowDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    enum Part { rule = 1, selectedBar = 2, focusFrame = 4 }; ///< drawn on the background, below the content

    explicit RowDelegate(QObject *parent, int parts = 0)
        : QStyledItemDelegate(parent)
        , m_parts(parts) {}

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;

protected:
    /// Colour of the background; invalid if there is none. By default selected rows and the one under the
    /// pointer have one.
    [[nodiscard]] virtual QColor ground(const QStyleOptionViewItem &option, const QModelIndex &index) const;
    /// The painter is restored afterwards.
    virtual void paintContent(QPainter &painter, const QStyleOptionViewItem &option,
                              const QModelIndex &index) const = 0;
    /// True if the row is current in a focused view: with the keyboard, a row becomes current before it is
    /// selected.
    [[nodiscard]] static bool isCurrentRow(const QStyleOptionViewItem &option, const QModelIndex &index);

private:
    int m_parts;
};

/// A cell of a quiet table: its text, a light rule below, and a background if current, under the pointer or
/// refused. Typing continues when other data arrive.
class QuietDelegate : public RowDelegate {
    Q_OBJECT

public:
    explicit QuietDelegate(QObject *parent)
        : RowDelegate(parent, rule) {}

    enum Role { refusedRole = Qt::UserRole + 20 }; ///< bool: the text was typed and refused

    void setEditorData(QWidget *editor, const QModelIndex &index) const override;

    /// The cell pointed at, here or in a figure.
    void setHovered(const QModelIndex &index) { m_hovered = index; }

protected:
    [[nodiscard]] QColor ground(const QStyleOptionViewItem &option, const QModelIndex &index) const override;
    void paintContent(QPainter &painter, const QStyleOptionViewItem &option,
                      const QModelIndex &index) const override;

private:
    QPersistentModelIndex m_hovered;
};

} // namespace palmer::ui
