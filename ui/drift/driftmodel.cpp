// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drift/driftmodel.h"

#include "language/decimals.h"
#include "language/entry.h"
#include "ui/quiettable.h"

#include <algorithm>

namespace palmer::ui {

namespace {

/// Decimals of the reading with the most, up to a limit.
int commonDecimals(const std::vector<double> &values, Quantity quantity) {
    constexpr int most = 4;
    constexpr std::size_t lookedAt = 2000;
    int decimals = 0;
    for (std::size_t i = 0; i < std::min(values.size(), lookedAt); ++i)
        decimals = std::max(decimals, decimalsOf(values[i], quantity));
    return std::min(decimals, most);
}

} // namespace

void DriftModel::show(const EvaluatedDocument &evaluated, std::size_t test, const Language &language) {
    const auto *measurement = measured<DriftMeasurement>(evaluated, test);
    const std::string id = measurement ? evaluated.document->tests[test]->id : std::string();
    const auto columnsOf = [](const DriftMeasurement &m) {
        return m.channels.size() + m.temperatures.size();
    };
    const bool same = measurement && m_measurement && id == m_id &&
                      measurement->channels.empty() == m_measurement->channels.empty() &&
                      columnsOf(*measurement) == columnsOf(*m_measurement);
    if (same)
        dropRefused(measurement);
    const std::shared_ptr<const Document> former = m_document; // keeps alive what was shown until now
    const int rows = m_rows;
    const int wanted =
        measurement ? static_cast<int>(measurement->times.size()) + (measurement->channels.empty() ? 1 : 0)
                    : 0;
    if (!same) {
        beginResetModel();
    } else if (wanted < rows) {
        beginRemoveRows({}, wanted, rows - 1);
        m_rows = wanted;
        endRemoveRows();
    }
    m_document = evaluated.document;
    m_measurement = measurement;
    m_id = id;
    m_language = language;
    if (!same) {
        m_rows = wanted;
        endResetModel();
        return;
    }
    // No reset, which would close an open editor.
    emit headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
    emit dataChanged(index(0, 0), index(m_rows - 1, columnCount() - 1));
    if (wanted > rows) {
        beginInsertRows({}, rows, wanted - 1);
        m_rows = wanted;
        endInsertRows();
    }
}

/// Drops refused texts whose reading has changed; those of the new reading stay.
void DriftModel::dropRefused(const DriftMeasurement *now) {
    m_refused.removeIf(m_id, [&](const RefusedTexts::Cell &cell) {
        const auto number = [&cell](const DriftMeasurement &measurement) -> std::optional<double> {
            const auto &numbers = cell.column == time ? measurement.times : measurement.deviations;
            return cell.row < numbers.size() ? std::optional(numbers[cell.row]) : std::nullopt;
        };
        return number(*now) != number(*m_measurement);
    });
}

const RefusedTexts::Refused *DriftModel::refused(const QModelIndex &index) const {
    return m_refused.find(m_id,
                          {static_cast<std::size_t>(index.row()), static_cast<std::size_t>(index.column())});
}

QStringList DriftModel::unfinishedTexts() const {
    QStringList all = m_refused.texts();
    for (const auto &[id, beginning] : m_beginnings) {
        for (const QString &text : beginning.texts) {
            if (!text.isEmpty())
                all << text;
        }
    }
    return all;
}

std::size_t DriftModel::readings() const {
    return m_measurement ? m_measurement->times.size() : 0;
}

Quantity DriftModel::quantity(int column) const {
    if (column == time || isTyped())
        return column == time ? Quantity::time : deviationQuantity(m_measurement->axis);
    const auto at = static_cast<std::size_t>(column) - 1;
    if (at >= m_measurement->channels.size())
        return Quantity::temperature;
    return m_measurement->channels[at].quantity == ChannelQuantity::deviation ? Quantity::deviation
                                                                              : Quantity::angularDeviation;
}

const std::vector<std::optional<double>> &DriftModel::series(int column) const {
    const auto at = static_cast<std::size_t>(column) - 1;
    const std::size_t channels = m_measurement->channels.size();
    return at < channels ? m_measurement->channels[at].values
                         : m_measurement->temperatures[at - channels].values;
}

int DriftModel::rowCount(const QModelIndex &parent) const {
    return parent.isValid() ? 0 : m_rows;
}

int DriftModel::columnCount(const QModelIndex &parent) const {
    if (parent.isValid() || !m_measurement || isTyped())
        return parent.isValid() ? 0 : static_cast<int>(columns);
    return 1 + static_cast<int>(m_measurement->channels.size() + m_measurement->temperatures.size());
}

std::optional<double> DriftModel::value(const QModelIndex &index) const {
    const auto row = static_cast<std::size_t>(index.row());
    if (row >= readings()) {
        const auto found = m_beginnings.find(m_id);
        return found == m_beginnings.end()
                   ? std::nullopt
                   : found->second.numbers.at(static_cast<std::size_t>(index.column()));
    }
    if (index.column() == time)
        return m_measurement->times[row];
    return isTyped() ? std::optional(m_measurement->deviations[row]) : series(index.column())[row];
}

QVariant DriftModel::data(const QModelIndex &index, int role) const {
    if (!index.isValid() || !m_measurement)
        return {};
    if (role == Qt::TextAlignmentRole)
        return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
    const RefusedTexts::Refused *text = refused(index);
    if (role == QuietDelegate::refusedRole)
        return text != nullptr;
    if (role == Qt::ToolTipRole || role == Qt::AccessibleDescriptionRole)
        return text ? QVariant(text->reason) : QVariant();
    if (role != Qt::DisplayRole && role != Qt::EditRole)
        return {};
    if (text)
        return text->text;
    const auto shown = value(index);
    if (!shown)
        return QString();
    const Quantity of = quantity(index.column());
    if (index.column() != time && !isTyped())
        return m_language.number(*shown, of, 2);
    const auto &all = index.column() == time ? m_measurement->times : m_measurement->deviations;
    const bool isBegun = static_cast<std::size_t>(index.row()) >= readings(); // shown as it was typed
    return m_language.number(*shown, of, role == Qt::EditRole || isBegun ? -1 : commonDecimals(all, of));
}

QVariant DriftModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || !m_measurement)
        return {};
    if (role == Qt::TextAlignmentRole)
        return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    const QString unit = m_language.unit(quantity(section));
    if (section == time || isTyped())
        return section == time ? tr("time %1").arg(unit) : tr("deviation %1").arg(unit);
    const auto at = static_cast<std::size_t>(section) - 1;
    const std::size_t channels = m_measurement->channels.size();
    const std::string &name = at < channels ? m_measurement->channels[at].name
                                            : m_measurement->temperatures[at - channels].measures;
    return QString::fromStdString(name) + u' ' + unit;
}

