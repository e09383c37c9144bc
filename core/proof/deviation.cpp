// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/deviation.h"

namespace palmer {

namespace {

Difference said(int page, Text what, const QString &context = {}, std::vector<Argument> arguments = {},
                const QRectF &area = {}) {
    return {page, area, {}, {}, context, Message{what, std::move(arguments)}};
}

} // namespace

Difference differenceOf(const PdfAddition &addition) {
    return said(addition.page,
                inOrder(addition.kind,
                        {REPORT_TEXT("report",
                                     "the PDF does something that a report does not (action, layer, script)"),
                         REPORT_TEXT("report", "a form field was put on the page"),
                         REPORT_TEXT("report", "a file was attached that the report did not carry"),
                         REPORT_TEXT("report", "an annotation was put on the page")}),
                QString::fromStdString(addition.name));
}

Difference otherPageCount(int printed, int follows) {
    return said(0, REPORT_TEXT("report", "pages of the PDF: %1; pages that follow from the data: %2"), {},
                {wholeNumber(printed), wholeNumber(follows)});
}

Difference otherPageSize(int page) {
    return said(page, REPORT_TEXT("report", "the page has another size, or not all of it is shown"));
}

Difference drawnOtherwise(int page, const QRectF &area, const QString &words) {
    return said(page, REPORT_TEXT("report", "the page is drawn otherwise than it follows from the data"),
                words, {}, area);
}

Difference coveredBySignature(int page, const QRectF &area, const QString &words) {
    return said(page, REPORT_TEXT("report", "a signature covers what is printed"), words, {}, area);
}

Difference brokenSignature(const QString &signer) {
    return said(0, REPORT_TEXT("report", "a signature is not valid: the file was changed after it"), signer);
}

Difference otherFileName(const QString &name) {
    return said(0, REPORT_TEXT("report", "the attached test file has another name"), name);
}

Difference otherCertificate() {
    return said(0, REPORT_TEXT("report", "the digital calibration certificate in the PDF is not the one that "
                                         "follows from the data"));
}

Difference otherBeside(const QString &shown) {
    return said(0,
                REPORT_TEXT("report", "title, author, bookmarks or texts for screen readers in the PDF are "
                                      "not those that follow from the data"),
                shown);
}

} // namespace palmer
