// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/results/resultsmodel.h"

#include <algorithm>

namespace palmer::ui {

const std::vector<const ResultColumn *> &ResultsModel::columns() {
    static const std::vector<const ResultColumn *> listed = resultColumns(inWindow);
    return listed;
}

int ResultsModel::columnOf(std::string_view key) {
    return static_cast<int>(std::ranges::find(columns(), key, &ResultColumn::key) - columns().begin());
}

void ResultsModel::setTable(const ResultTable &table, const Language &language) {
    beginResetModel();
    m_table = table;
    m_language = language;
    endResetModel();
}

void ResultsModel::retranslate() {
    emit headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
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
        emit dataChanged(index(0, columnOf("name")), index(rowCount() - 1, columnOf("name")));
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
    return parent.isValid() ? 0 : static_cast<int>(columns().size());
}

QVariant ResultsModel::data(const QModelIndex &index, int role) const {
    if (!index.isValid())
        return {};
    const ResultLine &shown = line(index.row());
    const ResultColumn &own = column(index.column());
    const bool names = own.look == ResultLook::symbol || own.look == ResultLook::name;
    switch (role) {
    case Qt::ToolTipRole:
        return own.besideOnly ? shown.otherVerdictWord : names ? shown.fullName : QVariant();
    case Qt::TextAlignmentRole:
        return static_cast<int>((isNumber(index.column()) ? Qt::AlignRight : Qt::AlignLeft) |
                                Qt::AlignVCenter);
    case Qt::AccessibleTextRole:
        if (own.look != ResultLook::symbol)
            return {};
        return QStringLiteral("%1, %2: %3 %4 %5")
            .arg(shown.symbol.plain(), shown.fullName, shown.cell("value"), m_table.unit,
                 shown.cell("verdict"))
            .trimmed();
    case Qt::DisplayRole:
        return own.look == ResultLook::symbol ? shown.symbol.plain()
               : own.look == ResultLook::name ? nameOf(index.row(), m_names)
                                              : shown.cell(own);
    default:
        return {};
    }
}

QVariant ResultsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    const ResultColumn &own = column(section);
    const std::string_view key = own.key;
    if (key == "other" || (key == "value" && m_table.otherTest))
        return (key == "other") == m_table.otherIsFound ? tr("before") : tr("after");
    if (own.look == ResultLook::symbol || own.title.empty())
        return QString();
    QString title = m_language.text(own.title);
    if (title == QStringLiteral("U"))
        return QStringLiteral("± U");
    title[0] = title[0].toLower();
    return title;
}

Qt::ItemFlags ResultsModel::flags(const QModelIndex &index) const {
    return index.isValid() ? Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren
                           : Qt::ItemFlags(Qt::NoItemFlags);
}

} // namespace palmer::ui
