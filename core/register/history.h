// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "language/language.h"
#include "register/due.h"
#include "register/queries.h"
#include "report/blocks/report.h"

#include <QDate>

namespace palmer {

/// What the history of a machine is made of.
struct History {
    ListedMachine machine;
    std::vector<ListedTest> tests; ///< all of it, as tests() has them
    MachineDue due;
    Laboratory laboratory; ///< of the newest test; may be empty
    QDate today;
    QString program; ///< "Palmer 0.1.0"
    QString number;  ///< of the printed history; empty: none
};

/// The number a history gets where nobody gives another: "HI-2026-000-017", of year and serial number; empty
/// for a machine without one.
[[nodiscard]] QString proposedHistoryNumber(const ListedMachine &machine, const QDate &today);

/// Reads what the history of a machine needs. The laboratory is that of the newest test that can be read, the
/// number the proposed one.
[[nodiscard]] History historyOf(Database &database, const ListedMachine &machine, const QDate &today,
                                const QString &program);

/// The printed history: what is to be watched first, the trends of each axis and plane, the campaigns, all
/// results with their files. A pure function.
[[nodiscard]] Report composeHistory(const History &history, const Language &language);

} // namespace palmer
