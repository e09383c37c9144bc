// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "register/queries.h"

#include <QDate>
#include <map>

namespace palmer {

/// When something of a machine is due.
struct MachineDue {
    std::optional<QDate> test;        ///< by its interval, from its last periodic or acceptance test
    std::optional<QDate> certificate; ///< of an instrument of its newest test the first to expire
};

/// Marks in `tests` (all of these machines, in their order) what is due: `due` on the last periodic or
/// acceptance test of a machine, `certificateDue` on its newest. `months`: of machines that have no interval
/// of their own. An instrument has the latest due date that any test of the register states for it.
std::map<int, MachineDue> markDue(Database &database, const std::vector<ListedMachine> &machines,
                                  std::vector<ListedTest> &tests, std::optional<int> months = {});

/// The same of all machines, without reading their tests.
[[nodiscard]] std::map<int, MachineDue> dueDates(Database &database,
                                                 const std::vector<ListedMachine> &machines);

} // namespace palmer
