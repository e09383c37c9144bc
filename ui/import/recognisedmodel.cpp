// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/recognisedmodel.h"

#include "kernel/measurement/testfacts.h"
#include "language/decimals.h"
#include "ui/windowlanguage.h"

#include <algorithm>

namespace palmer::ui {

namespace {

constexpr int mostDecimals = 4;
constexpr std::size_t looked = 20'000; ///< numbers whose decimals are counted

} // namespace

std::size_t RecognisedModel::Column::size() const {
    return values.size() + readings.size() + own.size(); // two of them are empty
}

std::optional<double> RecognisedModel::Column::value(std::size_t row) const {
    return !values.empty() ? values[row] : !readings.empty() ? readings[row] : own[row];
}

void RecognisedModel::show(const Imported *imported) {
    beginResetModel();
    m_columns.clear();
    m_rows = 0;
    if (imported && imported->test) {
        std::visit([this](const auto &measurement) { add(measurement); }, imported->test->measurement);
    } else if (imported) {
        for (const Sensor &sensor : imported->sensors)
            addSensor(sensor);
    }
    countDecimals();
    endResetModel();
}

/// Counts decimals; in large tables only of a sample spread over all numbers.
void RecognisedModel::countDecimals() {
    std::size_t numbers = 0;
    for (const Column &column : m_columns) {
        m_rows = std::max(m_rows, column.size());
        numbers += column.size();
    }
    const std::size_t step = numbers / looked + 1;
    for (Column &column : m_columns) {
        for (std::size_t row = 0; row < column.size(); row += step) {
            const auto value = column.value(row);
            if (value && column.decimals < mostDecimals)
                column.decimals =
                    std::max(column.decimals, std::min(decimalsOf(*value, column.quantity), mostDecimals));
        }
    }
}

void RecognisedModel::add(const PositioningMeasurement &measurement) {
    const Quantity position = positionQuantity(measurement.axis);
    const Quantity deviation = deviationQuantity(measurement.axis);
    m_columns.push_back(
        {QStringLiteral("P %1").arg(windowLanguage().unit(position)), position, {}, measurement.targets});
    int up = 0;
    int down = 0;
    for (const Run &run : measurement.runs) {
        const bool positive = run.approach == Direction::positive;
        m_columns.push_back({QStringLiteral("%1 %2")
                                 .arg(positive ? ++up : ++down)
                                 .arg(positive ? QStringLiteral("↑") : QStringLiteral("↓")),
                             deviation,
                             positive ? Token::up : Token::downText,
                             {},
                             run.deviations});
    }
}

void RecognisedModel::add(const CircularMeasurement &measurement) {
    for (const Arc &arc : measurement.arcs) {
        const bool first = arc.sense == Sense::counterclockwise;
        const QString sense = first ? QStringLiteral("↺") : QStringLiteral("↻");
        m_columns.push_back({QStringLiteral("%1 °").arg(sense), Quantity::angle, {}, arc.angles});
        m_columns.push_back({QStringLiteral("%1 %2").arg(sense, windowLanguage().unit(Quantity::deviation)),
                             Quantity::deviation, first ? Token::up : Token::downText, arc.radialDeviations});
    }
}

void RecognisedModel::add(const DriftMeasurement &measurement) {
    const Quantity deviation = deviationQuantity(measurement.axis);
    m_columns.push_back({QStringLiteral("t s"), Quantity::time, {}, measurement.times});
    m_columns.push_back({windowLanguage().unit(deviation), deviation, {}, measurement.deviations});
}

void RecognisedModel::addSensor(const Sensor &sensor) {
    const QString name =
        sensor.position.empty() ? QStringLiteral("°C") : QString::fromStdString(sensor.position);
    if (sensor.series) {
        // Sensors of one table share their times.
        const std::span<const double> times = sensor.series->times;
        const bool same = std::ranges::any_of(m_columns, [&](const Column &known) {
            return known.quantity == Quantity::time && std::ranges::equal(known.values, times);
        });
        if (!same)
            m_columns.push_back({QStringLiteral("t s"), Quantity::time, {}, times});
        m_columns.push_back({name, Quantity::temperature, {}, sensor.series->temperatures});
    } else {
        m_columns.push_back({name, Quantity::temperature, {}, {}, {}, {sensor.start, sensor.end}});
    }
}

int RecognisedModel::rowCount(const QModelIndex &parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows);
}

int RecognisedModel::columnCount(const QModelIndex &parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_columns.size());
}

QVariant RecognisedModel::data(const QModelIndex &index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const Column &column = m_columns[static_cast<std::size_t>(index.column())];
    const auto row = static_cast<std::size_t>(index.row());
    if (role == Qt::TextAlignmentRole)
        return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::DisplayRole && row < column.size()) {
        const std::optional<double> value = column.value(row);
        return value ? windowLanguage().number(*value, column.quantity, column.decimals)
                     : QStringLiteral("–");
    }
    return {};
}

QVariant RecognisedModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation == Qt::Vertical)
        return role == Qt::DisplayRole ? QVariant(section + 1) : QVariant();
    if (section < 0 || section >= columnCount())
        return {};
    const Column &column = m_columns[static_cast<std::size_t>(section)];
    if (role == Qt::DisplayRole)
        return column.head;
    if (role == Qt::TextAlignmentRole)
        return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::ForegroundRole && column.colour)
        return token(*column.colour, QPalette());
    return {};
}

int readingsOf(const Imported &imported) {
    if (imported.test)
        return static_cast<int>(readingsOf(*imported.test)) - missingOf(imported);
    std::size_t count = 0;
    for (const Sensor &sensor : imported.sensors)
        count += sensor.series ? sensor.series->temperatures.size()
                               : std::size_t(sensor.start.has_value()) + sensor.end.has_value();
    return static_cast<int>(count);
}

int missingOf(const Imported &imported) {
    std::ptrdiff_t missing = 0;
    const auto count = [&](const auto &measurement) {
        if constexpr (requires { measurement.runs; }) {
            for (const Run &run : measurement.runs)
                missing += std::ranges::count_if(run.deviations, [](const auto &value) { return !value; });
        }
    };
    if (imported.test)
        std::visit(count, imported.test->measurement);
    return static_cast<int>(missing);
}

} // namespace palmer::ui
