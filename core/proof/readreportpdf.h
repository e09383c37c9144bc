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

/// The place of a signature on a page, points from its top left corner.
struct SignatureField {
    int page = 1; ///< from 1
    QRectF area;
};

/// A report of this program, taken apart: its last revision, if something was appended.
struct ReportPdf {
    ReportMetadata metadata; ///< as readXmp has it
    QByteArray testFile;
    QString testFileName;
    QByteArray results; ///< results.json; empty: none
    std::vector<PdfAddition> additions;
    std::vector<SignatureField> signatureFields; ///< those that are seen
    QStringList beside; ///< what readers show beside the pages: titles, author, bookmarks
};

/// Largest sum of what the streams of a PDF unpack to, bytes.
inline constexpr qint64 mostUnpacked = qint64(1) << 29;

/// Whether the bytes begin as a PDF does.
[[nodiscard]] bool isPdf(QByteArrayView bytes);

/// Whether this is a PDF of another program: it can be read, and nothing in it says that Palmer made it.
[[nodiscard]] bool isForeignPdf(const QByteArray &pdf);

/// Takes a report apart; bounded in memory, whatever the bytes say. Throws Error with one sentence: damaged,
/// encrypted, too large (mostUnpacked), not made by Palmer, without its test file, with more than one.
[[nodiscard]] ReportPdf readReportPdf(const QByteArray &pdf);

} // namespace palmer
