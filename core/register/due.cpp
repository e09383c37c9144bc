// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/due.h"

#include "register/machinetrend.h"
#include "register/register.h"

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

bool countsForInterval(Purpose purpose) {
    return purpose == Purpose::periodic || purpose == Purpose::acceptance;
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

std::map<int, MachineDue> markDue(Database &database, const std::vector<ListedMachine> &machines,
                                  std::vector<ListedTest> &tests, std::optional<int> months) {
    const Certificates known = certificates(database);
    std::map<int, MachineDue> result;
    for (const ListedMachine &machine : machines) {
        ListedTest *newest = nullptr;
        ListedTest *counted = nullptr;
        for (ListedTest &test : tests) {
            if (test.machine != machine.id || !test.test.date)
                continue;
            newest = &test;
            if (countsForInterval(test.test.purpose))
                counted = &test;
        }
        MachineDue due;
        const std::optional<int> interval = machine.months ? machine.months : months;
        if (counted && interval)
            takeEarlier(due.test, dateOf(*counted->test.date).addMonths(*interval));
        if (newest) {
            due.certificate = firstExpiry(newest->test, known);
            newest->certificateDue = iso(due.certificate);
        }
        if (counted)
            counted->due = iso(due.test);
        result.emplace(machine.id, due);
    }
    return result;
}

std::map<int, MachineDue> dueDates(Database &database, const std::vector<ListedMachine> &machines) {
    const Certificates known = certificates(database);
    std::map<int, MachineDue> result;
    std::map<int, QDate> counted;
    QSqlQuery &last = database.run(
        QStringLiteral("select machine, max(date) from test where purpose in ('periodic', 'acceptance') and "
                       "date is not null group by machine"));
    while (last.next())
        counted.emplace(last.value(0).toInt(), QDate::fromString(last.value(1).toString(), Qt::ISODate));
    for (const ListedMachine &machine : machines) {
        const auto found = counted.find(machine.id);
        if (machine.months && found != counted.end())
            takeEarlier(result[machine.id].test, found->second.addMonths(*machine.months));
    }
    QSqlQuery &newest = database.run(QStringLiteral(
        "select test.machine, instrument.description, instrument.serial from test, instrument, (select "
        "machine, "
        "max(date) as newest from test where date is not null group by machine) as last where "
        "test.machine = last.machine and test.date = last.newest and instrument.test = test.id"));
    while (newest.next()) {
        const auto found = known.find({newest.value(1).toString(), newest.value(2).toString()});
        if (found != known.end())
            takeEarlier(result[newest.value(0).toInt()].certificate, found->second);
    }
    return result;
}

} // namespace palmer
