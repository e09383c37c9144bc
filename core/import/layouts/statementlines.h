// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tables/table.h"

namespace palmer {

/// Makes comments of what stands above the first table and an empty line apart from it, where it says nothing
/// of columns: "Air temperature; 20.1; 20.3", "Travel; 0; 500", "Machine: DMU 50". Notes are read from it,
/// and it decides no layout. Headings, also of blocks titled by direction, axis or state, are left.
void setStatementsAside(CellTable &table);

} // namespace palmer
