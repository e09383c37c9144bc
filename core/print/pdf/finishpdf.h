// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/pdf/structure.h"
#include "proof/reportmetadata.h"

#include <QByteArray>
#include <QIODevice>
#include <QRectF>
#include <QString>
#include <future>
#include <vector>

namespace palmer {

/// A file embedded in a PDF.
struct PdfAttachment {
    QString name;
    QByteArray mimeType;
    const char *relationship = nullptr; ///< "/Source", "/Data"
    QString description;
    qsizetype size = 0;                    ///< bytes
    std::shared_future<QByteArray> packed; ///< see packed()
};

/// Compresses the bytes for FlateDecode. 40 MB of readings with all digits: zlib's default level 12.7 MB
/// in 1.25 s, libdeflate's fastest, taken above 4 MB, 13.3 MB in 0.15 s. Shorter ones become as small as with
/// zlib, but faster.
[[nodiscard]] QByteArray pack(const QByteArray &bytes);

/// The same; large data are compressed on a thread until the result is needed.
[[nodiscard]] std::shared_future<QByteArray> packed(const QByteArray &bytes);

/// Top edge of a destination.
struct PdfPlace {
    int page = 0; ///< from 0
    double y = 0; ///< points from the top
};

/// Level 0, or level 1 below the last bookmark of level 0.
struct PdfBookmark {
    int level = 0;
    QString title;
    PdfPlace target;
};

struct PdfLink {
    int page = 0;
    QRectF area; ///< points from the top left corner
    PdfPlace target;
    QString title;                ///< of the target
    Structure::Index element = 0; ///< of `PdfProperties::structure`
};

/// Metadata and embedded content of a PDF.
struct PdfProperties {
    ReportMetadata metadata;
    QByteArray xmp; ///< packet with the metadata
    std::vector<PdfAttachment> attachments;
    std::vector<PdfBookmark> bookmarks;
    std::vector<PdfLink> links;
    Structure structure; ///< of what was drawn
    QByteArray (*pack)(const QByteArray &) =
        palmer::pack; ///< the program's: libqpdf is loaded without libdeflate
};

/// Outcome of finishPdf().
enum class FinishedPdf { complete, refused, tooLarge };

/// Copies a PDF that Qt wrote without anything that depends on the clock or machine, and adds the properties:
/// the same pages and properties give the same bytes. With an output intent in `drawn` the result is a
/// PDF/A-3a and a PDF/UA-1. Page after page and object after object are read and written, so that little
/// memory is needed. Returns `refused` if `to` does not accept all bytes, `tooLarge` for more than 4 GB.
/// Throws std::runtime_error if `drawn`, which can be read anywhere, is no PDF.
[[nodiscard]] FinishedPdf finishPdf(QIODevice &drawn, const PdfProperties &properties, QIODevice &to);

} // namespace palmer
