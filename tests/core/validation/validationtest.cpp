// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "validation/validation.h"

#include <QFile>
#include <QTest>

using namespace palmer;

namespace {

ReferenceSet embedded(const QString &name) {
    QFile file(":/reference/" + name + ".json");
    if (!file.open(QIODevice::ReadOnly))
        qFatal("no reference data %s", qPrintable(name));
    return readReferenceSet(file.readAll());
}

} // namespace

class ValidationTest : public QObject {
    Q_OBJECT

private slots:
    void agreesWithAllReferenceData_data();
    void agreesWithAllReferenceData();
    void agreesWithAllCircles();
    void seesADifference();
    void coversAllEmbeddedData();
    void refusesOtherFiles();
};

void ValidationTest::agreesWithAllReferenceData_data() {
    QTest::addColumn<int>("values");
    QTest::newRow("iso230-2-1988-table2") << 73;
    QTest::newRow("constructed") << 52;
    for (const char *name : {"mavro", "michelso", "numacc1", "numacc2", "numacc3", "numacc4"})
        QTest::newRow(qPrintable(QString("nist-strd-") + name)) << 2;
    QTest::newRow("ballbar-pair") << 8;
    QTest::newRow("circular-correction") << 3;
    QTest::newRow("iso230-4-annex-c") << 2;
}

void ValidationTest::agreesWithAllReferenceData() {
    QFETCH(int, values);
    const SetValidation result = validate(embedded(QTest::currentDataTag()));
    QCOMPARE(int(result.comparisons.size()), values);
    for (const Comparison &comparison : result.comparisons)
        QVERIFY2(comparison.agrees, qPrintable(QString::fromStdString(comparison.expectation.edition) + ' ' +
                                               comparison.symbol.base));
}

void ValidationTest::agreesWithAllCircles() {
    const std::vector<SetValidation> sets = validateCircles();
    QCOMPARE(sets.size(), std::size_t(2));
    QCOMPARE(sets[0].comparisons.size(), std::size_t(30 * 4 - 1)); // one set has three points
    QCOMPARE(sets[1].comparisons.size(), std::size_t(4 * 4));
    for (const SetValidation &set : sets) {
        QVERIFY(set.points);
        for (const Comparison &comparison : set.comparisons)
            QVERIFY2(comparison.agrees, qPrintable(comparison.of + ' ' + comparison.symbol.base));
    }
}

void ValidationTest::coversAllEmbeddedData() {
    const std::vector<SetValidation> all = validateAll();
    QCOMPARE(all.size(), embeddedReferenceFiles().size() + 2);
    for (const SetValidation &set : all)
        QVERIFY2(set.agrees() && !set.comparisons.empty(), qPrintable(set.name));
}

void ValidationTest::seesADifference() {
    ReferenceSet set = embedded("constructed");
    set.expected.resize(1);
    set.expected[0].value += 2 * set.expected[0].tolerance;
    QVERIFY(!validate(set).agrees());
    set.expected[0].edition = "ISO 230-2:2099";
    QVERIFY(!validate(set).agrees());
    for (const char *name : {"ballbar-pair", "circular-correction", "iso230-4-annex-c"}) {
        ReferenceSet circles = embedded(name);
        circles.expected.back().value += 2 * circles.expected.back().tolerance;
        QVERIFY2(!validate(circles).agrees(), name);
    }
    ReferenceSet noSuchTest = embedded("circular-correction");
    noSuchTest.expected.back().test = 9;
    QVERIFY(!validate(noSuchTest).agrees());
}

void ValidationTest::refusesOtherFiles() {
    QVERIFY_EXCEPTION_THROWN(std::ignore = readReferenceSet("{}"), Error);
    QVERIFY_EXCEPTION_THROWN(std::ignore = readReferenceSet("not JSON"), Error);
}

QTEST_GUILESS_MAIN(ValidationTest)
#include "validationtest.moc"
