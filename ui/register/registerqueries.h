// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "register/queries.h"
#include "ui/register/machinelist.h"

#include <QVariantMap>

namespace palmer::ui {

// Queries of the register window, for background jobs: each opens its own connection to the register at
// `address` and returns an empty list on an error, which the register's service reports.

/// Intervals of machines in months, by identity. Kept in the settings for a rebuilt index, which has none.
[[nodiscard]] QVariantMap keptIntervals();
/// `months` = 0: no interval.
void keepInterval(const QString &identity, int months);

/// Returns the machines; those without an interval get the kept one.
[[nodiscard]] std::vector<MachineRow> readMachines(const QString &address, const QVariantMap &intervals);
/// Returns the tests of a machine with their curves.
[[nodiscard]] std::vector<ListedTest> readTests(const QString &address, int machine);
/// Returns the files that cannot be read or found.
[[nodiscard]] std::vector<ListedSource> readTroubledFiles(const QString &address);
/// Sets the interval of a machine in months; 0: none. Ignores errors.
void writeInterval(const QString &address, int machine, int months);

} // namespace palmer::ui
