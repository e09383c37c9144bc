// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QByteArrayView>
#include <QString>
#include <filesystem>

namespace palmer {

// On Linux, file names are bytes, usually UTF-8, but Latin-1 on old disks. In a QString an invalid byte is an
// unpaired surrogate, U+DC80 … U+DCFF: the file can be found again, and no other file has this name. On
// Windows they are UTF-16.

/// Returns the name for these bytes.
[[nodiscard]] QString fileNameOf(QByteArrayView bytes);

/// Returns the bytes of a name.
[[nodiscard]] QByteArray nativeFileName(const QString &name);

/// True if the whole name is UTF-8.
[[nodiscard]] bool isUtf8FileName(const QString &name);

/// Returns the name for display and for storing in files, with invalid bytes as Latin-1.
[[nodiscard]] QString shownFileName(QString name);

/// The same name for the standard library.
[[nodiscard]] std::filesystem::path pathOf(const QString &name);
[[nodiscard]] QString fileNameOf(const std::filesystem::path &path);

/// A name by which Qt finds the file during the object's lifetime: the name itself if it is UTF-8.
class ReachableFile {
public:
    explicit ReachableFile(const QString &name);
    ~ReachableFile();
    ReachableFile(const ReachableFile &) = delete;
    ReachableFile &operator=(const ReachableFile &) = delete;

    [[nodiscard]] const QString &name() const { return m_name; }

private:
    QString m_name;
    int m_descriptor = -1;
};

} // namespace palmer
