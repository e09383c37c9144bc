// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "language/language.h"
#include "report/attachedfile.h"
#include "report/blocks/report.h"

#include <stop_token>

namespace palmer {

/// Statements of the report about the program that made it.
struct ReportOptions {
    QString program;                         ///< "Palmer 0.1.0"
    std::optional<bool> selfTestPassed = {}; ///< of this process; null: not run
    Originals originals = Originals::leaveOut;
    QByteArray testFile = {};  ///< source file, byte for byte; empty: as the document would be saved
    std::stop_token stop = {}; ///< if stop is requested, the report lacks tests
};

/// Composes the printed report of a document in one language. For one test: head, verdict, figure, results,
/// conditions, agreed points, uncertainty, findings, limits, values and readings. An acceptance sheet comes
/// first, with the verdict on sheet and tests. For several: a summary, a page per test with head, verdict,
/// figure and results, then the common statements (conditions, agreed points, limits, before and after,
/// editions), then the remaining sections of each test without page breaks. At the end traceability,
/// statements (ISO/IEC 17025, 7.8), remarks and signatures. Pure: the same document always gives the same
/// report, under any locale. Drift tests are listed but have no page. Throws Error like writeDocument(),
/// since the report contains the fingerprint of its test file.
[[nodiscard]] Report composeReport(const EvaluatedDocument &evaluated, const Language &language,
                                   const ReportOptions &options = {});

/// Short results of all tests for a terminal: for each test head, results with their limits, statistics per
/// target, verdict in its two parts, findings.
[[nodiscard]] Report composeResults(const EvaluatedDocument &evaluated, const Language &language);

/// Only the findings of all tests, with the accordance of each test with its edition.
[[nodiscard]] Report composeFindings(const EvaluatedDocument &evaluated, const Language &language);

} // namespace palmer
