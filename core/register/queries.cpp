// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/queries.h"

#include "register/machinechoices.h"
#include "register/register.h"
#include "register/storedvalues.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <set>

namespace palmer {

namespace {

std::optional<double> numberFrom(QStringView digits) {
    if (digits.isEmpty())
        return std::nullopt;
    const QByteArray latin = digits.toLatin1();
    double value = 0;
    std::from_chars(latin.begin(), latin.end(), value);
    return value;
}

std::vector<SharedPart> partsFrom(const QString &text) {
    std::vector<SharedPart> parts;
    for (const QString &line : text.split(u'\n', Qt::SkipEmptyParts)) {
        const qsizetype blank = line.indexOf(u' ');
        parts.push_back(
            {line.mid(blank + 1).toStdString(), numberFrom(QStringView(line).first(blank)).value_or(0)});
    }
    return parts;
}

std::vector<CurvePoint> curveFrom(const QString &text) {
    std::vector<CurvePoint> curve;
    for (const QString &line : text.split(u'\n', Qt::SkipEmptyParts)) {
        const QStringList cells = line.split(u' ');
        if (cells.size() == 3)
            curve.push_back({numberFrom(cells[0]).value_or(0), numberFrom(cells[1]), numberFrom(cells[2])});
    }
    return curve;
}

/// The part after "from test" of a statement, with the values of its placeholders.
struct Condition {
    QString text;
    QVariantList values;
};

Condition conditionOf(const TestFilter &filter) {
    if (filter.machines.empty())
        return {};
    const QStringList places(static_cast<qsizetype>(filter.machines.size()), QStringLiteral("?"));
    return {QStringLiteral(" where machine in (") + places.join(u',') + u')',
            QVariantList(filter.machines.begin(), filter.machines.end())};
}

ListedTest testFrom(const QSqlQuery &row) {
    ListedTest result;
    RegisteredTest &test = result.test;
    QString parts;
    RowReader(row).read(result.id, test.digest, result.machine, test.machineName, test.manufacturer,
                        test.model, test.serialNumber, test.location, test.kind, test.title, test.id,
                        test.edition, test.axis, test.angular, test.date, test.time, test.feed, test.travel,
                        test.setUp, test.correction, test.purpose, test.role, test.verdict, test.rule,
                        test.accordance, test.counts.unmet, test.counts.undeclared, test.counts.departures,
                        test.fingerprint, parts, test.awaitsSimulation);
    test.parts = partsFrom(parts);
    return result;
}

RegisteredResult resultFrom(const QSqlQuery &row) {
    RegisteredResult result;
    int bound = 0;
    int shared = 0;
    RowReader(row, 2).read(result.id, result.value, result.expandedUncertainty, result.k, bound, result.limit,
                           result.guardBand, result.verdict, result.own, shared, result.sharedFactor,
                           result.withoutParts, result.decimals, result.uncertaintyDecimals);
    result.bound = static_cast<Bound>(bound);
    result.shared = static_cast<unsigned>(shared);
    return result;
}

/// Passes each row of `statement` … (tests of the condition) `order` to the test of its first column.
template <class Take>
void eachRow(Database &database, const Condition &condition, const QString &statement, const QString &order,
             const std::map<int, ListedTest *> &byId, Take take) {
    QSqlQuery query = database.prepare(statement + QStringLiteral(" in (select id from test") +
                                       condition.text + QStringLiteral(") ") + order);
    database.run(query, condition.values);
    while (query.next()) {
        const auto test = byId.find(query.value(0).toInt());
        if (test != byId.end())
            take(*test->second, query);
    }
}

void addParts(Database &database, const TestFilter &filter, const Condition &condition,
              std::vector<ListedTest> &list) {
    std::map<int, ListedTest *> byId;
    for (ListedTest &test : list)
        byId.emplace(test.id, &test);
    eachRow(database, condition,
            QStringLiteral("select place.test, source.path, place.position, source.state, source.number from "
                           "place, source where source.id = place.source and place.test"),
            {}, byId, [](ListedTest &test, const QSqlQuery &row) {
                TestPlace &place = test.places.emplace_back();
                RowReader(row, 1).read(place.path, place.test, place.state, place.number);
            });
    eachRow(database, condition,
            QStringLiteral("select test, description, serial, certificate, due from instrument where test"),
            QStringLiteral("order by test, position"), byId, [](ListedTest &test, const QSqlQuery &row) {
                RegisteredInstrument &one = test.test.instruments.emplace_back();
                RowReader(row, 1).read(one.description, one.serialNumber, one.certificate, one.due);
            });
    eachRow(database, condition,
            QStringLiteral("select ") + resultColumns + QStringLiteral(" from result where test"),
            QStringLiteral("order by test, position"), byId,
            [](ListedTest &test, const QSqlQuery &row) { test.test.results.push_back(resultFrom(row)); });
    if (filter.withCurves)
        eachRow(database, condition, QStringLiteral("select test, points from curve where test"), {}, byId,
                [](ListedTest &test, const QSqlQuery &row) {
                    test.test.curve = curveFrom(row.value(1).toString());
                });
    for (ListedTest &test : list)
        std::ranges::sort(test.places, {}, [](const TestPlace &place) {
            return std::tuple(place.state == QLatin1StringView("notFound"), place.path, place.test);
        });
}

QString searched(const ListedTest &listed) {
    const RegisteredTest &test = listed.test;
    QStringList texts;
    for (const std::string *text : {&test.machineName, &test.manufacturer, &test.model, &test.serialNumber,
                                    &test.location, &test.title, &test.axis, &test.edition})
        texts << QString::fromStdString(*text);
    if (test.date)
        texts << QString::fromStdString(*test.date);
    texts << QString::fromLatin1(fileWord(test.purpose)) << QString::fromLatin1(fileWord(test.role));
    for (const RegisteredInstrument &instrument : test.instruments)
        texts << QString::fromStdString(instrument.description + ' ' + instrument.serialNumber + ' ' +
                                        instrument.certificate);
    for (const TestPlace &place : listed.places)
        texts << place.path;
    return texts.join(u'\n').toCaseFolded();
}

bool hasWords(const ListedTest &test, const QString &words) {
    const QString text = searched(test);
    return std::ranges::all_of(words.toCaseFolded().split(u' ', Qt::SkipEmptyParts),
                               [&](const QString &word) { return text.contains(word); });
}

bool isAxis(const RegisteredTest &test, const QString &axis) {
    return QString::fromStdString(test.axis).compare(axis, Qt::CaseInsensitive) == 0;
}

/// Machines as tests state them: also before one was named anew or joined to another.
std::vector<ListedMachine> statedMachines(Database &database) {
    std::vector<ListedMachine> result;
    QSqlQuery &query = database.run(
        QStringLiteral("select distinct machine, name, manufacturer, model, serial, location from test"));
    while (query.next()) {
        ListedMachine &machine = result.emplace_back();
        RowReader(query).read(machine.id, machine.name, machine.manufacturer, machine.model,
                              machine.serialNumber, machine.location);
    }
    return result;
}

/// Adds what other machines tests state: few registers have joined ones, all have many tests.
void addJoined(Database &database, std::vector<ListedMachine> &machines) {
    if (keptChoices(database).joined.empty())
        return;
    for (const ListedMachine &stated : statedMachines(database)) {
        const auto machine = std::ranges::find(machines, stated.id, &ListedMachine::id);
        const QString identity = machineIdentity(stated);
        if (machine != machines.end() && identity != machine->identity &&
            std::ranges::find(machine->joined, identity, machineIdentity) == machine->joined.end())
            machine->joined.push_back(stated);
    }
    for (ListedMachine &machine : machines)
        std::ranges::sort(machine.joined, {}, machineIdentity);
}

int order(TestRole role) {
    return role == TestRole::asFound ? 0 : role == TestRole::notStated ? 1 : 2;
}

} // namespace

QString titleOf(const MachineFields &machine) {
    const auto &[name, manufacturer, model, serialNumber] = machine;
    if (!name.isEmpty())
        return name;
    return model.isEmpty() || serialNumber.isEmpty() ? model + serialNumber : model + u' ' + serialNumber;
}

QString markOf(const MachineFields &machine) {
    return isIdentified(machineIdentity(machine)) ? machine.serialNumber : titleOf(machine);
}

QString searched(const ListedMachine &machine) {
    const auto of = [](const MachineFields &fields) {
        return comparable(fields.name) + u'\n' + comparable(fields.manufacturer) + u'\n' +
               comparable(fields.model) + comparable(fields.serialNumber) + u'\n';
    };
    QString all = of(machine) + comparable(machine.location);
    for (const MachineFields &fields : machine.joined)
        all += u'\n' + of(fields);
    return all;
}

std::vector<ListedMachine> machines(Database &database) {
    std::vector<ListedMachine> result;
    QSqlQuery &query = database.run(
        QStringLiteral("select id, identity, identified, name, manufacturer, model, serial, location, months "
                       "from machine where exists (select 1 from test where test.machine = machine.id)"));
    while (query.next()) {
        ListedMachine &machine = result.emplace_back();
        RowReader(query).read(machine.id, machine.identity, machine.isIdentified, machine.name,
                              machine.manufacturer, machine.model, machine.serialNumber, machine.location,
                              machine.months);
    }
    addJoined(database, result);
    std::ranges::sort(result, {}, [](const ListedMachine &machine) {
        return std::tuple(!machine.isIdentified, machine.title(), machine.serialNumber, machine.identity);
    });
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i].number = static_cast<int>(i) + 1;
    return result;
}

