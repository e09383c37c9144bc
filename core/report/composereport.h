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
    bool annex = true;         ///< false: without the annex, whatever the file says
    /// Receives the blocks of the first page as soon as they are there, which takes a fraction of the time;
    /// of long tables only the rows that a page may hold. Not called for a report of drift tests alone.
    std::function<void(const Report &)> onFirstPage = {};
};

/// Composes the printed report of a document in one language: a certificate and an annex. Certificate of one
/// test: head, verdict, figure, results, conditions, agreed points, instruments, findings of the text,
/// remarks, statements (ISO/IEC 17025, 7.8) and signatures. An acceptance sheet comes first, with the verdict
/// on sheet and tests. Of several: a summary, a page per test with head, verdict, figure and results, then
/// the common statements. Annex, with a head of its own: values and readings, uncertainty, limits, editions
/// side by side, findings of practice, laboratory and program, of each test without page breaks; at the end
/// the program. Pure: the same document always gives the same
/// report, under any locale. Drift tests are listed but have no page. Throws Error like writeDocument(),
/// since the report contains the fingerprint of its test file.
[[nodiscard]] Report composeReport(const EvaluatedDocument &given, const Language &language,
                                   const ReportOptions &options = {});

/// Short results of all tests for a terminal: for each test head, results with their limits, statistics per
/// target, verdict in its two parts, findings.
[[nodiscard]] Report composeResults(const EvaluatedDocument &evaluated, const Language &language);

/// Only the findings of all tests, with the accordance of each test with its edition.
[[nodiscard]] Report composeFindings(const EvaluatedDocument &evaluated, const Language &language);

} // namespace palmer
