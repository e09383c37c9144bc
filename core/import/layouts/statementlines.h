// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tables/table.h"

namespace palmer {

/// Makes comments of the lines above the first table and an empty line if they do not describe columns: "Air
/// temperature; 20.1; 20.3", "Travel; 0; 500", "Machine: DMU 50". They are read as notes and do not affect
/// the layout. Headings are kept, including blocks titled by direction, axis or state.
void setStatementsAside(CellTable &table);

} // namespace palmer
