// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QByteArrayView>
#include <QString>

namespace palmer {

// The system's names of files are bytes, which are UTF-8 but on old disks (Latin-1). In a QString a byte that
// is none stands as half a pair, U+DC80 … U+DCFF: such a file can be found again, and no other has this name.

/// The name of these bytes.
[[nodiscard]] QString fileNameOf(QByteArrayView bytes);

/// The bytes of the name.
[[nodiscard]] QByteArray nativeFileName(const QString &name);

/// Whether all of the name is UTF-8.
[[nodiscard]] bool isUtf8FileName(const QString &name);

/// The name as people read it, its other bytes as Latin-1: what is printed, and kept in files.
[[nodiscard]] QString shownFileName(QString name);

/// A name that Qt finds the file under, for as long as this lives: the name itself where it is UTF-8.
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
