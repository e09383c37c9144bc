// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/queries.h"

#include "document/filewords.h"
#include "document/resultwords.h"
#include "register/machineidentity.h"
#include "register/register.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>

namespace palmer {

namespace {

std::string utf8(const QVariant &value) {
    return value.toString().toStdString();
}

std::optional<std::string> optionalText(const QVariant &value) {
    return value.isNull() ? std::nullopt : std::optional(utf8(value));
}

std::optional<double> optionalNumber(const QVariant &value) {
    return value.isNull() ? std::nullopt : std::optional(value.toDouble());
}

std::optional<int> optionalCount(const QVariant &value) {
    return value.isNull() ? std::nullopt : std::optional(value.toInt());
}

template <class Enumeration>
Enumeration fromWord(const QVariant &value) {
    const std::string word = utf8(value);
    for (const auto &row : fileWords<Enumeration>) {
        if (word == row.word)
            return row.value;
    }
    return {};
}

std::optional<Verdict> verdictFrom(const QVariant &value) {
    if (value.isNull())
        return std::nullopt;
    for (const Verdict verdict : {Verdict::conforms, Verdict::notProven, Verdict::doesNotConform}) {
        if (value.toString() == QLatin1StringView(limitsWord(verdict)))
            return verdict;
    }
    return std::nullopt;
}

Accordance accordanceFrom(const QVariant &value) {
    for (const Accordance accordance :
         {Accordance::no, Accordance::notShown, Accordance::partly, Accordance::yes}) {
        if (value.toString() == QLatin1StringView(fileWord(accordance)))
            return accordance;
    }
    return Accordance::notChecked;
}

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

