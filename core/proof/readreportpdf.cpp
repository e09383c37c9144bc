// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/readreportpdf.h"

#include "document/savedocument.h"
#include "document/testfile.h"
#include "proof/pdfparts.h"
#include "report/attachedfile.h"

namespace palmer {

namespace {

[[noreturn]] void refuse(Error::Kind kind, Text text, std::vector<Argument> arguments = {}) {
    throw Error(kind, {text, std::move(arguments), {}});
}

[[noreturn]] void refuseDamaged() {
    refuse(
        Error::Kind::syntax,
        REPORT_TEXT("report", "this PDF is damaged and cannot be read; ask for it again where it came from"));
}

[[noreturn]] void refuseForeign() {
    refuse(Error::Kind::content,
           REPORT_TEXT("report",
                       "this PDF is no report of Palmer with its test file inside: there is nothing "
                       "to open or to verify"));
}

/// Null if damaged.
std::optional<PdfParts> partsOf(const QByteArray &pdf) {
    bool exceeded = false;
    try {
        return pdfParts(pdf.constData(), static_cast<std::size_t>(pdf.size()), mostUnpacked, exceeded);
    } catch (const Error &) { // not the fault of the PDF
        throw;
    } catch (const std::exception &) {
        if (exceeded)
            refuse(Error::Kind::tooLarge,
                   REPORT_TEXT("report", "this PDF unpacks to more than %1 MiB and is not read"),
                   {wholeNumber(mostUnpacked >> 20)});
        return {};
    }
}

/// Sorts the embedded files into `result`; returns the number of test files.
int sortFiles(ReportPdf &result, const std::vector<EmbeddedFile> &files) {
    int testFiles = 0;
    for (const EmbeddedFile &file : files) {
        const QString name = QString::fromStdString(file.name);
        const QByteArray bytes = QByteArray::fromStdString(file.bytes);
        if (isTestFileName(name) || name == historyFileName) {
            result.testFile = bytes;
            result.testFileName = name;
            result.isHistory = name == historyFileName;
            ++testFiles;
        } else if (name == QLatin1StringView("results.json") && result.results.isEmpty()) {
            result.results = bytes;
        } else if (name == QLatin1StringView("dcc.xml") && result.certificate.isEmpty()) {
            result.certificate = bytes;
        } else {
            result.additions.push_back({PdfAddition::Kind::attachment, 0, file.name});
        }
    }
    return testFiles;
}

} // namespace

bool isPdf(QByteArrayView bytes) {
    return bytes.startsWith("%PDF-");
}

bool isForeignPdf(const QByteArray &pdf) {
    requireReadable(pdf.size());
    const std::optional<PdfParts> parts = partsOf(pdf);
    return parts && !parts->encrypted && !readXmp(QByteArray::fromStdString(parts->xmp));
}

ReportPdf readReportPdf(const QByteArray &pdf, Carried carried) {
    requireReadable(pdf.size());
    const std::optional<PdfParts> parts = partsOf(pdf);
    if (!parts)
        refuseDamaged();
    if (parts->encrypted)
        refuse(Error::Kind::content,
               REPORT_TEXT("report", "this PDF is encrypted; save it without password and open that"));
    ReportPdf result;
    const auto metadata = readXmp(QByteArray::fromStdString(parts->xmp));
    const int testFiles = sortFiles(result, parts->files);
    if (!metadata || testFiles == 0)
        refuseForeign();
    if (result.isHistory && carried == Carried::testFile)
        refuse(Error::Kind::content,
               REPORT_TEXT("report",
                           "this PDF is the history of a machine: it carries the values of its tests and "
                           "no test file; verify it, or open the tests it names"));
    if (testFiles > 1)
        refuse(Error::Kind::content,
               REPORT_TEXT("report", "this PDF carries more than one test file, and which of them the report "
                                     "was made from is not known"));
    result.metadata = *metadata;
    result.additions.insert(result.additions.end(), parts->additions.begin(), parts->additions.end());
    result.beside << metadata->title << metadata->author;
    for (const std::string &text : parts->beside)
        result.beside << QString::fromStdString(text);
    for (const PdfField &field : parts->signatureFields)
        result.signatureFields.push_back(
            {field.page, QRectF(QPointF(field.left, field.top), QPointF(field.right, field.bottom))});
    return result;
}

} // namespace palmer
