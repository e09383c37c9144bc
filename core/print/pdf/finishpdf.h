// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "proof/reportmetadata.h"

#include <QByteArray>
#include <QRectF>
#include <QString>
#include <future>
#include <vector>

namespace palmer {

/// A file inside a PDF.
struct PdfAttachment {
    QString name;
    QByteArray mimeType;
    const char *relationship = nullptr; ///< "/Source", "/Data"
    QString description;
    qsizetype size = 0;                    ///< bytes
    std::shared_future<QByteArray> packed; ///< see packed()
};

/// What FlateDecode unpacks to these bytes. Of many it is made on a thread, beside what is done until it is
/// asked for: of 10⁶ readings that takes 0.15 s, as long as the pages.
[[nodiscard]] std::shared_future<QByteArray> packed(const QByteArray &bytes);

/// The top of what is shown there.
struct PdfPlace {
    int page = 0; ///< from 0
    double y = 0; ///< points from the top
};

/// Level 0 or, below the last one of level 0, level 1.
struct PdfBookmark {
    int level = 0;
    QString title;
    PdfPlace target;
};

struct PdfLink {
    int page = 0;
    QRectF area; ///< points from the top left corner
    PdfPlace target;
};

/// What a PDF says about itself, and what it carries beside its pages.
struct PdfProperties {
    ReportMetadata metadata;
    QByteArray xmp; ///< the packet that states them
    std::vector<PdfAttachment> attachments;
    std::vector<PdfBookmark> bookmarks;
    std::vector<PdfLink> links;
};

/// Takes out of a PDF what comes from the clock and the machine it was written on, and puts in what the
/// report says: the same pages and properties give the same bytes. With an output intent in `pdf` the result
/// is a PDF/A-3b. Throws std::runtime_error when `pdf` is no PDF.
[[nodiscard]] QByteArray finishPdf(const QByteArray &pdf, const PdfProperties &properties);

} // namespace palmer
