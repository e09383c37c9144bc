// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/files.h"

#include "system/filename.h"

#include <QFileInfo>

namespace palmer {

bool isSameFile(const QString &path, const QString &other) {
    const std::filesystem::path one = pathOf(path);
    std::error_code error;
    return std::filesystem::is_regular_file(one, error) &&
           std::filesystem::equivalent(one, pathOf(other), error);
}

QString linkTarget(const QString &path) {
    const QString target = QFileInfo(path).canonicalFilePath();
    return target.isEmpty() ? QFileInfo(path).absoluteFilePath() : target;
}

QString nameWhileSaving(const QString &path) {
    const QFileInfo file(path);
    return file.absolutePath() + QStringLiteral("/.") + file.fileName() + QStringLiteral(".saving~");
}

} // namespace palmer
