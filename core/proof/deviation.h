// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/documenterror.h"
#include "proof/readreportpdf.h"
#include "proof/verification.h"

namespace palmer {

// What may be wrong with a report beside its words and results, each as one difference.

[[nodiscard]] Difference differenceOf(const PdfAddition &addition);
[[nodiscard]] Difference otherPageCount(int printed, int follows);
[[nodiscard]] Difference otherPageSize(int page);
/// The words of the page are the same, and it looks otherwise: in `area`, where these words stand.
[[nodiscard]] Difference drawnOtherwise(int page, const QRectF &area, const QString &words);
/// A signature that is seen hides words.
[[nodiscard]] Difference coveredBySignature(int page, const QRectF &area, const QString &words);
[[nodiscard]] Difference brokenSignature(const QString &signer);
[[nodiscard]] Difference otherFileName(const QString &name);
/// A title, the author or a bookmark.
[[nodiscard]] Difference otherBeside(const QString &shown);

/// For pages that no reader can show.
[[nodiscard]] inline Error unreadablePages() {
    return {
        Error::Kind::syntax,
        {REPORT_TEXT("report", "the pages of this PDF cannot be read; ask for it again where it came from"),
         {},
         {}}};
}

/// For pages that draw more than `operators`, which is more than a report does.
[[nodiscard]] inline Error tooMuchDrawn(qint64 operators) {
    return {
        Error::Kind::syntax,
        {REPORT_TEXT("report",
                     "the pages of this PDF have more than %1 drawing operators: too long to verify here"),
         {Number{static_cast<double>(operators), Quantity::count, 0}},
         {}}};
}

} // namespace palmer
