// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/parts/testpart.h"

namespace palmer {

/// The instruments of all tests with what makes them traceable.
void addTraceability(std::vector<Block> &blocks, const Writer &write, const EvaluatedDocument &evaluated);

/// The drift tests of the file with their range.
void addDriftTests(std::vector<Block> &blocks, const Writer &write, const EvaluatedDocument &evaluated);

/// What ISO/IEC 17025, 7.8 asks a report to state, the program and the fingerprint in full; `foreign`: which
/// characters of the report its font lacks. `level` is that of the heading: 1 where the sections above are
/// those of a test.
void addStatements(std::vector<Block> &blocks, const Writer &write, const Document &document,
                   const Making &making, const QString &fingerprint, const QString &foreign, int level);

/// What the results relate to, and that the report is reproduced only in full.
[[nodiscard]] QString scopeText(const Writer &write);

/// Who answers for the report: name, date and signature on one line.
void addResponsibility(std::vector<Block> &blocks, const Writer &write, const ReportHead &head);

/// Those who sign, and the end of the report.
void addSignatures(std::vector<Block> &blocks, const Writer &write, const ReportHead &head);

} // namespace palmer
