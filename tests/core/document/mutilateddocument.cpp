// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/completefile.h"
#include "document/readdocument.h"
#include "document/writedocument.h"

#include <QTest>

#include <optional>
#include <random>

using namespace palmer;

namespace {

std::optional<Error> errorOf(const QByteArray &file) {
    try {
        (void)readDocument(file);
        return {};
    } catch (const Error &error) {
        return error;
    }
}

QByteArray fileWithReadings(int count) {
    QByteArray file =
        R"({"format": "palmer test report", "version": 1, "tests": [{"kind": "drift", "deviations": [)";
    file.reserve(file.size() + 2 * count + 10);
    for (int i = 0; i < count; ++i)
        file += i == 0 ? "0" : ",0";
    return file + "]}]}";
}

} // namespace

class MutilatedDocumentTest : public QObject {
    Q_OBJECT

private slots:
    void everyTruncationIsRefused() {
        const QByteArray file = completeFile().trimmed();
        QVERIFY(!errorOf(file));
        for (qsizetype size = 0; size < file.size(); ++size) {
            const std::optional<Error> error = errorOf(file.left(size));
            QVERIFY2(error, qPrintable(QString::number(size)));
            QVERIFY(error->kind == Error::Kind::syntax);
        }
    }

    void damagedBytesNeverCrash() {
        const QByteArray file = completeFile();
        std::mt19937 random(4);
        int refused = 0;
        constexpr int trials = 4000;
        for (int trial = 0; trial < trials; ++trial) {
            QByteArray damaged = file;
            for (auto changes = 1 + random() % 3; changes > 0; --changes) {
                const auto at = static_cast<qsizetype>(random() % static_cast<std::size_t>(damaged.size()));
                switch (random() % 4) {
                case 0:
                    damaged[at] = static_cast<char>(random());
                    break;
                case 1:
                    damaged.remove(at, 1 + static_cast<qsizetype>(random() % 20));
                    break;
                case 2:
                    damaged.insert(at, "{}[],:\"-0eE.\\n"[random() % 14]);
                    break;
                default:
                    damaged.insert(at, damaged.mid(static_cast<qsizetype>(random() % 9000), 30));
                }
            }
            try {
                // What is accepted is a document like any other.
                const Document document = readDocument(damaged);
                QVERIFY(readDocument(writeDocument(document)) == document);
            } catch (const Error &error) {
                ++refused;
                QVERIFY(*error.message.text.source != 0);
                QVERIFY(error.place.find('\n') == std::string::npos);
            }
        }
        QVERIFY(refused > trials / 2);
        QVERIFY(refused < trials); // damage inside a text is no error
    }

    void deepNestingIsRefused() {
        const QByteArray head = R"({"format": "palmer test report", "version": 1, "extensions": {"a": )";
        for (const char *const opening : {"[", "{\"a\":"}) {
            const std::optional<Error> error = errorOf(head + QByteArray(opening).repeated(100'000));
            QVERIFY(error);
            QVERIFY(error->kind == Error::Kind::content);
            QCOMPARE(error->message.text.source, "nested deeper than a test file can be");
        }
        QVERIFY(errorOf(QByteArray(100'000, '[')));
        QVERIFY(!errorOf(head + QByteArray(62, '[') + QByteArray(62, ']') + "}}"));
        QVERIFY(errorOf(head + QByteArray(63, '[') + QByteArray(63, ']') + "}}"));
    }

    void tenMillionAndOneReadingsAreRefused() {
        const std::optional<Error> error = errorOf(fileWithReadings(10'000'001));
        QVERIFY(error);
        QVERIFY(error->kind == Error::Kind::tooLarge);
        QCOMPARE(error->place, std::string("tests[0].deviations[10000000]"));
    }

    void readingsOfAllTestsCount() {
        // Two tests of 5 000 001 readings each.
        QByteArray half = fileWithReadings(5'000'001);
        half.chop(2);
        const qsizetype test = half.indexOf("{\"kind\"");
        const std::optional<Error> error = errorOf(half + ',' + half.mid(test) + "]}");
        QVERIFY(error);
        QVERIFY(error->kind == Error::Kind::tooLarge);
        QCOMPARE(error->place, std::string("tests[1].deviations[4999999]"));
    }
};

QTEST_APPLESS_MAIN(MutilatedDocumentTest)
#include "mutilateddocument.moc"
