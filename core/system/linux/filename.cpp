// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/filename.h"

#include <fcntl.h>
#include <unistd.h>

namespace palmer {

std::filesystem::path pathOf(const QString &name) {
    return nativeFileName(name).toStdString();
}

QString fileNameOf(const std::filesystem::path &path) {
    return fileNameOf(QByteArrayView(path.native()));
}

ReachableFile::ReachableFile(const QString &name)
    : m_name(name) {
    if (isUtf8FileName(name))
        return;
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): so POSIX declares it
    m_descriptor = ::open(nativeFileName(name).constData(), O_PATH | O_CLOEXEC);
    if (m_descriptor >= 0)
        m_name = QStringLiteral("/proc/self/fd/%1").arg(m_descriptor);
}

ReachableFile::~ReachableFile() {
    if (m_descriptor >= 0)
        ::close(m_descriptor);
}

} // namespace palmer
