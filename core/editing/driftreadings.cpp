// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editing/driftreadings.h"

#include "language/entry.h"

#include <QRegularExpression>
#include <QString>
#include <QStringList>
#include <algorithm>
#include <utility>

namespace palmer {

void setDriftReadings(Test &test, std::size_t row, const std::vector<DriftReading> &readings) {
    auto *drift = std::get_if<DriftMeasurement>(&test.measurement);
    if (!drift)
        return;
    row = std::min(row, drift->times.size());
    const std::size_t end = std::max(drift->times.size(), row + readings.size());
    drift->times.resize(end);
    drift->deviations.resize(end);
    for (const DriftReading &reading : readings) {
        drift->times[row] = reading.time;
        drift->deviations[row++] = reading.deviation;
    }
}

void removeDriftReadings(Test &test, std::size_t row, std::size_t count) {
    auto *drift = std::get_if<DriftMeasurement>(&test.measurement);
    if (!drift || row >= drift->times.size())
        return;
    count = std::min(count, drift->times.size() - row);
    const auto cut = [&](std::vector<double> &values) {
        const auto first = values.begin() + static_cast<std::ptrdiff_t>(row);
        values.erase(first, first + static_cast<std::ptrdiff_t>(count));
    };
    cut(drift->times);
    cut(drift->deviations);
}

std::optional<std::vector<DriftReading>> driftReadingsFrom(QStringView pasted, Motion motion,
                                                           const DisplayUnits &units) {
    static const QRegularExpression between(QStringLiteral("[\\t;]+| +"));
    const Quantity deviation = motion == Motion::linear ? Quantity::deviation : Quantity::angularDeviation;
    std::vector<DriftReading> readings;
    bool first = true;
    for (const QStringView line : pasted.split(u'\n', Qt::SkipEmptyParts)) {
        const QStringList cells = line.trimmed().toString().split(between, Qt::SkipEmptyParts);
        if (cells.isEmpty())
            continue;
        const bool head = std::exchange(first, false);
        std::optional<double> time;
        std::optional<double> value;
        if (cells.size() == 2) {
            time = enteredNumber(cells[0], Quantity::time, units).value;
            value = enteredNumber(cells[1], deviation, units).value;
        }
        if (time && value)
            readings.push_back({*time, *value});
        else if (!head || time || value)
            return std::nullopt;
    }
    if (readings.empty())
        return std::nullopt;
    return readings;
}

} // namespace palmer
