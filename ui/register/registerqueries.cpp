// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/registerqueries.h"

#include "register/register.h"

#include <QFileInfo>
#include <QSettings>

namespace palmer::ui {

namespace {

const QString intervalsKey = QStringLiteral("register/intervals");

/// Result of a query; empty after an error.
template <class Query>
auto answered(const QString &address, Query query) {
    try {
        Register reg(address);
        return query(reg.database());
    } catch (const Error &) {
        return decltype(query(std::declval<Database &>())){};
    }
}

} // namespace

QVariantMap keptIntervals() {
    return QSettings().value(intervalsKey).toMap();
}

void keepInterval(const QString &identity, int months) {
    QVariantMap kept = keptIntervals();
    kept.remove(identity);
    if (months > 0)
        kept.insert(identity, months);
    QSettings().setValue(intervalsKey, kept);
}

std::vector<MachineRow> readMachines(const QString &address, const QVariantMap &intervals) {
    return answered(address, [&](Database &database) {
        std::vector<ListedMachine> list = machines(database);
        for (ListedMachine &machine : list) {
            const auto months = intervals.constFind(machine.identity);
            if (machine.months || months == intervals.constEnd())
                continue;
            machine.months = months->toInt();
            setInterval(database, machine.id, machine.months);
        }
        auto due = dueDates(database, list);
        auto axes = axisStates(database);
        auto counts = testCounts(database);
        std::vector<MachineRow> rows;
        for (ListedMachine &machine : list) {
            const int id = machine.id;
            rows.push_back({std::move(machine), std::move(axes[id]), due[id], counts[id]});
        }
        return rows;
    });
}

std::vector<ListedTest> readTests(const QString &address, int machine) {
    return answered(address, [&](Database &database) {
        TestFilter filter;
        filter.machines = {machine};
        filter.withCurves = true;
        return tests(database, filter);
    });
}

std::vector<ListedSource> readTroubledFiles(const QString &address) {
    return answered(address, [](Database &database) { return troubledSources(database); });
}

void writeInterval(const QString &address, int machine, int months) {
    (void)answered(address, [&](Database &database) {
        setInterval(database, machine, months > 0 ? std::optional(months) : std::nullopt);
        return true;
    });
}

} // namespace palmer::ui
