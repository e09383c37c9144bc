// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/filename.h"

#include <QStringDecoder>
#include <algorithm>

namespace palmer {

namespace {

constexpr char16_t firstHalf = 0xDC80; ///< stands for the byte 0x80
constexpr char16_t lastHalf = 0xDCFF;
constexpr char16_t shift = 0xDC00;

/// True if the position holds a byte, not the second half of a surrogate pair.
bool isByte(const QString &name, qsizetype at) {
    const char16_t unit = name[at].unicode();
    return unit >= firstHalf && unit <= lastHalf && (at == 0 || !name[at - 1].isHighSurrogate());
}

bool isUtf8(QByteArrayView bytes) {
    QStringDecoder decoder(QStringDecoder::Utf8, QStringDecoder::Flag::Stateless);
    const QString text = decoder(bytes);
    return !decoder.hasError();
}

/// Returns the length in bytes of the UTF-8 character at the start; 0 if there is none.
qsizetype firstCharacter(QByteArrayView bytes) {
    constexpr qsizetype longest = 4;
    for (qsizetype length = 1; length <= std::min(longest, bytes.size()); ++length) {
        if (isUtf8(bytes.first(length)))
            return length;
    }
    return 0;
}

} // namespace

QString fileNameOf(QByteArrayView bytes) {
    if (isUtf8(bytes))
        return QString::fromUtf8(bytes);
    QString name;
    for (qsizetype at = 0; at < bytes.size();) {
        const qsizetype length = firstCharacter(bytes.sliced(at));
        if (length > 0)
            name += QString::fromUtf8(bytes.sliced(at, length));
        else
            name += QChar(static_cast<char16_t>(shift + static_cast<unsigned char>(bytes[at])));
        at += std::max<qsizetype>(length, 1);
    }
    return name;
}

QByteArray nativeFileName(const QString &name) {
    if (isUtf8FileName(name))
        return name.toUtf8();
    QByteArray bytes;
    QString text;
    for (qsizetype at = 0; at < name.size(); ++at) {
        if (!isByte(name, at)) {
            text += name[at];
            continue;
        }
        bytes += text.toUtf8();
        bytes += static_cast<char>(name[at].unicode() - shift);
        text.clear();
    }
    return bytes + text.toUtf8();
}

bool isUtf8FileName(const QString &name) {
    for (qsizetype at = 0; at < name.size(); ++at) {
        if (isByte(name, at))
            return false;
    }
    return true;
}

QString shownFileName(QString name) {
    if (isUtf8FileName(name))
        return name;
    for (qsizetype at = 0; at < name.size(); ++at) {
        if (isByte(name, at))
            name[at] = QChar(static_cast<char16_t>(name[at].unicode() - shift));
    }
    return name;
}

} // namespace palmer
