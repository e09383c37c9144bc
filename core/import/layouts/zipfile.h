// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QByteArrayView>
#include <QString>
#include <memory>

namespace palmer {

/// A ZIP archive in memory, read only.
class ZipFile {
public:
    virtual ~ZipFile() = default;
    ZipFile(const ZipFile &) = delete;
    ZipFile &operator=(const ZipFile &) = delete;

    /// Names are compared as those of workbooks are: without regard to case, and to which slash was written.
    [[nodiscard]] virtual bool contains(const QString &name) const = 0;
    /// The bytes of a member; empty where there is none. Throws Error(tooLarge) before more than 256 MiB or
    /// more than a thousand times its compressed size are unpacked; all members together stay below 512 MiB.
    [[nodiscard]] virtual QByteArray member(const QString &name) = 0;

protected:
    ZipFile() = default;
};

/// By libzip. The bytes have to live as long. Throws Error(content) for what is no archive or is damaged.
[[nodiscard]] std::unique_ptr<ZipFile> openZip(QByteArrayView bytes);

} // namespace palmer
