#include "document/savedocument.h"

#include "document/bounds.h"
#include "document/readdocument.h"
#include "document/writedocument.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <QStorageInfo>

namespace palmer {

namespace {

constexpr qint64 sizeLimit = qint64(1) << 30;

[[noreturn]] void refuse(Error::Kind kind, Text text) {
    throw Error(kind, {text, {}, {}});
}

// The system's own words would be in another language than the rest, so the cause is looked for anew.
[[noreturn]] void refuseSaving(const QString &path, qint64 size) {
    const QFileInfo info(path);
    const QStorageInfo disk(info.absolutePath());
    if (disk.isValid() && disk.isReadOnly())
        refuse(Error::Kind::unwritable,
               REPORT_TEXT("report", "the disk is read-only; save in a folder of another disk"));
    if ((info.exists() && !info.isFile()) || (disk.isValid() && disk.bytesAvailable() < size))
        refuse(Error::Kind::unwritable,
               REPORT_TEXT("report",
                           "the disk is full; what was there before is unchanged: free some space or "
                           "save on another disk"));
    refuse(Error::Kind::unwritable,
           REPORT_TEXT("report",
                       "the file could not be saved, for want of permission or space; what was there before "
                       "is unchanged: save it under another name or in another folder"));
}

[[noreturn]] void refuseReading() {
    refuse(Error::Kind::unreadable,
           REPORT_TEXT("report", "the file cannot be read; check its permissions and the medium it is on"));
}

} // namespace

void saveBytes(const QByteArray &bytes, const QString &path) {
    const QFileInfo info(path);
    if (info.isDir())
        refuse(Error::Kind::unwritable,
               REPORT_TEXT("report", "this is a folder; expected the name of a file to save to"));
    if (!info.absoluteDir().exists())
        refuse(Error::Kind::unwritable,
               REPORT_TEXT("report", "the folder does not exist; create it or save in another folder"));
    if (info.exists() && !info.isFile()) {
        // Renaming would replace the device itself.
        QFile device(path);
        if (!device.open(QIODevice::WriteOnly) || device.write(bytes) != bytes.size() || !device.flush())
            refuseSaving(path, bytes.size());
        return;
    }
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.commit())
        refuseSaving(path, bytes.size());
}

void saveDocument(const Document &document, const QString &path) {
    demandBounds(document);
    saveBytes(writeDocument(document), path);
}

QByteArray readBytes(const QString &path) {
    const QFileInfo info(path);
    if (info.isDir())
        refuse(Error::Kind::unreadable, REPORT_TEXT("report", "this is a folder; expected a test file"));
    if (!info.exists())
        refuse(Error::Kind::unreadable, REPORT_TEXT("report", "there is no such file"));
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        refuseReading();
    const auto demandSize = [](qint64 size) {
        if (size > sizeLimit)
            refuse(Error::Kind::tooLarge, REPORT_TEXT("report", "the file is larger than 1 GiB"));
    };
    demandSize(file.size());
    QByteArray bytes;
    bytes.reserve(static_cast<qsizetype>(file.size()));
    // Pipes do not tell their size, and files may grow: read no further than the limit.
    constexpr qint64 blockSize = qint64(1) << 24;
    for (QByteArray block = file.read(blockSize); !block.isEmpty(); block = file.read(blockSize)) {
        bytes += block;
        demandSize(bytes.size());
    }
    if (file.error() != QFileDevice::NoError)
        refuseReading();
    return bytes;
}

Document openDocument(const QString &path) {
    return readDocument(readBytes(path));
}

} // namespace palmer
