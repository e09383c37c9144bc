#include "ui/drift/driftmodel.h"

#include "language/decimals.h"
#include "language/entry.h"

#include <algorithm>

namespace palmer::ui {

namespace {

/// As many digits as the reading with the most, within reason.
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
    beginResetModel();
    m_document = evaluated.document;
    m_measurement = test < evaluated.tests.size()
                        ? std::get_if<DriftMeasurement>(&m_document->tests[test]->measurement)
                        : nullptr;
    m_language = language;
    m_newTime.reset();
    m_newDeviation.reset();
    endResetModel();
}

std::size_t DriftModel::readings() const {
    return m_measurement ? m_measurement->times.size() : 0;
}

Quantity DriftModel::quantity(int column) const {
    return column == time ? Quantity::time : deviationQuantity(m_measurement->axis);
}

int DriftModel::rowCount(const QModelIndex &parent) const {
    return parent.isValid() || !m_measurement ? 0 : static_cast<int>(readings()) + 1;
}

int DriftModel::columnCount(const QModelIndex &parent) const {
    return parent.isValid() ? 0 : static_cast<int>(columns);
}

std::optional<double> DriftModel::value(const QModelIndex &index) const {
    const auto row = static_cast<std::size_t>(index.row());
    if (row >= readings())
        return index.column() == time ? m_newTime : m_newDeviation;
    return index.column() == time ? m_measurement->times[row] : m_measurement->deviations[row];
}

QVariant DriftModel::data(const QModelIndex &index, int role) const {
    if (!index.isValid() || !m_measurement)
        return {};
    if (role == Qt::TextAlignmentRole)
        return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole && role != Qt::EditRole)
        return {};
    const auto shown = value(index);
    if (!shown)
        return QString();
    const Quantity of = quantity(index.column());
    const auto &all = index.column() == time ? m_measurement->times : m_measurement->deviations;
    return m_language.number(*shown, of, role == Qt::EditRole ? -1 : commonDecimals(all, of));
}

QVariant DriftModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || !m_measurement)
        return {};
    if (role == Qt::TextAlignmentRole)
        return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    const QString unit = m_language.unit(quantity(section));
    return section == time ? tr("time %1").arg(unit) : tr("deviation %1").arg(unit);
}

Qt::ItemFlags DriftModel::flags(const QModelIndex &index) const {
    return index.isValid()
               ? Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable | Qt::ItemNeverHasChildren
               : Qt::ItemFlags(Qt::NoItemFlags);
}

bool DriftModel::setData(const QModelIndex &index, const QVariant &value, int role) {
    if (role != Qt::EditRole || !index.isValid() || !m_measurement)
        return false;
    const NumberEntry entry = enteredNumber(value.toString(), quantity(index.column()), m_language.units());
    if (entry.refusal) {
        emit refused(m_language.text(*entry.refusal));
        return false;
    }
    const auto row = static_cast<std::size_t>(index.row());
    if (row >= readings()) {
        (index.column() == time ? m_newTime : m_newDeviation) = entry.value;
        emit dataChanged(index, index);
        if (m_newTime && m_newDeviation)
            m_write(row, {{*m_newTime, *m_newDeviation}});
        return true;
    }
    if (!entry.value) {
        emit refused(tr("a reading has both numbers; remove the row instead"));
        return false;
    }
    DriftReading reading{m_measurement->times[row], m_measurement->deviations[row]};
    (index.column() == time ? reading.time : reading.deviation) = *entry.value;
    m_write(row, {reading});
    return true;
}

} // namespace palmer::ui
