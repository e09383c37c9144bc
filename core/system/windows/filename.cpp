// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/filename.h"

namespace palmer {

std::filesystem::path pathOf(const QString &name) {
    return name.toStdWString();
}

QString fileNameOf(const std::filesystem::path &path) {
    return QString::fromStdWString(path.native());
}

ReachableFile::ReachableFile(const QString &name)
    : m_name(name) {}

ReachableFile::~ReachableFile() = default;

} // namespace palmer
