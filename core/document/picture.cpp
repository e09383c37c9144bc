// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/picture.h"

#include <QXmlStreamReader>
#include <QtEndian>

namespace palmer {

namespace {

/// CRC-32 of ISO 3309, as in PNG.
quint32 checkSum(QByteArrayView bytes) {
    constexpr quint32 polynomial = 0xEDB88320;
    quint32 sum = ~quint32(0);
    for (const char byte : bytes) {
        sum ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit)
            sum = (sum >> 1) ^ ((sum & 1) != 0 ? polynomial : 0);
    }
    return ~sum;
}

quint32 numberAt(QByteArrayView bytes, qsizetype at) {
    return qFromBigEndian<quint32>(bytes.data() + at);
}

/// True if data begin with a zlib header (two bytes).
bool isZlib(QByteArrayView data) {
    if (data.size() < 2)
        return false;
    const int method = static_cast<unsigned char>(data[0]);
    const int flags = static_cast<unsigned char>(data[1]);
    return (method & 0x0F) == 8 && (256 * method + flags) % 31 == 0;
}

bool isWholePng(QByteArrayView bytes) {
    constexpr qsizetype signature = 8;
    constexpr qsizetype frame = 12; // length, name, check sum
    bool hasHead = false;
    bool hasPixels = false;
    for (qsizetype at = signature; bytes.size() - at >= frame;) {
        const quint32 length = numberAt(bytes, at);
        if (length > bytes.size() - at - frame)
            return false;
        const QByteArrayView part = bytes.sliced(at + 4, 4 + qsizetype(length));
        if (checkSum(part) != numberAt(bytes, at + 8 + qsizetype(length)))
            return false;
        const QByteArrayView name = part.first(4);
        const QByteArrayView data = part.sliced(4);
        if (name == "IHDR")
            hasHead = data.size() == 13 && numberAt(data, 0) > 0 && numberAt(data, 4) > 0;
        if (name == "IDAT" && !hasPixels) {
            if (!isZlib(data))
                return false;
            hasPixels = true;
        }
        if (name == "IEND")
            return hasHead && hasPixels;
        at += frame + qsizetype(length);
    }
    return false;
}

bool isSvg(const QByteArray &bytes) {
    QXmlStreamReader xml(bytes);
    if (!xml.readNextStartElement() || xml.name() != QLatin1StringView("svg"))
        return false;
    while (!xml.atEnd())
        xml.readNext();
    return !xml.hasError();
}

} // namespace

bool isPicture(const QByteArray &bytes) {
    if (bytes.startsWith("\x1f\x8b")) // a compressed SVG
        return true;
    return bytes.startsWith("\x89PNG\r\n\x1a\n") ? isWholePng(bytes) : isSvg(bytes);
}

} // namespace palmer