std::map<int, std::vector<AxisState>> axisStates(Database &database) {
    std::map<int, std::vector<AxisState>> result;
    // If there are several tests on one day, the latest, in the order of tests().
    std::map<std::pair<int, QString>, std::pair<QString, AxisState>> newest;
    QSqlQuery &query = database.run(
        withNewestDays(isJudgedKind(QStringLiteral("kind"))) +
        QStringLiteral(
            "select test.machine, test.axis, test.kind, test.verdict, test.accordance, test.time, "
            "test.role, test.digest from test, last where test.machine = last.machine and test.axis "
            "= last.axis and test.date = last.day and ") +
        isJudgedKind(QStringLiteral("test.kind")));
    while (query.next()) {
        int machine = 0;
        AxisState state;
        QString time;
        TestRole role{};
        QString digest;
        RowReader(query).read(machine, state.axis, state.kind, state.verdict, state.accordance, time, role,
                              digest);
        const QString place = time + u' ' + QString::number(order(role)) + u' ' + digest;
        auto &known = newest[{machine, state.axis}];
        if (known.first.isEmpty() || place > known.first)
            known = {place, std::move(state)};
    }
    for (auto &[key, known] : newest)
        result[key.first].push_back(std::move(known.second));
    for (auto &[machine, axes] : result)
        std::ranges::sort(axes, {},
                          [](const AxisState &state) { return std::tuple(state.kind, state.axis); });
    return result;
}

