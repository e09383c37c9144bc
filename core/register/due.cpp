// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/due.h"

#include "kernel/measurement/testfacts.h"
#include "register/machinetrend.h"
#include "register/register.h"
#include "register/storedvalues.h"

#include <algorithm>

namespace palmer {

namespace {

/// The latest due date of each instrument, by its description and serial number.
using Certificates = std::map<std::pair<QString, QString>, QDate>;

Certificates certificates(Database &database) {
    Certificates result;
    QSqlQuery &query = database.run(QStringLiteral(
        "select description, serial, max(due) from instrument where due is not null group by description, "
        "serial"));
    while (query.next()) {
        const QDate due = QDate::fromString(query.value(2).toString(), Qt::ISODate);
        if (due.isValid())
            result.emplace(std::pair(query.value(0).toString(), query.value(1).toString()), due);
    }
    return result;
}

bool countsForInterval(const RegisteredTest &test) {
    return traitsOf(test.kind).isJudged &&
           (test.purpose == Purpose::periodic || test.purpose == Purpose::acceptance);
}

void takeEarlier(std::optional<QDate> &date, const QDate &other) {
    if (other.isValid() && (!date || other < *date))
        date = other;
}

std::optional<std::string> iso(const std::optional<QDate> &date) {
    return date ? std::optional(date->toString(Qt::ISODate).toStdString()) : std::nullopt;
}

/// Returns the first expiry of the certificates of a test's instruments; null if none is known.
std::optional<QDate> firstExpiry(const RegisteredTest &test, const Certificates &known) {
    std::optional<QDate> first;
    for (const RegisteredInstrument &instrument : test.instruments) {
        const auto found = known.find({QString::fromStdString(instrument.description),
                                       QString::fromStdString(instrument.serialNumber)});
        if (found != known.end())
            takeEarlier(first, found->second);
    }
    return first;
}

} // namespace

std::optional<QDate> MachineDue::test() const {
    std::optional<QDate> first;
    for (const auto &[axis, date] : tests)
        takeEarlier(first, date);
    return first;
}

QString MachineDue::axesDue(const QDate &day) const {
    QStringList axes;
    for (const auto &[axis, date] : tests) {
        if (date == day)
            axes << axis;
    }
    constexpr qsizetype most = 3;
    if (axes.size() > most)
        axes = axes.first(most) << QStringLiteral("…");
    return axes.join(QStringLiteral(", "));
}

MachineDue markDue(Database &database, const ListedMachine &machine, std::vector<ListedTest> &tests,
                   std::optional<int> months) {
    const Certificates known = certificates(database);
    const std::optional<int> interval = machine.months ? machine.months : months;
    MachineDue result;
    std::map<QString, ListedTest *> counted;
    std::map<std::string, std::optional<std::string>> newest;
    for (ListedTest &test : tests) {
        newest[test.test.axis] = test.test.date;
        if (test.test.date && countsForInterval(test.test))
            counted[QString::fromStdString(test.test.axis)] = &test;
    }
    for (ListedTest &test : tests) {
        if (!test.test.date || test.test.date != newest[test.test.axis])
            continue;
        const std::optional<QDate> expiry = firstExpiry(test.test, known);
        test.certificateDue = iso(expiry);
        takeEarlier(result.certificate, expiry.value_or(QDate()));
    }
    for (const auto &[axis, test] : counted) {
        const QDate date = interval ? dateOf(*test->test.date).addMonths(*interval) : QDate();
        if (!date.isValid())
            continue;
        result.tests.emplace(axis, date);
        test->due = iso(date);
    }
    return result;
}

std::map<int, MachineDue> dueDates(Database &database, const std::vector<ListedMachine> &machines) {
    const Certificates known = certificates(database);
    std::map<int, MachineDue> result;
    std::map<int, int> intervals;
    for (const ListedMachine &machine : machines) {
        if (machine.months)
            intervals.emplace(machine.id, *machine.months);
    }
    QSqlQuery &last =
        database.run(withNewestDays(isJudgedKind(QStringLiteral("kind")) +
                                    QStringLiteral(" and purpose in ('periodic', 'acceptance')")) +
                     QStringLiteral("select machine, axis, day from last where day is not null"));
    while (last.next()) {
        const auto months = intervals.find(last.value(0).toInt());
        const QDate date = QDate::fromString(last.value(2).toString(), Qt::ISODate);
        if (months != intervals.end() && date.isValid())
            result[months->first].tests.emplace(last.value(1).toString(), date.addMonths(months->second));
    }
    QSqlQuery &newest = database.run(
        withNewestDays(QStringLiteral("date is not null")) +
        QStringLiteral(
            "select test.machine, instrument.description, instrument.serial from test, instrument, "
            "last where test.machine = last.machine and test.axis = last.axis and test.date = "
            "last.day and instrument.test = test.id"));
    while (newest.next()) {
        const auto found = known.find({newest.value(1).toString(), newest.value(2).toString()});
        if (found != known.end())
            takeEarlier(result[newest.value(0).toInt()].certificate, found->second);
    }
    return result;
}

} // namespace palmer
