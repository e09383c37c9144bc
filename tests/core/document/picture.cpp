// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/picture.h"

#include <QTest>
#include <QtEndian>

using namespace palmer;

namespace {

QByteArray number(quint32 value) {
    QByteArray bytes(4, '\0');
    qToBigEndian(value, bytes.data());
    return bytes;
}

/// CRC-32 of ISO 3309, bit by bit.
quint32 checkSum(const QByteArray &bytes) {
    quint32 sum = 0xffffffff;
    for (const char byte : bytes) {
        sum ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit)
            sum = sum >> 1U ^ ((sum & 1U) != 0 ? 0xedb88320U : 0U);
    }
    return ~sum;
}

QByteArray part(const QByteArray &name, const QByteArray &data) {
    return number(static_cast<quint32>(data.size())) + name + data + number(checkSum(name + data));
}

QByteArray head(quint32 width, quint32 height) {
    return part("IHDR", number(width) + number(height) + QByteArray("\x08\x00\x00\x00\x00", 5));
}

/// Grey pixels: a filter byte before each line.
QByteArray pixels(quint32 width, quint32 height) {
    const QByteArray lines(static_cast<qsizetype>(height * (width + 1)), '\0');
    return part("IDAT", qCompress(lines).mid(4));
}

const QByteArray signature("\x89PNG\r\n\x1a\n", 8);

QByteArray png(quint32 width, quint32 height) {
    return signature + head(width, height) + pixels(width, height) + part("IEND", {});
}

} // namespace

/// What a report can carry as a picture.
class PictureTest : public QObject {
    Q_OBJECT

private slots:
    void aPngIsWhole() {
        QVERIFY(isPicture(png(1, 1)));
        QVERIFY(isPicture(png(300, 2)));
        QVERIFY(!isPicture(png(0, 1)));
        QVERIFY(!isPicture(png(1, 0)));
        QVERIFY(!isPicture(signature + head(1, 1) + part("IEND", {})));
        QVERIFY(!isPicture(signature + pixels(1, 1) + part("IEND", {})));
        QVERIFY(!isPicture(signature + head(1, 1) + pixels(1, 1)));
        QVERIFY(!isPicture(signature + head(1, 1) + part("IDAT", "no zlib") + part("IEND", {})));
        QVERIFY(isPicture(signature + head(1, 1) + part("tEXt", "note") + pixels(1, 1) + part("IEND", {})));
        QVERIFY(!isPicture({}));
    }

    /// Each cut is seen, and each byte that was changed behind the signature.
    void damageIsSeen() {
        const QByteArray whole = png(3, 3);
        for (qsizetype length = 0; length < whole.size(); ++length)
            QVERIFY2(!isPicture(whole.first(length)), QByteArray::number(length));
        for (qsizetype at = 0; at < whole.size(); ++at) {
            QByteArray damaged = whole;
            damaged[at] = static_cast<char>(damaged[at] ^ 1);
            QVERIFY2(!isPicture(damaged), QByteArray::number(at));
        }
    }

    void anSvgIsXmlWithThatRoot() {
        QVERIFY(isPicture("<svg xmlns=\"http://www.w3.org/2000/svg\"/>"));
        QVERIFY(isPicture(
            "<?xml version=\"1.0\"?><!-- logo --><svg xmlns=\"http://www.w3.org/2000/svg\"><g/></svg>"));
        QVERIFY(!isPicture("<svg><g></svg>"));
        QVERIFY(!isPicture("<svg>"));
        QVERIFY(!isPicture("<html/>"));
        QVERIFY(!isPicture("svg"));
    }
};

QTEST_GUILESS_MAIN(PictureTest)
#include "picture.moc"
