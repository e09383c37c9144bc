// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/savefiles.h"

#include "document/filename.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStorageInfo>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <memory>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace palmer {

namespace {

QByteArray encoded(const QString &path) {
    return QFile::encodeName(path);
}

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
    Descriptor(Descriptor &&other) noexcept
        : m_number(std::exchange(other.m_number, -1)) {}
    Descriptor &operator=(Descriptor &&other) noexcept {
        std::swap(m_number, other.m_number);
        return *this;
    }

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

/// False with errno if not all could be written.
bool writeAll(const QByteArray &bytes, const Descriptor &file) {
    for (qsizetype at = 0; at < bytes.size();) {
        const auto written =
            ::write(file.number(), bytes.constData() + at, static_cast<std::size_t>(bytes.size() - at));
        if (written < 0 && errno != EINTR)
            return false;
        at += std::max<qsizetype>(written, 0);
    }
    return true;
}

void writeDevice(const QByteArray &bytes, const QString &path, UnreadPipe unread) {
    const Descriptor device(openDevice(encoded(path), unread));
    if (device.number() < 0)
        refuseDevice(errno);
    if (!writeAll(bytes, device))
        refuseDevice(errno);
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

/// Removes a file that nobody else knows; tries again, as it would stay for ever.
void removeFile(const QString &path) {
    for (int attempt = 0; attempt < 2 && ::unlink(encoded(path).constData()) != 0 && errno != ENOENT;)
        ++attempt;
}

/// A file on the disk, without a name until it is renamed; where the file system knows no such files, with
/// one beside its destination. Not QSaveFile, whose names stay for ever if the program is killed.
class Staged {
public:
    explicit Staged(const FileToSave &file)
        : m_source(file)
        , m_path(targetOf(file.path))
        , m_beside(nameWhileSaving(m_path))
        , m_file(withoutName(m_path)) {
        if (m_file.number() < 0) {
            m_beside += QString::number(::getpid());
            const QByteArray name = encoded(m_beside);
            // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): POSIX
            const int made = ::open(name.constData(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, readAndWrite);
            m_file = Descriptor(made);
            m_named = m_file.number() >= 0;
        }
        struct stat old {};
        m_wasThere = ::stat(encoded(m_path).constData(), &old) == 0;
        const bool mayReplace = !m_wasThere || ::access(encoded(m_path).constData(), W_OK) == 0;
        if (m_file.number() < 0 || !mayReplace || !writeAll(file.bytes, m_file) ||
            (m_wasThere && ::fchmod(m_file.number(), old.st_mode & permissions) != 0) ||
            !isOnDisk(m_file.number())) {
            forget();
            refuseSaving(file.path, file.bytes.size());
        }
    }
    ~Staged() { forget(); }
    Staged(const Staged &) = delete;
    Staged &operator=(const Staged &) = delete;

    /// If further files are to be renamed, keeps the existing file, if the file system exchanges names.
    void rename(bool keepOld) {
        m_keepsOld = keepOld && m_wasThere && takeName() &&
                     ::renameat2(AT_FDCWD, encoded(m_beside).constData(), AT_FDCWD,
                                 encoded(m_path).constData(), RENAME_EXCHANGE) == 0;
        if (!m_keepsOld && !replace())
            refuseSaving(m_source.path, m_source.bytes.size());
    }
    void restore() {
        if (!m_wasThere)
            removeFile(m_path);
        else if (m_keepsOld)
            m_named = ::rename(encoded(m_beside).constData(), encoded(m_path).constData()) != 0;
    }

    [[nodiscard]] const QString &path() const { return m_source.path; }

private:
    static constexpr mode_t permissions = 07777;
    static constexpr mode_t readAndWrite = 0666; ///< less the user's mask

    /// The absolute path with links resolved.
    static QString targetOf(const QString &path) {
        const QString target = QFileInfo(path).canonicalFilePath();
        return target.isEmpty() ? QFileInfo(path).absoluteFilePath() : target;
    }
    static Descriptor withoutName(const QString &path) {
        if (::access("/proc/self/fd", X_OK) != 0) // through which it gets a name
            return Descriptor(-1);
        const QByteArray folder = encoded(QFileInfo(path).absolutePath());
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): POSIX
        return Descriptor(::open(folder.constData(), O_RDWR | O_TMPFILE | O_CLOEXEC, readAndWrite));
    }
    [[nodiscard]] bool link(const QString &name) const {
        const QByteArray file = "/proc/self/fd/" + QByteArray::number(m_file.number());
        return ::linkat(AT_FDCWD, file.constData(), AT_FDCWD, encoded(name).constData(), AT_SYMLINK_FOLLOW) ==
               0;
    }
    /// Takes the name beside the destination, in place of what a program that was killed left there.
    bool takeName() {
        m_named = m_named || link(m_beside);
        if (!m_named && errno == EEXIST) {
            removeFile(m_beside);
            m_named = link(m_beside);
        }
        return m_named;
    }
    [[nodiscard]] bool replace() {
        if (!m_named && !m_wasThere && link(m_path))
            return true;
        // Another program that saves to the same place may take the name in between: whole, so again.
        for (int attempt = 0; attempt < 3 && takeName(); ++attempt) {
            m_named = ::rename(encoded(m_beside).constData(), encoded(m_path).constData()) != 0;
            if (!m_named)
                return true;
            if (errno != ENOENT)
                return false;
            m_named = false;
        }
        return false;
    }
    void forget() {
        if (m_named)
            removeFile(m_beside);
        m_named = false;
    }

    const FileToSave &m_source;
    QString m_path;
    QString m_beside;
    Descriptor m_file;
    bool m_named = false; ///< there is a file m_beside
    bool m_wasThere = false;
    bool m_keepsOld = false; ///< which is what was there
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
    for (const auto &file : staged)
        syncFolder(file->path());
}

} // namespace

QString nameWhileSaving(const QString &path) {
    const QFileInfo file(path);
    return file.absolutePath() + QStringLiteral("/.") + file.fileName() + QStringLiteral(".saving~");
}

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
