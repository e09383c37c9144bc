// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/savefiles.h"

#include "document/filename.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <QStorageInfo>
#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <memory>
#include <unistd.h>

namespace palmer {

namespace {

[[noreturn]] void refuseFiles(Text text) {
    throw Error(Error::Kind::unwritable, {text, {}, {}});
}

// The system's message may be in another language, so determine the cause here.
[[noreturn]] void refuseSaving(const QString &path, qint64 size) {
    const QFileInfo info(path);
    const QStorageInfo disk(info.absolutePath());
    if (disk.isValid() && disk.isReadOnly())
        refuseFiles(REPORT_TEXT("report", "the disk is read-only; save in a folder of another disk"));
    if (disk.isValid() && disk.bytesAvailable() < size)
        refuseFiles(REPORT_TEXT("report",
                                "the disk is full; what was there before is unchanged: free some space or "
                                "save on another disk"));
    refuseFiles(REPORT_TEXT(
        "report", "the file could not be saved, for want of permission or space; what was there before "
                  "is unchanged: save it under another name or in another folder"));
}

/// A file descriptor closed automatically.
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

/// Opens a device or a pipe. Opening a pipe blocks until it has a reader, unless that is refused.
int openDevice(const QByteArray &name, UnreadPipe unread) {
    const int nonBlocking = unread == UnreadPipe::refused ? O_NONBLOCK : 0;
    int device = -1;
    do {
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): POSIX
        device = ::open(name.constData(), O_WRONLY | O_CLOEXEC | nonBlocking);
    } while (device < 0 && errno == EINTR);
    if (device >= 0 && nonBlocking != 0)
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): POSIX
        ::fcntl(device, F_SETFL, ::fcntl(device, F_GETFL) & ~O_NONBLOCK);
    return device;
}

[[noreturn]] void refuseDevice(int cause) {
    if (cause == ENOSPC)
        refuseFiles(REPORT_TEXT("report", "the device is full; save to a file or to another device"));
    if (cause == ENXIO || cause == EPIPE)
        refuseFiles(
            REPORT_TEXT("report", "nobody reads from this pipe; start its reader first, or save to a file"));
    refuseFiles(REPORT_TEXT(
        "report", "the device could not be written, for want of permission or because it is none that "
                  "takes a file; save to a file"));
}

void writeDevice(const QByteArray &bytes, const QString &path, UnreadPipe unread) {
    const Descriptor device(openDevice(QFile::encodeName(path), unread));
    if (device.number() < 0)
        refuseDevice(errno);
    for (qsizetype at = 0; at < bytes.size();) {
        const auto written =
            ::write(device.number(), bytes.constData() + at, static_cast<std::size_t>(bytes.size() - at));
        if (written < 0 && errno != EINTR)
            refuseDevice(errno);
        at += std::max<qsizetype>(written, 0);
    }
}

/// True if all data are on the disk. Some file systems cannot tell.
bool isOnDisk(int descriptor) {
    return ::fsync(descriptor) == 0 || errno == EINVAL || errno == ENOTSUP;
}

/// Makes the new name durable. Without it a power cut would restore the old file, but never lose both.
void syncFolder(const QString &path) {
    const QByteArray folder = QFile::encodeName(QFileInfo(path).absolutePath());
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): POSIX
    const Descriptor directory(::open(folder.constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (directory.number() >= 0)
        ::fsync(directory.number());
}

/// Checks what can be seen without writing.
void requirePlace(const QString &path) {
    if (!isUtf8FileName(path))
        refuseFiles(
            REPORT_TEXT("report", "a name to save to has to be UTF-8, and this one is not; choose another"));
    const QFileInfo info(path);
    if (info.isDir())
        refuseFiles(REPORT_TEXT("report", "this is a folder; expected the name of a file to save to"));
    if (!info.absoluteDir().exists())
        refuseFiles(REPORT_TEXT("report", "the folder does not exist; create it or save in another folder"));
}

/// True for a device, which renaming would replace.
bool isDevice(const QString &path) {
    const QFileInfo info(path);
    return info.exists() && !info.isFile();
}

/// A temporary file next to its destination, flushed to disk; removed unless renamed.
class Staged {
public:
    explicit Staged(const FileToSave &file)
        : m_source(file)
        , m_file(file.path) {
        // Unbuffered: commit() does not detect that the last buffer could not be written.
        if (!m_file.open(QIODevice::WriteOnly | QIODevice::Unbuffered) ||
            m_file.write(file.bytes) != file.bytes.size() || m_file.size() != file.bytes.size() ||
            !isOnDisk(m_file.handle()))
            refuseSaving(file.path, file.bytes.size());
    }

    /// If further files are to be renamed, keeps a link to the existing file to restore it.
    void rename(bool keepOld) {
        const QByteArray path = encoded(m_source.path);
        m_wasThere = ::access(path.constData(), F_OK) == 0;
        if (keepOld && m_wasThere) {
            const QByteArray old =
                encoded(m_file.fileName() + QStringLiteral(".old-") + QString::number(::getpid()));
            if (::link(path.constData(), old.constData()) == 0)
                m_old = old;
        }
        if (!m_file.commit()) {
            forgetOld();
            refuseSaving(m_source.path, m_source.bytes.size());
        }
    }
    void restore() {
        const QByteArray path = encoded(m_source.path);
        if (!m_wasThere)
            ::unlink(path.constData());
        else if (!m_old.isEmpty())
            ::rename(m_old.constData(), path.constData());
        m_old.clear();
    }
    void forgetOld() {
        if (!m_old.isEmpty())
            ::unlink(m_old.constData());
        m_old.clear();
    }

    [[nodiscard]] const QString &path() const { return m_source.path; }

private:
    /// Encodes the path, with links resolved.
    static QByteArray encoded(const QString &path) {
        const QString target = QFileInfo(path).canonicalFilePath();
        return QFile::encodeName(target.isEmpty() ? path : target);
    }

    const FileToSave &m_source;
    QSaveFile m_file;
    bool m_wasThere = false;
    QByteArray m_old;
};

/// Runs `work` for one file and adds its name to errors.
void forFile(const QString &path, auto &&work) {
    try {
        work();
    } catch (const Error &error) {
        throw UnsavedFile(error, path);
    }
}

void renameAll(std::vector<std::unique_ptr<Staged>> &staged) {
    for (std::size_t i = 0; i < staged.size(); ++i) {
        const bool last = i + 1 == staged.size();
        try {
            forFile(staged[i]->path(), [&] { staged[i]->rename(!last); });
        } catch (const UnsavedFile &) {
            for (std::size_t done = 0; done < i; ++done)
                staged[done]->restore();
            throw;
        }
    }
    for (const auto &file : staged) {
        file->forgetOld();
        syncFolder(file->path());
    }
}

} // namespace

void saveFiles(const std::vector<FileToSave> &files, UnreadPipe unread) {
    for (const FileToSave &file : files)
        forFile(file.path, [&] { requirePlace(file.path); });
    std::vector<std::unique_ptr<Staged>> staged;
    for (const FileToSave &file : files) {
        if (!isDevice(file.path))
            forFile(file.path, [&] { staged.push_back(std::make_unique<Staged>(file)); });
    }
    for (const FileToSave &file : files) {
        if (isDevice(file.path))
            forFile(file.path, [&] { writeDevice(file.bytes, file.path, unread); });
    }
    renameAll(staged);
}

} // namespace palmer
