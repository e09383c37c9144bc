// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editing/driftreadings.h"

#include "editing/typedreading.h"

#include <QRegularExpression>
#include <QString>
#include <QStringList>
#include <algorithm>

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

namespace {

QStringList cellsOfDrift(const QString &line) {
    static const QRegularExpression tabs(QStringLiteral("[\\t;]+"));
    static const QRegularExpression blanks(QStringLiteral(" +"));
    return line.split(line.contains(tabs) ? tabs : blanks, Qt::SkipEmptyParts);
}

/// What a cell of the head says; "t min" and "t/s" are units of time without brackets, too.
SaidUnit saidIn(const QString &cell) {
    static const QRegularExpression last(QStringLiteral("[^\\s/]+$"));
    if (const SaidUnit said = saidUnit(cell.toStdString()); said.isSaid())
        return said;
    const SaidUnit word = saidUnit('(' + last.match(cell.trimmed()).captured().toStdString() + ')');
    return word.unit && word.unit->kind == UnitKind::time ? word : SaidUnit{};
}

/// The units that the lines of the head say; null: those shown.
struct DriftHead {
    const Unit *time = nullptr;
    const Unit *deviation = nullptr;
    bool deviationFirst = false;

    void read(const QStringList &cells, Motion motion) {
        for (const QString &cell : cells) {
            const SaidUnit said = saidIn(cell);
            if (!said.isSaid())
                continue;
            const bool isTime = said.unit && said.unit->kind == UnitKind::time;
            (isTime ? time : deviation) = isTime ? said.unit : &unitOfHeading(said, unitKindOf(motion));
            deviationFirst = cells.size() == 2 && isTime != (&cell == &cells.first());
        }
    }
};

std::optional<double> driftNumber(const Unit *unit, const QString &cell, Quantity shown,
                                  const DisplayUnits &units) {
    const auto number = enteredNumber(cell, unit ? Quantity::number : shown, units).value;
    return unit && number ? unit->toBase(*number) : number;
}

} // namespace

std::optional<std::vector<DriftReading>> driftReadingsFrom(QStringView pasted, Motion motion,
                                                           const DisplayUnits &units) {
    const Quantity shown = motion == Motion::linear ? Quantity::deviation : Quantity::angularDeviation;
    std::vector<DriftReading> readings;
    DriftHead head;
    for (const QStringView line : pasted.split(u'\n', Qt::SkipEmptyParts)) {
        QStringList cells = cellsOfDrift(line.trimmed().toString());
        const bool hasNumber = std::ranges::any_of(cells, [](const QString &cell) {
            return enteredNumber(cell, Quantity::number).value.has_value();
        });
        if (!hasNumber && readings.empty()) {
            head.read(cells, motion);
            continue;
        }
        if (cells.size() != 2)
            return std::nullopt;
        if (head.deviationFirst)
            cells.swapItemsAt(0, 1);
        const auto time = driftNumber(head.time, cells[0], Quantity::time, units);
        const auto value = driftNumber(head.deviation, cells[1], shown, units);
        if (!time || !value)
            return std::nullopt;
        readings.push_back({*time, *value});
    }
    if (readings.empty())
        return std::nullopt;
    return readings;
}

} // namespace palmer