    void add(const QString &part, const QVariantList &bound) {
        text += (text.isEmpty() ? QStringLiteral(" where ") : QStringLiteral(" and ")) + part;
        values += bound;
    }
};

Condition conditionOf(const TestFilter &filter) {
    Condition result;
    if (!filter.machines.empty()) {
        QStringList places;
        QVariantList ids;
        for (const int id : filter.machines) {
            places << QStringLiteral("?");
            ids << id;
        }
        result.add(QStringLiteral("machine in (") + places.join(u',') + u')', ids);
    }
    if (filter.kind)
        result.add(QStringLiteral("kind = ?"), {QString::fromLatin1(fileWord(*filter.kind))});
    if (!filter.since.isEmpty())
        result.add(QStringLiteral("date >= ?"), {filter.since});
    if (!filter.until.isEmpty())
        result.add(QStringLiteral("date <= ?"), {filter.until});
    if (filter.limits == QLatin1StringView("noneAgreed"))
        result.add(QStringLiteral("verdict is null"), {});
    else if (!filter.limits.isEmpty())
        result.add(QStringLiteral("verdict = ?"), {filter.limits});
    return result;
}

ListedTest testFrom(const QSqlQuery &row) {
    ListedTest result;
    int column = 0;
    const auto next = [&] { return row.value(column++); };
    result.id = next().toInt();
    result.test.digest = next().toString();
    result.machine = next().toInt();
    RegisteredTest &test = result.test;
    test.machineName = utf8(next());
    test.manufacturer = utf8(next());
    test.model = utf8(next());
    test.serialNumber = utf8(next());
    test.location = utf8(next());
    test.kind = fromWord<Kind>(next());
    test.title = utf8(next());
    test.id = utf8(next());
    test.edition = utf8(next());
    test.axis = utf8(next());
    test.angular = next().toInt() != 0;
    test.date = optionalText(next());
    test.time = optionalText(next());
    test.feed = optionalNumber(next());
    test.travel = optionalNumber(next());
    test.setUp = utf8(next());
    test.correction = fromWord<CorrectionTo20>(next());
    test.purpose = fromWord<Purpose>(next());
    test.role = fromWord<TestRole>(next());
    test.verdict = verdictFrom(next());
    test.rule = fromWord<Rule>(next());
    test.accordance = accordanceFrom(next());
    test.counts.unmet = next().toInt();
    test.counts.undeclared = next().toInt();
    test.counts.departures = next().toInt();
    test.fingerprint = next().toString();
    test.parts = partsFrom(next().toString());
    test.awaitsSimulation = next().toInt() != 0;
    return result;
}

RegisteredResult resultFrom(const QSqlQuery &row) {
    int column = 1;
    const auto next = [&] { return row.value(column++); };
    RegisteredResult result;
    result.id = utf8(next());
    result.value = optionalNumber(next());
    result.expandedUncertainty = optionalNumber(next());
    result.k = optionalNumber(next());
    result.bound = static_cast<Bound>(next().toInt());
    result.limit = optionalNumber(next());
    result.guardBand = optionalNumber(next());
    result.verdict = verdictFrom(next());
    result.own = next().toDouble();
    result.shared = static_cast<unsigned>(next().toInt());
    result.sharedFactor = next().toDouble();
    result.withoutParts = next().toInt() != 0;
    result.decimals = optionalCount(next());
    result.uncertaintyDecimals = optionalCount(next());
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
    eachRow(
        database, condition,
        QStringLiteral("select place.test, source.path, place.position, source.state from place, source "
                       "where source.id = place.source and place.test"),
        {}, byId, [](ListedTest &test, const QSqlQuery &row) {
            test.places.push_back({row.value(1).toString(), row.value(2).toInt(), row.value(3).toString()});
        });
    eachRow(database, condition,
            QStringLiteral("select test, description, serial, certificate, due from instrument where test"),
            QStringLiteral("order by test, position"), byId, [](ListedTest &test, const QSqlQuery &row) {
                test.test.instruments.push_back(
                    {utf8(row.value(1)), utf8(row.value(2)), utf8(row.value(3)), optionalText(row.value(4))});
            });
    eachRow(database, condition,
            QStringLiteral(
                "select test, id, value, expanded, k, bound, limit_value, guard, verdict, own, shared, "
                "factor, whole, decimals, udecimals from result where test"),
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

int order(TestRole role) {
    return role == TestRole::asFound ? 0 : role == TestRole::notStated ? 1 : 2;
}

} // namespace

QString ListedMachine::title() const {
    if (!name.isEmpty())
        return name;
    return model.isEmpty() || serialNumber.isEmpty() ? model + serialNumber : model + u' ' + serialNumber;
}

std::vector<ListedMachine> machines(Database &database) {
    std::vector<ListedMachine> result;
    QSqlQuery &query = database.run(
        QStringLiteral("select id, identity, identified, name, manufacturer, model, serial, location, months "
                       "from machine where months is not null or exists (select 1 from test where "
                       "test.machine = machine.id)"));
    while (query.next()) {
        ListedMachine machine;
        machine.id = query.value(0).toInt();
        machine.identity = query.value(1).toString();
        machine.isIdentified = query.value(2).toInt() != 0;
        machine.name = query.value(3).toString();
        machine.manufacturer = query.value(4).toString();
        machine.model = query.value(5).toString();
        machine.serialNumber = query.value(6).toString();
        machine.location = query.value(7).toString();
        if (!query.value(8).isNull())
            machine.months = query.value(8).toInt();
        result.push_back(std::move(machine));
    }
    std::ranges::sort(result, {}, [](const ListedMachine &machine) {
        return std::tuple(!machine.isIdentified, machine.title(), machine.serialNumber, machine.identity);
    });
    return result;
}

std::map<int, std::vector<AxisState>> axisStates(Database &database) {
    std::map<int, std::vector<AxisState>> result;
    // If there are several tests on one day, the latest, in the order of tests().
    std::map<std::pair<int, QString>, std::pair<QString, AxisState>> newest;
    QSqlQuery &query = database.run(QStringLiteral(
        "select test.machine, test.axis, test.kind, test.verdict, test.accordance, test.time, test.role, "
        "test.digest from test, (select machine, axis, max(date) as day from test where date is not null and "
        "kind <> 'drift' group by machine, axis) as last where test.machine = last.machine and test.axis = "
        "last.axis and test.date = last.day and test.kind <> 'drift'"));
    while (query.next()) {
        AxisState state{query.value(1).toString(), fromWord<Kind>(query.value(2)),
                        verdictFrom(query.value(3)), accordanceFrom(query.value(4))};
        const QString place = query.value(5).toString() + u' ' +
                              QString::number(order(fromWord<TestRole>(query.value(6)))) + u' ' +
                              query.value(7).toString();
        auto &known = newest[{query.value(0).toInt(), state.axis}];
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

std::vector<ListedMachine> machinesCalled(const std::vector<ListedMachine> &machines, const QString &words) {
    const QString wanted = comparable(words);
    std::vector<ListedMachine> exact;
    std::vector<ListedMachine> containing;
    for (const ListedMachine &machine : machines) {
        if (comparable(machine.name) == wanted || comparable(machine.serialNumber) == wanted)
            exact.push_back(machine);
        const QString all = comparable(machine.name) + u'\n' + comparable(machine.manufacturer) + u'\n' +
                            comparable(machine.model) + comparable(machine.serialNumber) + u'\n' +
                            comparable(machine.location);
        if (all.contains(wanted))
            containing.push_back(machine);
    }
    return exact.empty() ? containing : exact;
}

std::vector<ListedTest> tests(Database &database, const TestFilter &filter) {
    const Condition condition = conditionOf(filter);
    QSqlQuery query = database.prepare(
        QStringLiteral(
            "select id, digest, machine, name, manufacturer, model, serial, location, kind, title, "
            "word, edition, axis, angular, date, time, feed, travel, setup, correction, purpose, "
            "role, verdict, rule, accordance, unmet, undeclared, departures, fingerprint, parts, "
            "awaits from test") +
        condition.text);
    database.run(query, condition.values);
    std::vector<ListedTest> result;
    while (query.next()) {
        ListedTest test = testFrom(query);
        if (filter.axis.isEmpty() || isAxis(test.test, filter.axis))
            result.push_back(std::move(test));
    }
    query.finish();
    addParts(database, filter, condition, result);
    std::erase_if(result, [](const ListedTest &test) { return test.places.empty(); }); // just removed
    if (!filter.words.isEmpty())
        std::erase_if(result, [&](const ListedTest &test) { return !hasWords(test, filter.words); });
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

void setInterval(Database &database, int machine, std::optional<int> months) {
    database.run(QStringLiteral("update machine set months = ? where id = ?"),
                 {months ? QVariant(*months) : QVariant(), machine});
}

} // namespace palmer
