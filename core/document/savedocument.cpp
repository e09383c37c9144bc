// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/savedocument.h"

#include "document/bounds.h"
#include "document/readdocument.h"
#include "document/readprogress.h"
#include "document/savefiles.h"
#include "document/writedocument.h"
#include "system/filename.h"

#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <filesystem>
#include <system_error>

namespace palmer {

namespace {

constexpr qint64 mebibyte = qint64(1) << 20;

[[noreturn]] void refuse(Error::Kind kind, Text text) {
    throw Error(kind, {text, {}, {}});
}

[[noreturn]] void refuseReading() {
    refuse(Error::Kind::unreadable,
           REPORT_TEXT("report", "the file cannot be read; check its permissions and the medium it is on"));
}

/// Returns whole mebibytes, as limits are stated.
Number mebibytes(qint64 bytes) {
    const qint64 whole = bytes / mebibyte;
    return {static_cast<double>(whole), Quantity::count, 0};
}

} // namespace

void saveBytes(const QByteArray &bytes, const QString &path) {
    saveFiles({{bytes, path}});
}

QByteArray bytesToSave(const Document &document) {
    requireBounds(document);
    QByteArray bytes = writeDocument(document);
    if (bytes.size() > largestFile)
        throw Error(
            Error::Kind::tooLarge,
            {REPORT_TEXT("report", "the test file would be larger than %1 MiB and could not be opened "
                                   "again; divide its tests between several files"),
             {mebibytes(largestFile)}});
    return bytes;
}

void saveDocument(const Document &document, const QString &path) {
    saveBytes(bytesToSave(document), path);
}

void requireReadable(qint64 size, qint64 limit) {
    if (size > limit)
        throw Error(Error::Kind::tooLarge,
                    {REPORT_TEXT("report", "the file is larger than %1 MiB"), {mebibytes(limit)}});
}

namespace {

/// Reads in blocks to report progress.
QByteArray readBlocks(const QString &path, qint64 limit, ReadProgress *progress,
                      const std::stop_token &stop) {
    const ReachableFile there(path);
    const QFileInfo info(there.name());
    if (info.isDir())
        refuse(Error::Kind::unreadable, REPORT_TEXT("report", "this is a folder; expected a test file"));
    if (!info.exists()) {
        std::error_code error;
        if (std::filesystem::status(pathOf(there.name()), error).type() ==
            std::filesystem::file_type::not_found)
            refuse(Error::Kind::unreadable, REPORT_TEXT("report", "there is no such file"));
        refuseReading(); // its folder cannot be entered
    }
    if (!info.isFile()) // opening a pipe blocks until there is a writer; a device may have no end
        refuse(Error::Kind::unreadable,
               REPORT_TEXT("report", "this is a device or a pipe; expected a file on a disk"));
    requireReadable(info.size(), limit);
    QFile file(there.name());
    if (!file.open(QIODevice::ReadOnly | QIODevice::Unbuffered))
        refuseReading();
    // Read only as much as the size says: generated files (/proc) report 0 and may never end.
    const qint64 size = file.size();
    const qint64 block = progress ? mebibyte : size;
    if (progress) {
        progress->unit = ReadProgress::Unit::bytes;
        progress->done = 0;
        progress->of = size;
    }
    QByteArray bytes(size, Qt::Uninitialized);
    qint64 done = 0;
    while (done < size && !stop.stop_requested()) {
        const qint64 read = file.read(bytes.data() + done, std::min(block, size - done));
        if (read <= 0)
            break; // the file has become shorter, or an error
        done += read;
        if (progress)
            progress->done = done;
    }
    bytes.truncate(done);
    requireReadable(file.size(), limit);
    if (file.error() != QFileDevice::NoError)
        refuseReading();
    return bytes;
}

} // namespace

QByteArray readBytes(const QString &path, qint64 limit) {
    return readBlocks(path, limit, nullptr, {});
}

QByteArray readBytes(const QString &path, ReadProgress &progress, const std::stop_token &stop) {
    return readBlocks(path, largestFile, &progress, stop);
}

Document openDocument(const QString &path) {
    return readDocument(readBytes(path));
}

} // namespace palmer
