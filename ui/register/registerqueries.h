// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "language/language.h"
#include "register/machinetype.h"
#include "register/queries.h"
#include "ui/register/machinelist.h"

namespace palmer::ui {

// Queries of the register window, for background jobs: each opens its own connection to the register at
// `address` and returns an empty list on an error, which the register's service reports.

[[nodiscard]] std::vector<MachineRow> readMachines(const QString &address);
/// Returns the tests of a machine with their curves.
[[nodiscard]] std::vector<ListedTest> readTests(const QString &address, int machine);
/// Returns the type tests of all axes and parameters of the machines of one maker and type.
[[nodiscard]] std::vector<TypeTest> readTypeTests(const QString &address, const ListedMachine &machine);
/// The same of the files of a folder in the resources, all of machines of one type.
[[nodiscard]] std::vector<TypeTest> readTypeExample(const QString &folder);
/// Returns the files that cannot be read or found.
[[nodiscard]] std::vector<ListedSource> readTroubledFiles(const QString &address);
/// Joins another machine to one, or sets its interval, see withChoice(). Returns what there is to say: an
/// error, or folders that cannot be written.
[[nodiscard]] QString writeChoice(const QString &address, const ListedMachine &machine,
                                  const std::optional<ListedMachine> &other, std::optional<int> months,
                                  const Language &language);

/// Takes back that one of its joined machines is the same, see separateMachine(). Returns an error, or
/// nothing.
[[nodiscard]] QString writeSeparation(const QString &address, const ListedMachine &machine,
                                      const MachineFields &part, const Language &language);

} // namespace palmer::ui
