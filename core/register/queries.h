// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "register/machineidentity.h"
#include "register/registeredtest.h"

#include <QDate>
#include <QString>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace palmer {

class Database;
struct SinceLast;

/// Returns the name of a machine, otherwise type and serial number; empty if nothing is stated.
[[nodiscard]] QString titleOf(const MachineFields &machine);
/// Returns its serial number, or its title without one.
[[nodiscard]] QString markOf(const MachineFields &machine);

/// A machine of the register, named as in its newest test.
struct ListedMachine : MachineFields {
    int id = 0;       ///< within this register; never shown
    int number = 0;   ///< its place in machines(), from 1
    QString identity; ///< see machineIdentity()
    bool isIdentified = true;
    QString location;
    std::optional<int> months;         ///< interval of its tests; null: none
    std::vector<MachineFields> joined; ///< as tests state machines that were joined to it

    /// Returns its name, otherwise type and serial number; empty if nothing is stated.
    [[nodiscard]] QString title() const { return titleOf(*this); }
};

/// Location of a test.
struct TestPlace {
    QString path;
    int test = 1;        ///< from 1
    QString state;       ///< "read", "notFound", …
    QString number = {}; ///< of the report
};

struct ListedTest {
    int id = 0; ///< within this register
    int machine = 0;
    RegisteredTest test;
    std::vector<TestPlace> places;              ///< by path, existing ones first; never empty
    std::optional<std::string> due;             ///< on the test an interval counts from: date of the next one
    std::optional<std::string> certificateDue;  ///< on the tests of an axis's newest day: first expiry
    std::shared_ptr<const SinceLast> sinceLast; ///< where it was asked for, see sincelast.h
};

/// A filter; empty: all tests.
struct TestFilter {
    std::vector<int> machines; ///< ids; empty: all
    QString axis;              ///< or plane, case-insensitive
    std::optional<Kind> kind;
    QString since; ///< YYYY-MM-DD, inclusive
    QString until;
    QString limits; ///< respected, notProven, exceeded, noneAgreed
    QString words;  ///< each of them must occur in names, title, axis, edition, date, instruments or paths
    bool withCurves = false;
};

/// Returns the machines by name and serial number; those without one last.
[[nodiscard]] std::vector<ListedMachine> machines(Database &database);

/// State of the newest test of an axis or plane.
struct AxisState {
    QString axis;
    Kind kind = Kind::positioning;
    std::optional<Verdict> verdict;
    Accordance accordance = Accordance::notChecked;
};

/// Returns axes and planes per machine id, drift tests separately: axes first, by name.
[[nodiscard]] std::map<int, std::vector<AxisState>> axisStates(Database &database);

/// Returns what a search of machines looks through, to compare with comparable().
[[nodiscard]] QString searched(const ListedMachine &machine);

/// Returns the number of tests per machine id.
[[nodiscard]] std::map<int, int> testCounts(Database &database);

/// Returns the machines a user means: those with exactly this name or serial number, otherwise the one with
/// this number ("3", "3."), otherwise those with a test that names the machine so, otherwise those with one
/// whose name, maker, type, serial number or location contains it without case, spaces and punctuation.
[[nodiscard]] std::vector<ListedMachine> machinesCalled(Database &database, const QString &words);

/// Returns the selected tests by date, time, role (as found first), axis and digest; those without date
/// first. Does not set `due` and `certificateDue`: see due.h.
[[nodiscard]] std::vector<ListedTest> tests(Database &database, const TestFilter &filter);

/// True if a test passes the filter.
[[nodiscard]] bool matches(const ListedTest &listed, const TestFilter &filter);

/// A file of the register without tests to show.
struct ListedSource {
    QString path;
    QString state; ///< "unreadable", "notFound"
    QString error; ///< see storedsentence.h
};

/// Returns files that are unreadable or not found any more, by path.
[[nodiscard]] std::vector<ListedSource> troubledSources(Database &database);

} // namespace palmer
