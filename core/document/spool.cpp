// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/spool.h"

#include "document/documenterror.h"

#include <QTemporaryFile>
#include <utility>

namespace palmer {

Spool::Spool() {
    open(QIODevice::WriteOnly | QIODevice::Unbuffered);
}

Spool::~Spool() = default;

qint64 Spool::readData(char *, qint64) {
    return -1;
}

qint64 Spool::writeData(const char *bytes, qint64 size) {
    constexpr qsizetype most = qsizetype(1) << 20U;
    if (m_file)
        return writeToFile(bytes, size) ? size : -1;
    m_memory.append(bytes, size);
    if (m_memory.size() <= most || m_noFile)
        return size;
    m_file = std::make_unique<QTemporaryFile>();
    if (!m_file->open()) {
        m_file.reset();
        m_noFile = true;
        return size;
    }
    const QByteArray begin = std::exchange(m_memory, {});
    return writeToFile(begin.constData(), begin.size()) ? size : -1;
}

bool Spool::writeToFile(const char *bytes, qint64 size) {
    return m_file->write(bytes, size) == size;
}

QByteArray Spool::bytes() {
    if (!m_file)
        return m_memory;
    if (!m_file->flush())
        throw Error(Error::Kind::unwritable,
                    {REPORT_TEXT(
                        "report",
                        "the file could not be saved, for want of permission or space; what was there before "
                        "is unchanged: save it under another name or in another folder")});
    const qint64 size = m_file->size();
    if (const uchar *mapped = m_file->map(0, size))
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes
        return QByteArray::fromRawData(reinterpret_cast<const char *>(mapped), size);
    m_file->seek(0);
    return m_file->readAll();
}

} // namespace palmer
