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
    void seesADifference();
    void refusesOtherFiles();
};

void ValidationTest::agreesWithAllReferenceData_data() {
    QTest::addColumn<int>("values");
    QTest::newRow("iso230-2-1988-table2") << 73;
    QTest::newRow("constructed") << 52;
    for (const char *name : {"mavro", "michelso", "numacc1", "numacc2", "numacc3", "numacc4"})
        QTest::newRow(qPrintable(QString("nist-strd-") + name)) << 2;
}

void ValidationTest::agreesWithAllReferenceData() {
    QFETCH(int, values);
    const SetValidation result = validate(embedded(QTest::currentDataTag()));
    QCOMPARE(int(result.comparisons.size()), values);
    for (const Comparison &comparison : result.comparisons)
        QVERIFY2(comparison.agrees, qPrintable(QString::fromStdString(comparison.expectation.edition) + ' ' +
                                               comparison.symbol));
}

void ValidationTest::seesADifference() {
    ReferenceSet set = embedded("constructed");
    set.expected.resize(1);
    set.expected[0].value += 2 * set.expected[0].tolerance;
    QVERIFY(!validate(set).agrees());
    set.expected[0].edition = "ISO 230-2:2099";
    QVERIFY(!validate(set).agrees());
}

void ValidationTest::refusesOtherFiles() {
    QVERIFY_EXCEPTION_THROWN(std::ignore = readReferenceSet("{}"), Error);
    QVERIFY_EXCEPTION_THROWN(std::ignore = readReferenceSet("not JSON"), Error);
}

QTEST_GUILESS_MAIN(ValidationTest)
#include "validationtest.moc"
