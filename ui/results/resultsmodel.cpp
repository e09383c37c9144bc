// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/results/resultsmodel.h"

namespace palmer::ui {

void ResultsModel::setTable(const ResultTable &table) {
    beginResetModel();
    m_table = table;
    endResetModel();
}

void ResultsModel::retranslate() {
    emit headerDataChanged(Qt::Horizontal, 0, columns - 1);
}

QString ResultsModel::nameOf(int row, Names names) const {
    const ResultLine &shown = line(row);
    return names == Names::full ? shown.fullName : names == Names::brief ? shown.name : shown.narrowName;
}

void ResultsModel::setNames(Names names) {
    if (m_names == names)
        return;
    m_names = names;
    if (rowCount() > 0)
        emit dataChanged(index(0, name), index(rowCount() - 1, name));
}

int ResultsModel::rowOf(const QString &id) const {
    for (std::size_t row = 0; row < m_table.lines.size(); ++row) {
        if (m_table.lines[row].id == id)
            return static_cast<int>(row);
    }
    return -1;
}

int ResultsModel::rowCount(const QModelIndex &parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_table.lines.size());
}

int ResultsModel::columnCount(const QModelIndex &parent) const {
    return parent.isValid() ? 0 : static_cast<int>(columns);
}

QVariant ResultsModel::data(const QModelIndex &index, int role) const {
    if (!index.isValid())
        return {};
    const ResultLine &shown = line(index.row());
    if (role == Qt::ToolTipRole && (index.column() == other || index.column() == otherUncertainty))
        return shown.otherVerdictWord;
    if (role == Qt::ToolTipRole)
        return index.column() == name || index.column() == symbol ? QVariant(shown.fullName) : QVariant();
    if (role == Qt::TextAlignmentRole)
        return static_cast<int>((isNumber(index.column()) ? Qt::AlignRight : Qt::AlignLeft) |
                                Qt::AlignVCenter);
    if (role == Qt::AccessibleTextRole && index.column() == symbol)
        return QStringLiteral("%1, %2: %3 %4 %5")
            .arg(shown.symbol.plain(), shown.fullName, shown.value, m_table.unit, shown.verdictWord)
            .trimmed();
    if (role != Qt::DisplayRole)
        return {};
    switch (index.column()) {
    case symbol:
        return shown.symbol.plain();
    case name:
        return nameOf(index.row(), m_names);
    case other:
        return shown.other;
    case otherUncertainty:
        return shown.otherUncertainty;
    case value:
        return shown.value;
    case uncertainty:
        return shown.uncertainty;
    case change:
        return shown.change;
    case limit:
        return shown.limit;
    case verdict:
        return shown.verdictWord;
    default:
        return {};
    }
}

bool ResultsModel::isNumber(int column) {
    return column >= other && column <= limit;
}

QVariant ResultsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case name:
        return tr("quantity");
    case other:
        return m_table.otherIsFound ? tr("before") : tr("after");
    case value:
        return !m_table.otherTest ? tr("value") : m_table.otherIsFound ? tr("after") : tr("before");
    case change:
        return tr("change");
    case otherUncertainty:
    case uncertainty:
        return QStringLiteral("± U");
    case limit:
        return tr("limit");
    case verdict:
        return tr("verdict");
    default:
        return QString();
    }
}

Qt::ItemFlags ResultsModel::flags(const QModelIndex &index) const {
    return index.isValid() ? Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren
                           : Qt::ItemFlags(Qt::NoItemFlags);
}

} // namespace palmer::ui
