// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/files.h"

#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace palmer {

namespace {

QByteArray encoded(const QString &path) {
    return QFile::encodeName(path);
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
int openDevice(const QByteArray &name, bool awaitsReader) {
    const int nonBlocking = awaitsReader ? 0 : O_NONBLOCK;
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

DeviceFault faultOf(int cause) {
    if (cause == ENOSPC)
        return DeviceFault::full;
    return cause == ENXIO || cause == EPIPE ? DeviceFault::unread : DeviceFault::refused;
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

/// Removes a file that nobody else knows; tries again, as it would stay for ever.
void removeFile(const QString &path) {
    for (int attempt = 0; attempt < 2 && ::unlink(encoded(path).constData()) != 0 && errno != ENOENT;)
        ++attempt;
}

} // namespace

bool mayBeListed(const QString &folder) {
    return ::faccessat(AT_FDCWD, encoded(folder).constData(), R_OK | X_OK, AT_EACCESS) == 0;
}

bool isOnDisk(int file) {
    return ::fsync(file) == 0 || errno == EINVAL || errno == ENOTSUP;
}

void syncFolderOf(const QString &path) {
    const QByteArray folder = encoded(QFileInfo(path).absolutePath());
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): POSIX
    const Descriptor directory(::open(folder.constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (directory.number() >= 0)
        ::fsync(directory.number());
}

DeviceFault writeDevice(const QByteArray &bytes, const QString &path, bool awaitsReader) {
    const Descriptor device(openDevice(encoded(path), awaitsReader));
    return device.number() >= 0 && writeAll(bytes, device) ? DeviceFault::none : faultOf(errno);
}

namespace {

class FileOnDisk : public StagedFile {
public:
    FileOnDisk(const QByteArray &bytes, const QString &path)
        : m_path(linkTarget(path))
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
        m_complete = m_file.number() >= 0 && mayReplace && writeAll(bytes, m_file) &&
                     (!m_wasThere || ::fchmod(m_file.number(), old.st_mode & permissions) == 0) &&
                     isOnDisk(m_file.number());
        if (!m_complete)
            forget();
    }
    ~FileOnDisk() override { forget(); }
    FileOnDisk(const FileOnDisk &) = delete;
    FileOnDisk &operator=(const FileOnDisk &) = delete;

    [[nodiscard]] bool isComplete() const override { return m_complete; }

    [[nodiscard]] bool takeName(bool keepOld) override {
        m_keepsOld = keepOld && m_wasThere && takeNameBeside() &&
                     ::renameat2(AT_FDCWD, encoded(m_beside).constData(), AT_FDCWD,
                                 encoded(m_path).constData(), RENAME_EXCHANGE) == 0;
        return m_keepsOld || replace();
    }

    void restore() override {
        if (!m_wasThere)
            removeFile(m_path);
        else if (m_keepsOld)
            m_named = ::rename(encoded(m_beside).constData(), encoded(m_path).constData()) != 0;
    }

private:
    static constexpr mode_t permissions = 07777;
    static constexpr mode_t readAndWrite = 0666; ///< less the user's mask

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
    bool takeNameBeside() {
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
        for (int attempt = 0; attempt < 3 && takeNameBeside(); ++attempt) {
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

    QString m_path;
    QString m_beside;
    Descriptor m_file;
    bool m_complete = false;
    bool m_named = false; ///< there is a file m_beside
    bool m_wasThere = false;
    bool m_keepsOld = false; ///< which is what was there
};

} // namespace

std::unique_ptr<StagedFile> stageFile(const QByteArray &bytes, const QString &path) {
    return std::make_unique<FileOnDisk>(bytes, path);
}

} // namespace palmer
