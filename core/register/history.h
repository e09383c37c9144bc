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

/// Input of the history of a machine.
struct History {
    ListedMachine machine;
    std::vector<ListedTest> tests; ///< all of them, from tests()
    MachineDue due;
    Laboratory laboratory; ///< of the newest test; may be empty
    QDate today;
    QString program; ///< "Palmer 0.1.0"
    QString number;  ///< number of the printed history; empty: none
};

/// Returns the default number of a history: "HI-2026-000-017", from year and serial number; empty for a
/// machine without one.
[[nodiscard]] QString proposedHistoryNumber(const ListedMachine &machine, const QDate &today);

/// Reads the data for the history of a machine. The laboratory is that of the newest readable test, the
/// number the proposed one.
[[nodiscard]] History historyOf(Database &database, const ListedMachine &machine, const QDate &today,
                                const QString &program);

/// Composes the printed history: items to watch, the trends of each axis and plane, the campaigns, all
/// results with their files. A pure function.
[[nodiscard]] Report composeHistory(const History &history, const Language &language);

} // namespace palmer
