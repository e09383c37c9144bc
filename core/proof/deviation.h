// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/documenterror.h"
#include "proof/readreportpdf.h"
#include "proof/verification.h"

namespace palmer {

// Faults of a report other than in its words and results, each as one difference.

/// For an attached digital calibration certificate that does not follow from the data.
[[nodiscard]] Difference otherCertificate();

[[nodiscard]] Difference differenceOf(const PdfAddition &addition);
[[nodiscard]] Difference otherPageCount(int printed, int follows);
[[nodiscard]] Difference otherPageSize(int page);
/// The words of the page are equal but it looks different in `area`, which contains `words`.
[[nodiscard]] Difference drawnOtherwise(int page, const QRectF &area, const QString &words);
/// A visible signature hides words.
[[nodiscard]] Difference coveredBySignature(int page, const QRectF &area, const QString &words);
[[nodiscard]] Difference brokenSignature(const QString &signer);
[[nodiscard]] Difference otherFileName(const QString &name);
/// A title, the author or a bookmark differs.
[[nodiscard]] Difference otherBeside(const QString &shown);

/// For pages that cannot be read.
[[nodiscard]] inline Error unreadablePages() {
    return {
        Error::Kind::syntax,
        {REPORT_TEXT("report", "the pages of this PDF cannot be read; ask for it again where it came from"),
         {},
         {}}};
}

/// For pages with more than `operators` drawing operators, more than a report has.
[[nodiscard]] inline Error tooMuchDrawn(qint64 operators) {
    return {
        Error::Kind::syntax,
        {REPORT_TEXT("report",
                     "the pages of this PDF have more than %1 drawing operators: too long to verify here"),
         {wholeNumber(operators)},
         {}}};
}

} // namespace palmer
