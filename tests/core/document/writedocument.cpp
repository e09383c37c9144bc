#include "document/writedocument.h"

#include "core/document/completefile.h"
#include "document/readdocument.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>

using namespace palmer;

namespace {

Document documentWithTargets(std::vector<double> targets) {
    Test test;
    test.edition = "ISO 230-2:1988";
    std::get<PositioningMeasurement>(test.measurement).targets = std::move(targets);
    Document document;
    document.tests.push_back(std::make_shared<const Test>(test));
    return document;
}

} // namespace

class WriteDocumentTest : public QObject {
    Q_OBJECT

private slots:
    void whatWasWrittenIsReadEqually() {
        const Document document = readDocument(completeFile());
        QVERIFY(readDocument(writeDocument(document)) == document);
        QVERIFY(readDocument(writeDocument(Document())) == Document());
    }

    void writingIsAFixedPoint() {
        const QByteArray once = writeDocument(readDocument(completeFile()));
        QCOMPARE(writeDocument(readDocument(once)), once);
    }

    void numbersAreWrittenInTheirShortestForm_data() {
        QTest::addColumn<double>("value");
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("whole number without point") << 1800.0 << QByteArray("1800");
        QTest::newRow("large whole number") << 100000.0 << QByteArray("100000");
        QTest::newRow("zero without sign") << -0.0 << QByteArray("0");
        QTest::newRow("small deviation without exponent") << 0.0001 << QByteArray("0.0001");
        QTest::newRow("no digit more than needed") << 0.1 << QByteArray("0.1");
        QTest::newRow("all digits needed") << 0.1 + 0.2 << QByteArray("0.30000000000000004");
        QTest::newRow("exponent where it is shorter") << 2.5e300 << QByteArray("2.5e+300");
        QTest::newRow("smallest subnormal") << 5e-324 << QByteArray("5e-324");
    }
    void numbersAreWrittenInTheirShortestForm() {
        QFETCH(double, value);
        QFETCH(QByteArray, text);
        const QByteArray written = writeDocument(documentWithTargets({value}));
        QVERIFY2(written.contains("\"targets\": [" + text + "]"), written.constData());
    }

    void everyDoubleRoundTrips() {
        std::mt19937_64 random(17);
        std::vector<double> values;
        while (values.size() < 20'000) {
            const auto bits = random();
            double value = 0;
            static_assert(sizeof bits == sizeof value);
            std::memcpy(&value, &bits, sizeof value);
            if (std::isfinite(value))
                values.push_back(value);
        }
        std::sort(values.begin(), values.end());
        const Document document = documentWithTargets(values);
        QVERIFY(readDocument(writeDocument(document)) == document);
    }

    void linesOfNumbersAreFilled() {
        std::vector<double> targets;
        for (int i = 0; i < 1000; ++i)
            targets.push_back(i + 0.125);
        const QByteArray written = writeDocument(documentWithTargets(targets));
        qsizetype longest = 0;
        for (const QByteArray &line : written.split('\n'))
            longest = std::max(longest, line.size());
        QVERIFY(longest <= 100);
        QVERIFY(longest > 90);
        // Nine characters and more a number: about ten a line.
        QVERIFY(written.count('\n') < 250);
        QVERIFY(written.endsWith("}\n"));
    }

    void keysAreSorted() {
        const QByteArray written = writeDocument(Document());
        QVERIFY(written.indexOf("\"extensions\"") < written.indexOf("\"format\""));
        QVERIFY(written.indexOf("\"format\"") < written.indexOf("\"version\""));
    }

    void textsAreEscaped() {
        Document document;
        document.writtenBy = "\"\\\n\t\x01é😀\x7f";
        QCOMPARE(readDocument(writeDocument(document)).writtenBy, document.writtenBy);
    }

    void aNumberThatIsNotFiniteIsRefused() {
        for (const double value :
             {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
            try {
                (void)writeDocument(documentWithTargets({0, value}));
                QFAIL("it was written");
            } catch (const Error &error) {
                QVERIFY(error.kind == Error::Kind::unwritable);
                QCOMPARE(error.place, std::string("tests[0].targets[1]"));
            }
    }
};

QTEST_APPLESS_MAIN(WriteDocumentTest)
#include "writedocument.moc"
