// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/parts/testpart.h"

namespace palmer {

/// Adds the instruments of all tests with their traceability.
void addTraceability(std::vector<Block> &blocks, const Writer &write, const EvaluatedDocument &evaluated);

/// Adds the drift tests of the file with their ranges.
void addDriftTests(std::vector<Block> &blocks, const Writer &write, const EvaluatedDocument &evaluated);

/// Adds the statements that ISO/IEC 17025, 7.8 requires, the program and the full fingerprint; `foreign`:
/// characters of the report that its font lacks. `level` of the heading: 1 if the sections above belong to a
/// test.
void addStatements(std::vector<Block> &blocks, const Writer &write, const Document &document,
                   const Making &making, const QString &fingerprint, const QString &foreign, int level);

/// States what the results relate to, and that the report is reproduced only in full.
[[nodiscard]] QString scopeText(const Writer &write);

/// Adds the person responsible for the report: name, date and signature on one line.
void addResponsibility(std::vector<Block> &blocks, const Writer &write, const ReportHead &head);

/// Adds the signatures and the end of the report.
void addSignatures(std::vector<Block> &blocks, const Writer &write, const ReportHead &head);

} // namespace palmer
