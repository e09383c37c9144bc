// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

namespace palmer::testdata {

/// A test file whose budgets are simulated with few trials: a report of it is made in a fraction of a second.
/// For tests that ask for files, not for simulated numbers.
inline QByteArray withFewTrials(QByteArray file) {
    return file.replace(R"("method": "budget")", R"("method": "budget", "trials": 500)");
}

} // namespace palmer::testdata
