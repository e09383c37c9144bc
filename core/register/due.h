// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "register/queries.h"

#include <QDate>
#include <map>

namespace palmer {

/// Due dates of a machine.
struct MachineDue {
    /// Dates of axes and planes, by their interval, from their last periodic or acceptance test.
    std::map<QString, QDate> tests;
    std::optional<QDate> certificate; ///< first expiry among the instruments last used on an axis

    /// Returns the first of the tests; null without one.
    [[nodiscard]] std::optional<QDate> test() const;
    /// Returns the axes and planes due on that day: "X, XY", "X, Y, Z, …".
    [[nodiscard]] QString axesDue(const QDate &day) const;
};

/// Sets the due dates in `tests` (all tests of a machine, in their order): `due` on the last periodic or
/// acceptance test of each axis and plane, `certificateDue` on the tests of its newest day. `months`: for a
/// machine without an interval of its own. An instrument has the latest due date stated for it by any test in
/// the register.
MachineDue markDue(Database &database, const ListedMachine &machine, std::vector<ListedTest> &tests,
                   std::optional<int> months = {});

/// The same for all machines, without reading their tests.
[[nodiscard]] std::map<int, MachineDue> dueDates(Database &database,
                                                 const std::vector<ListedMachine> &machines);

} // namespace palmer
