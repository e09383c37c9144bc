// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "language/language.h"
#include "report/attachedfile.h"
#include "report/blocks/report.h"

namespace palmer {

/// What the report says of the program that made it.
struct ReportOptions {
    QString program;                         ///< "Palmer 0.1.0"
    std::optional<bool> selfTestPassed = {}; ///< of this process; null: not run
    Originals originals = Originals::leaveOut;
    QByteArray testFile = {}; ///< that the document was read from, byte for byte; empty: as it would be saved
};

/// The printed report of a document in one language: of one test head, figure, results, verdict, conditions,
/// points agreed, uncertainty, findings, limits, values and readings; of several a summary, of each test a
/// page with head, figure, results and verdict, then once what all of them state (conditions, points agreed,
/// limits, before and after, editions), and behind that the rest of each without a page of its own. At the
/// end traceability, statements (ISO/IEC 17025, 7.8), remarks and signatures. Pure: the same document gives
/// the same report at any time and under any locale. Drift tests are listed, they have no page. Throws Error
/// as writeDocument does, since the report carries the fingerprint of its test file.
[[nodiscard]] Report composeReport(const EvaluatedDocument &evaluated, const Language &language,
                                   const ReportOptions &options = {});

} // namespace palmer
