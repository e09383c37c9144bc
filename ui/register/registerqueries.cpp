// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/registerqueries.h"

#include "register/machinechoices.h"
#include "register/register.h"
#include "register/scan.h"

#include <QDir>
#include <QTemporaryDir>
#include <set>

namespace palmer::ui {

namespace {

/// Result of a query; empty after an error.
template <class Query>
auto answered(const QString &address, Query query) {
    try {
        Register reg(address, Register::Open::read);
        return query(reg.database());
    } catch (const Error &) {
        return decltype(query(std::declval<Database &>())){};
    }
}

} // namespace

std::vector<MachineRow> readMachines(const QString &address) {
    return answered(address, [&](Database &database) {
        std::vector<ListedMachine> list = machines(database);
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

std::vector<TypeTest> readTypeTests(const QString &address, const ListedMachine &machine) {
    return answered(address, [&](Database &database) {
        const std::vector<ListedMachine> ofType =
            machinesOfType(machines(database), machine.manufacturer + u' ' + machine.model);
        TestFilter filter;
        for (const ListedMachine &one : ofType)
            filter.machines.push_back(one.id);
        std::vector<TypeTest> result;
        if (ofType.empty())
            return result;
        const std::vector<ListedTest> list = tests(database, filter);
        std::set<std::pair<std::string, std::string>> pairs; // axis or plane, parameter
        for (const ListedTest &one : list) {
            for (const RegisteredResult &found : one.test.results) {
                if (found.value && hasTypeTest(found.id))
                    pairs.emplace(one.test.axis, found.id);
            }
        }
        for (const auto &[axis, parameter] : pairs)
            result.push_back(typeTest(ofType, list, axis, parameter, {}, TypeDistribution::logNormal));
        std::erase_if(result, [](const TypeTest &test) { return test.members.empty(); });
        return result;
    });
}

std::vector<TypeTest> readTypeExample(const QString &folder) {
    const QTemporaryDir files;
    for (const QFileInfo &file : QDir(folder).entryInfoList(QDir::Files))
        QFile::copy(file.filePath(), files.filePath(file.fileName()));
    const QString address = files.filePath(QStringLiteral("register.sqlite"));
    std::vector<ListedMachine> all;
    try {
        Register reg(address);
        (void)scan(reg, {files.path()});
        all = machines(reg.database());
    } catch (const Error &) {
        return {};
    }
    return all.empty() ? std::vector<TypeTest>() : readTypeTests(address, all.front());
}

std::vector<ListedSource> readTroubledFiles(const QString &address) {
    return answered(address, [](Database &database) { return troubledSources(database); });
}

QString writeSeparation(const QString &address, const ListedMachine &machine, const MachineFields &part,
                        const Language &language) {
    try {
        Register reg(address);
        separateMachine(reg, machine, part, language);
        return {};
    } catch (const Error &error) {
        return language.sentence(error.message);
    }
}

QString writeChoice(const QString &address, const ListedMachine &machine,
                    const std::optional<ListedMachine> &other, std::optional<int> months,
                    const Language &language) {
    try {
        Register reg(address);
        return chooseMachine(reg, machine, other ? &*other : nullptr, months, language).join(u' ');
    } catch (const Error &error) {
        return language.sentence(error.message);
    }
}

} // namespace palmer::ui
