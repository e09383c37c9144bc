#include "document/savedocument.h"

#include "document/bounds.h"
#include "document/readdocument.h"
#include "document/writedocument.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <QStorageInfo>
#include <QThread>
#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace palmer {

namespace {

constexpr qint64 mebibyte = qint64(1) << 20;

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

/// A descriptor that closes itself.
class Descriptor {
public:
    explicit Descriptor(int number)
        : m_number(number) {}
    ~Descriptor() {
        if (m_number >= 0)
            ::close(m_number);
    }
    Descriptor(const Descriptor &) = delete;
    Descriptor &operator=(const Descriptor &) = delete;

    [[nodiscard]] int number() const { return m_number; }

private:
    int m_number;
};

/// Opens a device or a pipe. Opening a pipe waits for who reads it, and might do so for ever.
int openDevice(const QByteArray &name) {
    constexpr int attempts = 200;
    for (int attempt = 0; attempt < attempts; ++attempt) {
        const int device = ::open(name.constData(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
        if (device >= 0) {
            ::fcntl(device, F_SETFL, ::fcntl(device, F_GETFL) & ~O_NONBLOCK);
            return device;
        }
        if (errno != ENXIO && errno != EINTR)
            return -1;
        QThread::msleep(10);
    }
    return -1;
}

bool writeDevice(const QByteArray &bytes, const QString &path) {
    const Descriptor device(openDevice(QFile::encodeName(path)));
    if (device.number() < 0)
        return false;
    for (qsizetype at = 0; at < bytes.size();) {
        const auto written =
            ::write(device.number(), bytes.constData() + at, static_cast<std::size_t>(bytes.size() - at));
        if (written < 0 && errno != EINTR)
            return false;
        at += std::max<qsizetype>(written, 0);
    }
    return true;
}

/// Whether all is on the disk. Some file systems cannot tell.
bool isOnDisk(int descriptor) {
    return ::fsync(descriptor) == 0 || errno == EINVAL || errno == ENOTSUP;
}

/// The folder knows of the new name; a power cut would bring back the old file, which is no loss of both.
void syncFolder(const QString &path) {
    const QByteArray folder = QFile::encodeName(QFileInfo(path).absolutePath());
    const Descriptor directory(::open(folder.constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (directory.number() >= 0)
        ::fsync(directory.number());
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
        if (!writeDevice(bytes, path))
            refuseSaving(path, bytes.size());
        return;
    }
    QSaveFile file(path);
    // Unbuffered: commit() does not see that the last of a buffer could not be written.
    if (!file.open(QIODevice::WriteOnly | QIODevice::Unbuffered) || file.write(bytes) != bytes.size() ||
        file.size() != bytes.size() || !isOnDisk(file.handle()) || !file.commit())
        refuseSaving(path, bytes.size());
    syncFolder(path);
}

QByteArray bytesToSave(const Document &document) {
    demandBounds(document);
    const QByteArray bytes = writeDocument(document);
    if (bytes.size() > largestFile)
        throw Error(
            Error::Kind::tooLarge,
            {REPORT_TEXT("report", "the test file would be larger than %1 MiB and could not be opened "
                                   "again; divide its tests between several files"),
             {Number{static_cast<double>(largestFile / mebibyte), Quantity::count, 0}}});
    return bytes;
}

void saveDocument(const Document &document, const QString &path) {
    saveBytes(bytesToSave(document), path);
}

void demandReadable(qint64 size, qint64 limit) {
    if (size > limit)
        throw Error(Error::Kind::tooLarge,
                    {REPORT_TEXT("report", "the file is larger than %1 MiB"),
                     {Number{static_cast<double>(limit / mebibyte), Quantity::count, 0}}});
}

QByteArray readBytes(const QString &path, qint64 limit) {
    const QFileInfo info(path);
    if (info.isDir())
        refuse(Error::Kind::unreadable, REPORT_TEXT("report", "this is a folder; expected a test file"));
    if (!info.exists())
        refuse(Error::Kind::unreadable, REPORT_TEXT("report", "there is no such file"));
    if (!info.isFile()) // to open a pipe waits for who writes it, a device may have no end
        refuse(Error::Kind::unreadable,
               REPORT_TEXT("report", "this is a device or a pipe; expected a file on a disk"));
    demandReadable(info.size(), limit);
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly | QIODevice::Unbuffered))
        refuseReading();
    // As long as it says it is: what the system makes up while it is read (/proc) says 0 and may never end.
    const QByteArray bytes = file.read(file.size());
    demandReadable(file.size(), limit);
    if (file.error() != QFileDevice::NoError)
        refuseReading();
    return bytes;
}

bool isSameFile(const QString &path, const QString &other) {
    struct stat one {};
    struct stat two {};
    return ::stat(QFile::encodeName(path).constData(), &one) == 0 &&
           ::stat(QFile::encodeName(other).constData(), &two) == 0 && S_ISREG(one.st_mode) &&
           one.st_dev == two.st_dev && one.st_ino == two.st_ino;
}

Document openDocument(const QString &path) {
    return readDocument(readBytes(path));
}

} // namespace palmer
