// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/files.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <filesystem>
#include <io.h>
#include <windows.h>

namespace palmer {

namespace {

/// With the prefix that lifts the limit of 260 characters.
std::wstring longName(const QString &path) {
    const QString native = QDir::toNativeSeparators(path);
    const bool isShare = native.startsWith(QLatin1StringView("\\\\"));
    return ((isShare ? QStringLiteral("\\\\?\\UNC\\") + native.mid(2) : QStringLiteral("\\\\?\\") + native))
        .toStdWString();
}

bool move(const QString &from, const QString &to) {
    return ::MoveFileExW(longName(from).c_str(), longName(to).c_str(),
                         MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH) != 0;
}

} // namespace

bool mayBeListed(const QString &folder) {
    std::error_code error;
    const std::filesystem::directory_iterator entries(folder.toStdWString(), error);
    return !error;
}

bool isOnDisk(int file) {
    return ::_commit(file) == 0;
}

void syncFolderOf(const QString &) {} // a moved file is written through

DeviceFault writeDevice(const QByteArray &bytes, const QString &path, bool) {
    QFile device(path);
    if (device.open(QIODevice::WriteOnly | QIODevice::Unbuffered) && device.write(bytes) == bytes.size())
        return DeviceFault::none;
    return device.error() == QFileDevice::ResourceError ? DeviceFault::full : DeviceFault::refused;
}

namespace {

class FileOnDisk : public StagedFile {
public:
    FileOnDisk(const QByteArray &bytes, const QString &path)
        : m_path(linkTarget(path))
        , m_beside(nameWhileSaving(m_path)) {
        const QFileInfo old(m_path);
        m_wasThere = old.exists();
        if (m_wasThere && !old.isWritable())
            return;
        // A file that a killed program left there is overwritten.
        QFile file(m_beside);
        m_named = file.open(QIODevice::WriteOnly | QIODevice::Truncate | QIODevice::Unbuffered);
        m_complete = m_named && file.write(bytes) == bytes.size() && isOnDisk(file.handle());
        file.close();
        if (!m_complete)
            forget();
    }
    ~FileOnDisk() override { forget(); }
    FileOnDisk(const FileOnDisk &) = delete;
    FileOnDisk &operator=(const FileOnDisk &) = delete;

    [[nodiscard]] bool isComplete() const override { return m_complete; }

    [[nodiscard]] bool takeName(bool keepOld) override {
        m_keepsOld = keepOld && m_wasThere &&
                     ::ReplaceFileW(longName(m_path).c_str(), longName(m_beside).c_str(),
                                    longName(oldName()).c_str(), 0, nullptr, nullptr) != 0;
        m_named = !m_keepsOld && !move(m_beside, m_path);
        return !m_named;
    }

    void restore() override {
        if (!m_wasThere)
            QFile::remove(m_path);
        else if (m_keepsOld)
            m_keepsOld = !move(oldName(), m_path);
    }

private:
    [[nodiscard]] QString oldName() const { return m_beside + QStringLiteral("old"); }

    void forget() {
        if (m_named)
            QFile::remove(m_beside);
        if (m_keepsOld)
            QFile::remove(oldName());
        m_named = m_keepsOld = false;
    }

    QString m_path;
    QString m_beside;
    bool m_complete = false;
    bool m_named = false; ///< there is a file m_beside
    bool m_wasThere = false;
    bool m_keepsOld = false; ///< it has its old name
};

} // namespace

std::unique_ptr<StagedFile> stageFile(const QByteArray &bytes, const QString &path) {
    return std::make_unique<FileOnDisk>(bytes, path);
}

} // namespace palmer
