// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QByteArrayView>
#include <QString>

namespace palmer {

/// A ZIP archive in memory, read only. The bytes have to live as long.
class ZipFile {
public:
    /// Throws Error(content) for what is no archive or is damaged.
    explicit ZipFile(QByteArrayView bytes);
    ~ZipFile();
    ZipFile(const ZipFile &) = delete;
    ZipFile &operator=(const ZipFile &) = delete;

    /// Names are compared as those of workbooks are: without regard to case, and to which slash was written.
    [[nodiscard]] bool contains(const QString &name) const;
    /// The bytes of a member; empty where there is none. Throws Error(tooLarge) before more than 256 MiB or
    /// more than a thousand times its compressed size are unpacked; all members together stay below 512 MiB.
    [[nodiscard]] QByteArray member(const QString &name);

private:
    [[nodiscard]] qint64 find(const QString &name) const; ///< below 0: there is none

    void *m_archive = nullptr;
    qint64 m_unpacked = 0;
};

} // namespace palmer
