// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/reportmetadata.h"

#include "language/language.h"

#include <QTest>
#include <QXmlStreamReader>
#include <random>

using namespace palmer;

namespace {

ReportMetadata example() {
    ReportMetadata result;
    result.title = QStringLiteral("Réception n° 12 <X & Y> \"é\"");
    result.author = QStringLiteral("Laboratoire d'essais");
    result.language = QStringLiteral("fr");
    result.date = QStringLiteral("2026-03-05");
    result.making = {QStringLiteral("Palmer 1.2.3"), true, {1, 3, 12}};
    return result;
}

/// The text of the first element of this name; null: there is none, or this is no XML.
std::optional<QString> element(const QByteArray &packet, const QString &name) {
    QXmlStreamReader xml(packet);
    std::optional<QString> found;
    while (!xml.atEnd()) {
        if (xml.readNext() == QXmlStreamReader::StartElement && xml.name() == name && !found)
            found = xml.readElementText(QXmlStreamReader::IncludeChildElements).trimmed();
    }
    return xml.hasError() ? std::nullopt : found;
}

} // namespace

class ReportMetadataTest : public QObject {
    Q_OBJECT

private slots:
    void howAReportWasMadeComesBack() {
        for (const char *language : {"en", "fr"}) {
            for (const std::optional<bool> passed :
                 {std::optional<bool>(), std::optional<bool>(true), std::optional<bool>(false)}) {
                for (const std::vector<int> &simulated : {std::vector<int>(), {1}, {2, 3, 400}}) {
                    ReportMetadata metadata = example();
                    metadata.language = QString::fromLatin1(language);
                    metadata.making.selfTestPassed = passed;
                    metadata.making.simulated = simulated;
                    metadata.making.edition =
                        simulated.size() == 1 ? QStringLiteral("ISO 230-2:1997") : QString();
                    metadata.making.annex = simulated.size() != 3;
                    const auto read = readXmp(xmpPacket(metadata));
                    QVERIFY(read);
                    QCOMPARE(read->language, metadata.language);
                    QVERIFY(read->making == metadata.making);
                }
            }
        }
    }

    void whatEveryReaderShows() {
        const QByteArray packet = xmpPacket(example());
        QCOMPARE(element(packet, "title"), example().title);
        QCOMPARE(element(packet, "creator"), example().author);
        QCOMPARE(element(packet, "part"), QStringLiteral("3"));
        QCOMPARE(element(packet, "conformance"), QStringLiteral("A"));
        QCOMPARE(element(packet, "CreateDate"), QStringLiteral("2026-03-05T00:00:00Z"));
        QCOMPARE(packet, xmpPacket(example())); // nothing of the clock
        ReportMetadata bare;
        bare.language = QStringLiteral("en");
        bare.making.program = QStringLiteral("Palmer 1");
        QVERIFY(!element(xmpPacket(bare), "CreateDate"));
        QVERIFY(!element(xmpPacket(bare), "creator"));
        QVERIFY(readXmp(xmpPacket(bare)));
    }

    /// Characters that XML cannot hold would make a report that nobody can verify.
    void anyTitleAndAuthorCanBeRead() {
        for (int code = 0; code <= 0xFFFF; ++code) {
            if ((code > 0xFF && code < 0xD7F0) || QChar(code).isSurrogate()) // no half pair comes from a file
                continue;
            ReportMetadata metadata = example();
            metadata.title = QStringLiteral("a") + QChar(code) + u'b';
            metadata.author = QString(QChar(code));
            if (!readXmp(xmpPacket(metadata)))
                QFAIL(qPrintable(QStringLiteral("U+%1").arg(code, 4, 16)));
        }
    }

    /// Cut anywhere and with any byte changed: read as what it says, or not at all.
    void damagedPacketsAreRefusedOrSayWhatTheySay() {
        const QByteArray packet = xmpPacket(example());
        for (qsizetype length = 0; length < packet.size() - 30; ++length)
            QVERIFY(!readXmp(packet.left(length)) || !packet.left(length).contains("</x:xmpmeta"));
        std::mt19937 random(3);
        for (qsizetype at = 0; at < packet.size(); ++at) {
            QByteArray damaged = packet;
            damaged[at] = static_cast<char>(random() & 0xFF);
            if (const auto read = readXmp(damaged))
                QVERIFY(Language::fromName(read->language));
        }
    }

    void whatWeDoNotWriteIsNotRead_data() {
        QTest::addColumn<QByteArray>("before");
        QTest::addColumn<QByteArray>("after");
        QTest::newRow("another language") << QByteArray(">fr</palmer") << QByteArray(">de</palmer");
        QTest::newRow("no language") << QByteArray(">fr</palmer") << QByteArray("></palmer");
        QTest::newRow("self-test") << QByteArray(">passed<") << QByteArray(">perhaps<");
        QTest::newRow("no number") << QByteArray(">1 3 12<") << QByteArray(">1 x 12<");
        QTest::newRow("not rising") << QByteArray(">1 3 12<") << QByteArray(">1 12 3<");
        QTest::newRow("twice the same") << QByteArray(">1 3 12<") << QByteArray(">1 3 3<");
        QTest::newRow("test 0") << QByteArray(">1 3 12<") << QByteArray(">0 3 12<");
        QTest::newRow("stated twice") << QByteArray("<palmer:Program>Palmer 1.2.3</palmer:Program>")
                                      << QByteArray("<palmer:Program>Palmer 1.2.3</palmer:Program>"
                                                    "<palmer:Program>Palmer 9</palmer:Program>");
        QTest::newRow("missing") << QByteArray("<palmer:Program>Palmer 1.2.3</palmer:Program>")
                                 << QByteArray();
        QTest::newRow("another name") << QByteArray("palmer:Program>") << QByteArray("palmer:Maker>");
    }
    void editionsThatWeDoNotKnowAreNotRead() {
        ReportMetadata view = example();
        view.making.edition = QStringLiteral("ISO 230-2:1997");
        QCOMPARE(element(xmpPacket(view), "Edition"), view.making.edition);
        QVERIFY(readXmp(xmpPacket(view)));
        for (const char *word : {"", "ISO 230-2:1998", "1997"})
            QVERIFY(!readXmp(xmpPacket(view).replace(">ISO 230-2:1997<", '>' + QByteArray(word) + '<')));
        QVERIFY(!element(xmpPacket(example()), "Edition")); // of a view alone
        ReportMetadata bare = example();
        bare.making.annex = false;
        QCOMPARE(element(xmpPacket(bare), "LeftOut"), QStringLiteral("annex"));
        QVERIFY(!readXmp(xmpPacket(bare).replace(">annex<", ">readings<")));
        QVERIFY(!element(xmpPacket(example()), "LeftOut"));
    }
    void whatWeDoNotWriteIsNotRead() {
        QFETCH(const QByteArray, before);
        QFETCH(const QByteArray, after);
        QByteArray packet = xmpPacket(example());
        QVERIFY(packet.contains(before));
        QVERIFY(!readXmp(packet.replace(before, after)));
    }
};

QTEST_APPLESS_MAIN(ReportMetadataTest)
#include "reportmetadata.moc"
