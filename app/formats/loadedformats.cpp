// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/documenterror.h"
#include "formats/formats.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QLibrary>
#include <string_view>

namespace palmer {

namespace {

/// Null if the library is missing, has another version or lacks its dependencies.
const Formats *formatsIn(const QString &file) {
    QLibrary library(QCoreApplication::applicationDirPath() + u'/' + file);
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): a name of a library
    const auto function = reinterpret_cast<decltype(&palmerFormats)>(library.resolve("palmerFormats"));
    const bool ours = function && std::string_view(function()->version) == PALMER_VERSION;
    return ours ? function() : nullptr;
}

const Formats *loaded() {
    static const Formats *const found = formatsIn(QStringLiteral(PALMER_FORMATS));
    return found;
}

const Formats &formats(Error::Kind kind, const Formats *found = loaded()) {
    if (found)
        return *found;
    throw Error(
        kind,
        {REPORT_TEXT("report", "Palmer is installed without its library for PDF files and workbooks, or with "
                               "that of another version: install it again")});
}

} // namespace

/// Qt's slower implementation hashes a small file before the library is loaded, and any without it, because
/// this must not fail.
std::string sha256(QByteArrayView bytes) {
    constexpr qsizetype small = 1 << 20;
    if (bytes.size() > small && loaded())
        return loaded()->sha256(bytes);
    return QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex().toStdString();
}

std::unique_ptr<ZipFile> openZip(QByteArrayView bytes) {
    return formats(Error::Kind::unreadable).openZip(bytes);
}

PdfParts pdfParts(const char *bytes, std::size_t size, std::int64_t most, bool &exceeded) {
    return formats(Error::Kind::unreadable).pdfParts(bytes, size, most, exceeded);
}

FinishedPdf finishPdf(QIODevice &drawn, const PdfProperties &properties, QIODevice &to) {
    return formats(Error::Kind::unwritable).finishPdf(drawn, properties, to);
}

std::unique_ptr<PdfPages> openPages(const QByteArray &pdf) {
    static const Formats *const pages = formatsIn(QStringLiteral(PALMER_PAGES));
    return formats(Error::Kind::unreadable, pages).openPages(pdf);
}

} // namespace palmer