Qt::ItemFlags DriftModel::flags(const QModelIndex &index) const {
    if (index.isValid() && !isTyped())
        return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren;
    return index.isValid()
               ? Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable | Qt::ItemNeverHasChildren
               : Qt::ItemFlags(Qt::NoItemFlags);
}

bool DriftModel::undoRefused() {
    const QModelIndex cell = m_lastRefused;
    if (!cell.isValid() || !refused(cell))
        return false;
    keepRefused();
    m_refused.remove(m_id, {static_cast<std::size_t>(cell.row()), static_cast<std::size_t>(cell.column())});
    emit dataChanged(cell, cell);
    emit refusedText({});
    return true;
}

bool DriftModel::setData(const QModelIndex &index, const QVariant &value, int role) {
    if (role != Qt::EditRole || !index.isValid() || !isTyped())
        return false;
    const QString typed = value.toString();
    if (typed == data(index, Qt::EditRole).toString())
        return true;
    const auto row = static_cast<std::size_t>(index.row());
    const auto column = static_cast<std::size_t>(index.column());
    const NumberEntry entry = enteredNumber(typed, quantity(index.column()), m_language.units());
    if (entry.refusal) {
        m_refused.put(m_id, {row, column}, typed, m_language.text(*entry.refusal));
        m_lastRefused = index;
        emit dataChanged(index, index);
        emit refusedText(m_language.text(*entry.refusal));
        return false;
    }
    m_refused.remove(m_id, {row, column});
    emit dataChanged(index, index);
    emit refusedText({});
    if (row >= readings()) {
        NewReading &beginning = m_beginnings[m_id];
        beginning.numbers.at(column) = entry.value;
        beginning.texts.at(column) = typed.trimmed();
        const auto [newTime, newDeviation] = beginning.numbers;
        if (newTime && newDeviation) {
            m_beginnings.erase(m_id);
            m_write(row, {{*newTime, *newDeviation}});
        }
        return true;
    }
    if (!entry.value) {
        emit refusedText(tr("a reading has both numbers; remove the row instead"));
        return false;
    }
    DriftReading reading{m_measurement->times[row], m_measurement->deviations[row]};
    (index.column() == time ? reading.time : reading.deviation) = *entry.value;
    m_write(row, {reading});
    return true;
}

} // namespace palmer::ui
