// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/results/resultsmodel.h"

#include <QFontMetrics>
#include <algorithm>

namespace palmer::ui {

namespace {

/// ",25" of "1,25".
QString fractionOf(const QString &number) {
    const auto mark = std::ranges::find_if(number, [](QChar c) { return c == u'.' || c == u','; });
    return number.mid(mark - number.begin());
}

} // namespace

const std::vector<const ResultColumn *> &ResultsModel::columns() {
    static const std::vector<const ResultColumn *> listed = resultColumns(inWindow);
    return listed;
}

int ResultsModel::columnOf(std::string_view key) {
    return static_cast<int>(std::ranges::find(columns(), key, &ResultColumn::key) - columns().begin());
}

ResultsModel::ResultsModel(QObject *parent)
    : RowModel(parent) {
    for (const ResultColumn *own : columns())
        m_columns.push_back({{}, own->look == ResultLook::number ? Qt::AlignRight : Qt::AlignLeft});
}

void ResultsModel::setTable(const ResultTable &table, const Language &language) {
    m_table = table;
    m_language = language;
    m_fractions.assign(columns().size(), {});
    for (std::size_t k = 0; k < m_fractions.size(); ++k) {
        for (const ResultLine &line : table.lines) {
            const QString fraction = fractionOf(line.cell(*columns()[k]));
            if (isNumber(static_cast<int>(k)) && fraction.size() > m_fractions[k].size())
                m_fractions[k] = fraction;
        }
    }
    reset(table.lines);
}

void ResultsModel::retranslate() {
    emit headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
}

QString ResultsModel::nameOf(const ResultLine &line, Names names) {
    return names == Names::full ? line.fullName : names == Names::brief ? line.name : line.narrowName;
}

void ResultsModel::setNames(Names names) {
    if (m_names == names)
        return;
    m_names = names;
    if (rowCount() > 0)
        emit dataChanged(index(0, columnOf("name")), index(rowCount() - 1, columnOf("name")));
}

int ResultsModel::roomAfter(const QString &number, int place, const QFontMetrics &metrics) const {
    const bool hasDigits = std::ranges::any_of(number, [](QChar c) { return c.isDigit(); });
    return hasDigits ? metrics.horizontalAdvance(m_fractions[static_cast<std::size_t>(place)]) -
                           metrics.horizontalAdvance(fractionOf(number))
                     : 0;
}

int ResultsModel::rowOf(const QString &id) const {
    const auto found = std::ranges::find(m_rows, id, &ResultLine::id);
    return found == m_rows.end() ? -1 : static_cast<int>(found - m_rows.begin());
}

QVariant ResultsModel::cell(const ResultLine &line, int place, int role) const {
    const ResultColumn &own = column(place);
    const bool names = own.look == ResultLook::symbol || own.look == ResultLook::name;
    switch (role) {
    case Qt::ToolTipRole:
        return own.besideOnly                           ? line.otherVerdictWord
               : names                                  ? line.fullName
               : own.key == std::string_view("verdict") ? line.reason
                                                        : QVariant();
    case Qt::AccessibleTextRole:
        if (own.look != ResultLook::symbol)
            return {};
        return QStringLiteral("%1, %2: %3 %4 %5")
            .arg(line.symbol.plain(), line.fullName, line.cell("value"), m_table.unit, line.cell("verdict"))
            .trimmed();
    case Qt::DisplayRole:
        return own.look == ResultLook::symbol ? line.symbol.plain()
               : own.look == ResultLook::name ? nameOf(line, m_names)
                                              : line.cell(own);
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

} // namespace palmer::ui
