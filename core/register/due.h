// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "register/queries.h"

#include <QDate>
#include <map>

namespace palmer {

/// Due dates of a machine.
struct MachineDue {
    std::optional<QDate> test;        ///< by its interval, from the last periodic or acceptance test
    std::optional<QDate> certificate; ///< first expiry among the instruments of its newest test
};

/// Sets the due dates in `tests` (all tests of these machines, in their order): `due` on the last periodic or
/// acceptance test of a machine, `certificateDue` on its newest. `months`: for machines without an interval
/// of their own. An instrument has the latest due date stated for it by any test in the register.
std::map<int, MachineDue> markDue(Database &database, const std::vector<ListedMachine> &machines,
                                  std::vector<ListedTest> &tests, std::optional<int> months = {});

/// The same for all machines, without reading their tests.
[[nodiscard]] std::map<int, MachineDue> dueDates(Database &database,
                                                 const std::vector<ListedMachine> &machines);

} // namespace palmer
