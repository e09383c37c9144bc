// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/layouts/tablereading.h"

namespace palmer {

/// Reads the columns that say machine, serial number, operator, day, plane or feed of each line. One value is
/// a statement about the test; several are several tests, and a question which of them to read. Asks for
/// temperatures that differ too much for one test, too.
void takeConditions(TableReading &reading, const std::vector<ImportColumn> &columns, bool asks,
                    LineConditions &result);

} // namespace palmer
