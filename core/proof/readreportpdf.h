// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/documenterror.h"
#include "proof/pdfparts.h"
#include "proof/reportmetadata.h"

#include <QByteArray>
#include <QByteArrayView>
#include <QRectF>
#include <QString>
#include <QStringList>
#include <vector>

namespace palmer {

/// Area of a signature on a page, points from its top left corner.
struct SignatureField {
    int page = 1; ///< from 1
    QRectF area;
};

/// The parts of a report of this program: its last revision, if something was appended.
struct ReportPdf {
    ReportMetadata metadata; ///< as read by readXmp()
    QByteArray testFile;     ///< or the data of a printed history
    QString testFileName;
    bool isHistory = false; ///< carries history.json instead of a test file
    QByteArray results;     ///< results.json; may be empty
    QByteArray certificate; ///< dcc.xml; may be empty
    std::vector<PdfAddition> additions;
    std::vector<SignatureField> signatureFields; ///< visible ones
    QStringList beside;                          ///< shown besides the pages: titles, author, bookmarks
};

/// Most bytes that the streams of a PDF may unpack to in total.
inline constexpr qint64 mostUnpacked = qint64(1) << 29;

/// True if the bytes begin like a PDF.
[[nodiscard]] bool isPdf(QByteArrayView bytes);

/// True for a PDF of another program: readable, but not marked as made by Palmer.
[[nodiscard]] bool isForeignPdf(const QByteArray &pdf);

/// Attachments that a PDF of Palmer has to carry.
enum class Carried { testFile, testFileOrHistory };

/// Takes a report apart, with bounded memory for any input. Throws Error if the PDF is damaged, encrypted,
/// too large (mostUnpacked), not made by Palmer, or does not have exactly one such file.
[[nodiscard]] ReportPdf readReportPdf(const QByteArray &pdf, Carried carried = Carried::testFile);

} // namespace palmer