std::map<int, int> testCounts(Database &database) {
    std::map<int, int> result;
    QSqlQuery &query = database.run(QStringLiteral("select machine, count(*) from test group by machine"));
    while (query.next())
        result.emplace(query.value(0).toInt(), query.value(1).toInt());
    return result;
}

std::vector<ListedMachine> machinesCalled(Database &database, const QString &words) {
    const std::vector<ListedMachine> all = machines(database);
    const auto chosen = [&all](auto fits) {
        std::vector<ListedMachine> result;
        std::ranges::copy_if(all, std::back_inserter(result), fits);
        return result;
    };
    const QString exact = asCompared(words);
    const auto isExact = [&exact](const ListedMachine &machine) {
        return asCompared(machine.name) == exact || asCompared(machine.serialNumber) == exact;
    };
    std::vector<ListedMachine> result = chosen(isExact);
    if (result.empty())
        result = chosen([&](const ListedMachine &machine) {
            const QString number = QString::number(machine.number);
            return exact == number || exact == number + u'.';
        });
    if (!result.empty())
        return result;
    const std::vector<ListedMachine> stated = statedMachines(database);
    const auto chosenAsStated = [&](auto fits) {
        std::set<int> ids;
        for (const ListedMachine &machine : stated) {
            if (fits(machine))
                ids.insert(machine.id);
        }
        return chosen([&ids](const ListedMachine &machine) { return ids.contains(machine.id); });
    };
    result = chosenAsStated(isExact);
    return !result.empty() ? result
                           : chosenAsStated([wanted = comparable(words)](const ListedMachine &machine) {
                                 return !wanted.isEmpty() && searched(machine).contains(wanted);
                             });
}

std::vector<ListedTest> tests(Database &database, const TestFilter &filter) {
    const Condition condition = conditionOf(filter);
    QSqlQuery query = database.prepare(QStringLiteral("select ") + testColumns +
                                       QStringLiteral(" from test") + condition.text);
    database.run(query, condition.values);
    std::vector<ListedTest> result;
    while (query.next()) {
        ListedTest test = testFrom(query);
        if (filter.axis.isEmpty() || isAxis(test.test, filter.axis))
            result.push_back(std::move(test));
    }
    query.finish();
    addParts(database, filter, condition, result);
    std::erase_if(result, [&](const ListedTest &test) { // without a place: just removed
        return test.places.empty() || !matches(test, filter);
    });
    std::ranges::sort(result, {}, [](const ListedTest &listed) {
        const RegisteredTest &test = listed.test;
        return std::tuple(test.date.value_or(""), test.time.value_or(""), order(test.role), test.axis,
                          test.digest);
    });
    return result;
}

bool matches(const ListedTest &listed, const TestFilter &filter) {
    const RegisteredTest &test = listed.test;
    const std::string date = test.date.value_or("");
    return (filter.machines.empty() ||
            std::ranges::find(filter.machines, listed.machine) != filter.machines.end()) &&
           (filter.axis.isEmpty() || isAxis(test, filter.axis)) &&
           (!filter.kind || test.kind == *filter.kind) &&
           (filter.since.isEmpty() || date >= filter.since.toStdString()) &&
           (filter.until.isEmpty() || (!date.empty() && date <= filter.until.toStdString())) &&
           (filter.limits.isEmpty() || filter.limits == QLatin1StringView(limitsWord(test.verdict))) &&
           (filter.words.isEmpty() || hasWords(listed, filter.words));
}

std::vector<ListedSource> troubledSources(Database &database) {
    std::vector<ListedSource> result;
    QSqlQuery &query = database.run(
        QStringLiteral("select path, state, error from source where state in ('unreadable', 'notFound')"));
    while (query.next())
        result.push_back({query.value(0).toString(), query.value(1).toString(), query.value(2).toString()});
    std::ranges::sort(result, {}, &ListedSource::path);
    return result;
}

} // namespace palmer
