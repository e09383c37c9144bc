// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "register/registeredtest.h"

#include <QDate>
#include <QString>
#include <map>
#include <optional>
#include <vector>

namespace palmer {

class Database;

/// A machine of the register, called as in its newest test.
struct ListedMachine {
    int id = 0;       ///< within this register; never shown
    QString identity; ///< see machineIdentity()
    bool isIdentified = true;
    QString name;
    QString manufacturer;
    QString model;
    QString serialNumber;
    QString location;
    std::optional<int> months; ///< interval of its tests; null: none

    /// Its name, else type and serial number; empty where nothing is stated.
    [[nodiscard]] QString title() const;
};

/// Where a test stands.
struct TestPlace {
    QString path;
    int test = 1;  ///< from 1
    QString state; ///< "read", "notFound", …
};

struct ListedTest {
    int id = 0; ///< within this register
    int machine = 0;
    RegisteredTest test;
    std::vector<TestPlace> places;  ///< by path, those that are there first; never empty
    std::optional<std::string> due; ///< of the test that an interval counts from: the day of the next
    std::optional<std::string> certificateDue; ///< of the newest test of a machine: the first to expire
};

/// What is asked for; empty: all.
struct TestFilter {
    std::vector<int> machines; ///< ids; empty: all
    QString axis;              ///< or plane, without case
    std::optional<Kind> kind;
    QString since; ///< YYYY-MM-DD, that day included
    QString until;
    QString limits; ///< respected, notProven, exceeded, noneAgreed
    QString words;  ///< each of them somewhere in names, title, axis, edition, date, instruments, paths
    bool withCurves = false;
};

/// All machines that have tests, or an interval; those without serial number last; by name and serial number.
[[nodiscard]] std::vector<ListedMachine> machines(Database &database);

/// How the newest test of an axis or plane stands.
struct AxisState {
    QString axis;
    Kind kind = Kind::positioning;
    std::optional<Verdict> verdict;
    Accordance accordance = Accordance::notChecked;
};

/// Of each machine (its id) its axes and planes, drift tests apart: axes first, by name.
[[nodiscard]] std::map<int, std::vector<AxisState>> axisStates(Database &database);

/// Of each machine (its id) how many tests it has.
[[nodiscard]] std::map<int, int> testCounts(Database &database);

/// Of these the machines a user means: with just this name or serial number, else those whose name, maker,
/// type, serial number or place contain it; without case, spaces and punctuation.
[[nodiscard]] std::vector<ListedMachine> machinesCalled(const std::vector<ListedMachine> &machines,
                                                        const QString &words);

/// The tests asked for, by date, time, role (as found first), axis and digest; without date first. `due` and
/// `certificateDue` are not filled in: see due.h.
[[nodiscard]] std::vector<ListedTest> tests(Database &database, const TestFilter &filter);

/// Whether a test is one of those asked for.
[[nodiscard]] bool matches(const ListedTest &listed, const TestFilter &filter);

/// A file of the register that has no tests to show.
struct ListedSource {
    QString path;
    QString state; ///< "unreadable", "notFound"
    QString error; ///< see storedsentence.h
};

/// Files that cannot be read or are not found any more, by path.
[[nodiscard]] std::vector<ListedSource> troubledSources(Database &database);

/// Sets the interval of a machine in months; null: none. Throws Error.
void setInterval(Database &database, int machine, std::optional<int> months);

} // namespace palmer
