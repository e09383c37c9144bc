// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/forms/sheetmodel.h"

#include "language/decimals.h"
#include "ui/theme.h"
#include "ui/verdictmark.h"

#include <QFont>

namespace palmer::ui {

namespace {

bool isNumber(int column) {
    return column >= static_cast<int>(SheetColumn::permitted) &&
           column <= static_cast<int>(SheetColumn::uncertainty);
}

std::optional<Verdict> verdictOfRow(SheetState state) {
    return state <= SheetState::doesNotConform ? std::optional(static_cast<Verdict>(state)) : std::nullopt;
}

} // namespace

void SheetModel::show(const EvaluatedDocument &evaluated, const Language &language) {
    const int before = rowCount();
    m_language = language;
    const auto take = [&] {
        m_evaluated = evaluated;
        m_results = evaluated.document ? evaluated.sheet() : std::vector<SheetResult>();
        m_words.clear();
        m_pictures.clear();
        const Writer write(m_language);
        for (std::size_t i = 0; i < m_results.size(); ++i) {
            m_words.push_back(sheetWords(m_evaluated, {}, m_results[i], i, write));
            m_pictures.push_back(sheetPicture(m_results[i]));
        }
    };
    const int wanted = evaluated.document ? static_cast<int>(evaluated.document->report.sheet.size()) + 1 : 0;
    if (wanted == 0 || before == 0) {
        beginResetModel();
        take();
        endResetModel();
        return;
    }
    // No reset, which would close an open editor and take the keyboard from the table.
    if (wanted < before)
        beginRemoveRows({}, wanted, before - 1);
    else if (wanted > before)
        beginInsertRows({}, before, wanted - 1);
    take();
    if (wanted < before) {
        endRemoveRows();
    } else if (wanted > before) {
        endInsertRows();
    }
    emit dataChanged(index(0, 0), index(wanted - 1, columns - 1));
    emit headerDataChanged(Qt::Horizontal, 0, columns - 1);
}

int SheetModel::rowCount(const QModelIndex &parent) const {
    return parent.isValid() || !m_evaluated.document ? 0 : static_cast<int>(m_results.size()) + 1;
}

int SheetModel::columnCount(const QModelIndex &parent) const {
    return parent.isValid() ? 0 : columns;
}

/// A cell as it would be typed.
QString SheetModel::typed(const SheetRow &row, int column) const {
    const auto number = [&](std::optional<double> value) {
        return value ? m_language.number(certain(*value), Quantity::number) : QString();
    };
    switch (static_cast<SheetColumn>(column)) {
    case SheetColumn::number:
        return QString::fromStdString(row.number);
    case SheetColumn::object:
        return QString::fromStdString(row.object);
    case SheetColumn::permitted:
        return row.permitted.low
                   ? number(row.permitted.low) + QStringLiteral(" … ") + number(row.permitted.high)
                   : number(row.permitted.high);
    case SheetColumn::measured:
        return number(row.measured);
    case SheetColumn::uncertainty:
        return number(row.uncertainty);
    case SheetColumn::unit:
        return QString::fromStdString(row.unit);
    case SheetColumn::instrument:
        return QString::fromStdString(row.instrument);
    case SheetColumn::remark:
        return QString::fromStdString(row.remark);
    case SheetColumn::standard:
        return QString::fromStdString(row.standard);
    }
    return {};
}

QString SheetModel::shown(std::size_t row, int column) const {
    const SheetWords &words = m_words[row];
    switch (column) {
    case static_cast<int>(SheetColumn::permitted):
        return words.permitted;
    case static_cast<int>(SheetColumn::measured):
        return words.value;
    case static_cast<int>(SheetColumn::uncertainty):
        return words.uncertainty;
    case static_cast<int>(SheetColumn::unit):
        return words.unit;
    case verdict:
        return words.state;
    case source:
        return words.source;
    case picture:
        return {};
    default:
        return typed(m_evaluated.document->report.sheet[row], column);
    }
}

QVariant SheetModel::data(const QModelIndex &index, int role) const {
    if (!index.isValid())
        return {};
    const auto row = static_cast<std::size_t>(index.row());
    const int column = index.column();
    if (role == Qt::TextAlignmentRole)
        return static_cast<int>((isNumber(column) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    if (row >= m_results.size())
        return role == Qt::DisplayRole || role == Qt::EditRole ? QVariant(QString()) : QVariant();
    const SheetRow &said = m_evaluated.document->report.sheet[row];
    switch (role) {
    case Qt::DisplayRole:
        return shown(row, column);
    case Qt::EditRole:
        return column < sheetColumns ? typed(said, column) : shown(row, column);
    case Qt::ToolTipRole:
        return column == verdict && !said.notApplicable.empty() ? QString::fromStdString(said.notApplicable)
               : column == verdict && !m_words[row].reason.isEmpty() ? m_words[row].reason
                                                                     : shown(row, column);
    case Qt::ForegroundRole: {
        if (column != verdict)
            return {};
        const VerdictMark mark = verdictMark(verdictOfRow(m_results[row].state));
        const bool open = m_results[row].state == SheetState::notMeasured;
        return QVariant::fromValue(token(open ? Token::unsure : mark.colour, QPalette()));
    }
    case guardRole:
        return column == picture && m_pictures[row].extras->guard
                   ? QVariant::fromValue(*m_pictures[row].extras->guard)
                   : QVariant();
    case iconRole: {
        const QString icon = verdictMark(verdictOfRow(m_results[row].state)).icon;
        return column == verdict && !icon.isEmpty() ? QVariant(icon) : QVariant();
    }
    default:
        return {};
    }
}

QVariant SheetModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return static_cast<int>((isNumber(section) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case static_cast<int>(SheetColumn::number):
        return m_language.text(REPORT_TEXT_FOR("report", "No.", "number of a row"));
    case static_cast<int>(SheetColumn::object):
        return m_language.text(REPORT_TEXT_FOR("report", "Object", "of the acceptance sheet"));
    case static_cast<int>(SheetColumn::permitted):
        return m_language.text(REPORT_TEXT("report", "Tolerance"));
    case static_cast<int>(SheetColumn::measured):
        return m_language.text(REPORT_TEXT_FOR("report", "Measured", "value"));
    case static_cast<int>(SheetColumn::uncertainty):
        return QStringLiteral("± U");
    case static_cast<int>(SheetColumn::unit):
        return m_language.text(REPORT_TEXT("report", "Unit"));
    case static_cast<int>(SheetColumn::instrument):
        return m_language.text(REPORT_TEXT("report", "Instrument"));
    case static_cast<int>(SheetColumn::remark):
        return tr("Remark");
    case static_cast<int>(SheetColumn::standard):
        return tr("Standard");
    case picture:
        return m_language.text(REPORT_TEXT("report", "Limit ± U"));
    case verdict:
        return m_language.text(REPORT_TEXT("report", "Verdict"));
    default:
        return tr("Link");
    }
}

Qt::ItemFlags SheetModel::flags(const QModelIndex &index) const {
    if (!index.isValid())
        return Qt::NoItemFlags;
    const Qt::ItemFlags all = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren;
    return index.column() < sheetColumns ? all | Qt::ItemIsEditable : all;
}

bool SheetModel::setData(const QModelIndex &index, const QVariant &value, int role) {
    if (role != Qt::EditRole || !index.isValid() || index.column() >= sheetColumns)
        return false;
    if (value.toString() == data(index, Qt::EditRole).toString())
        return true;
    std::vector<SheetRow> rows = m_evaluated.document->report.sheet;
    const auto refused = typeIntoSheet(rows, static_cast<std::size_t>(index.row()),
                                       static_cast<SheetColumn>(index.column()), value.toString());
    emit refusedText(refused ? m_language.text(*refused) : QString());
    if (refused)
        return false;
    m_write(rows);
    return true;
}

} // namespace palmer::ui
