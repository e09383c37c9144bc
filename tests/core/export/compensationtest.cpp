#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "export/compensation.h"
#include "document/documenterror.h"
#include "document/savedocument.h"
#include "export/readingscsv.h"
#include "import/importmeasurement.h"
#include "kernel/evaluation/evaluatetest.h"
#include "kernel/evaluation/surroundings.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <cmath>

using namespace palmer;

namespace {

Test example(const QString &name) {
    return *openDocument(EXAMPLES + name + ".palmer").tests.front();
}

TestEvaluation evaluated(const Test &test) {
    return evaluateTest(test, Surroundings{});
}

double value(const TestEvaluation &evaluation, const std::string &id) {
    for (const Parameter &parameter : evaluation.parameters) {
        if (parameterId(parameter) == id)
            return parameter.value.value_or(std::nan(""));
    }
    return std::nan("");
}

/// Two runs each way, so that means are what they look like.
Test smallTest() {
    PositioningMeasurement m;
    m.axis.name = "X";
    m.targets = {0, 100, 200};
    m.runs = {{Direction::positive, {-0.003, 0.0002, -0.005}},
              {Direction::negative, {0.0023, 0.0054, -0.0015}},
              {Direction::positive, {-0.003, 0.0002, -0.005}},
              {Direction::negative, {0.0023, 0.0054, -0.0015}}};
    Test test;
    test.edition = "ISO 230-2:2014";
    test.measurement = std::move(m);
    return test;
}

struct Form {
    const char *name;
    CompensationFormat format;
    CompensationOptions options;
};

CompensationOptions options(bool perDirection, bool incremental = false, bool deviations = false,
                            char mark = '.', std::optional<double> interval = {}) {
    CompensationOptions result;
    result.perDirection = perDirection;
    result.incremental = incremental;
    result.deviations = deviations;
    result.decimalMark = mark;
    result.interval = interval;
    return result;
}

const std::vector<Form> &rows() {
    using Format = CompensationFormat;
    static const std::vector<Form> table{
        {"LinuxCNC", Format::linuxcnc, options(false)},
        {"LinuxCNC per direction", Format::linuxcnc, options(true)},
        {"LinuxCNC at an interval", Format::linuxcnc, options(true, false, false, '.', 30)},
        {"Siemens", Format::siemens, options(false)},
        {"Siemens at an interval", Format::siemens, options(false, false, false, '.', 12.5)},
        {"CSV", Format::csv, options(false)},
        {"CSV per direction", Format::csv, options(true)},
        {"CSV in steps", Format::csv, options(true, true)},
        {"CSV with comma and the sign of the deviation", Format::csv, options(true, true, true, ',', 7.3)},
    };
    return table;
}

} // namespace

class CompensationTest : public QObject {
    Q_OBJECT

private slots:
    void takesOutTheMeans();
    void writesWhatControlsRead();
    void readsBackWhatItWrote_data();
    void readsBackWhatItWrote();
    void holdsBeyondItsEnds();
    void refusesWhatCannotBe();
    void readingsReadBack_data();
    void readingsReadBack();
    void jsonHasTheReadings();
};

void CompensationTest::takesOutTheMeans() {
    for (const QString name : {"iso230-2-1988-example", "rotary-axis", "long-axis-with-zone"}) {
        Test test = example(name);
        test.edition = "ISO 230-2:2014";
        const TestEvaluation before = evaluated(test);
        const TestEvaluation after = evaluated(
            compensated(test, compensationTable(test, before, CompensationFormat::csv, options(true))));
        // Per direction nothing systematic is left but the rounding of the table: 0.05 µm (or 5e-6°) each
        // way.
        const double rounding =
            2.1 * (std::get<PositioningMeasurement>(test.measurement).axis.motion == Motion::linear ? 0.5e-4
                                                                                                    : 0.5e-5);
        for (const char *id : {"E", "M", "B"})
            QVERIFY2(!(value(after, id) > rounding), id);
        // Combined, the reversal value stays as it is, and M goes.
        const TestEvaluation both = evaluated(
            compensated(test, compensationTable(test, before, CompensationFormat::csv, options(false))));
        QVERIFY(!(value(both, "M") > rounding));
        QVERIFY(std::isnan(value(before, "B")) || std::abs(value(both, "B") - value(before, "B")) < 1e-15);
        // Repeatability is no matter of compensation; differences of means round in the last digits.
        QVERIFY(std::isnan(value(before, "R+")) ||
                std::abs(value(after, "R+") - value(before, "R+")) < 1e-12);
    }
}

void CompensationTest::writesWhatControlsRead() {
    const Test test = smallTest();
    const TestEvaluation evaluation = evaluated(test);
    const auto text = [&](CompensationFormat format, const CompensationOptions &form) {
        return QString::fromUtf8(
            writeCompensation(compensationTable(test, evaluation, format, form), format, form));
    };
    QCOMPARE(text(CompensationFormat::linuxcnc, options(true)),
             "# Palmer LinuxCNC compensation axis=X unit=mm values=perDirection\n"
             "# COMP_FILE_TYPE = 0: nominal, actual going forward, actual going back\n"
             "0 -0.003 0.0023\n100 100.0002 100.0054\n200 199.995 199.9985\n");
    QCOMPARE(text(CompensationFormat::siemens, options(false)),
             "%_N_AX_EEC_INI\n; Palmer, unit=mm, value = actual - target\nCHANDATA(1)\n"
             "$AA_ENC_COMP[0,0,X]=-0.0004\n$AA_ENC_COMP[0,1,X]=0.0028\n$AA_ENC_COMP[0,2,X]=-0.0033\n"
             "$AA_ENC_COMP_STEP[0,X]=100\n$AA_ENC_COMP_MIN[0,X]=0\n$AA_ENC_COMP_MAX[0,X]=200\n"
             "$AA_ENC_COMP_IS_MODULO[0,X]=0\nM17\n");
    QCOMPARE(text(CompensationFormat::csv, options(true, false, false, ',')),
             "# Palmer compensation axis=X unit=mm values=perDirection form=absolute sign=correction "
             "decimalMark=comma\n"
             "position;forward;reverse\n0;0,003;-0,0023\n100;-0,0002;-0,0054\n200;0,005;0,0015\n");
    QCOMPARE(text(CompensationFormat::csv, options(true, true, true)),
             "# Palmer compensation axis=X unit=mm values=perDirection form=incremental sign=deviation "
             "decimalMark=point\n"
             "position;forward;reverse\n0;-0.003;0.0023\n100;0.0032;0.0031\n200;-0.0052;-0.0069\n");
    // Half way between the targets, and at the end although the interval does not meet it.
    CompensationOptions between = options(true, false, false, '.', 150);
    QCOMPARE(text(CompensationFormat::csv, between).section('\n', 2),
             "0;0.003;-0.0023\n150;0.0024;-0.002\n200;0.005;0.0015\n");
}

void CompensationTest::readsBackWhatItWrote_data() {
    QTest::addColumn<int>("index");
    for (int i = 0; i < static_cast<int>(rows().size()); ++i)
        QTest::newRow(rows()[static_cast<std::size_t>(i)].name) << i;
}

void CompensationTest::readsBackWhatItWrote() {
    QFETCH(int, index);
    const Form &row = rows()[static_cast<std::size_t>(index)];
    for (const QString name : {"iso230-2-1988-example", "rotary-axis"}) {
        const Test test = example(name);
        const TestEvaluation before = evaluated(test);
        const CompensationTable table = compensationTable(test, before, row.format, row.options);
        const CompensationTable read = readCompensation(writeCompensation(table, row.format, row.options));
        QVERIFY(read.positions == table.positions);
        QVERIFY(read.forward == table.forward);
        QVERIFY(read.reverse == table.reverse);
        QVERIFY(read.motion == table.motion);
        // The same prediction, bit by bit.
        QVERIFY(compensated(test, read) == compensated(test, table));
    }
}

void CompensationTest::holdsBeyondItsEnds() {
    CompensationTable table;
    table.positions = {0, 10, 30};
    table.forward = {1, 2, 4};
    table.reverse = {-1, -2, -4};
    QCOMPARE(table.correction(-5, Direction::positive), 1.0);
    QCOMPARE(table.correction(0, Direction::positive), 1.0);
    QCOMPARE(table.correction(5, Direction::positive), 1.5);
    QCOMPARE(table.correction(20, Direction::negative), -3.0);
    QCOMPARE(table.correction(99, Direction::negative), -4.0);
}

void CompensationTest::refusesWhatCannotBe() {
    const Test test = smallTest();
    const TestEvaluation evaluation = evaluated(test);
    const auto write = [&](CompensationFormat format, const CompensationOptions &form) {
        (void)writeCompensation(compensationTable(test, evaluation, format, form), format, form);
    };
    QVERIFY_EXCEPTION_THROWN(write(CompensationFormat::siemens, options(true)), Error);
    QVERIFY_EXCEPTION_THROWN(write(CompensationFormat::siemens, options(false, true)), Error);
    QVERIFY_EXCEPTION_THROWN(write(CompensationFormat::linuxcnc, options(false, false, true)), Error);
    QVERIFY_EXCEPTION_THROWN(write(CompensationFormat::csv, options(false, false, false, '.', -1)), Error);
    QVERIFY_EXCEPTION_THROWN(write(CompensationFormat::csv, options(false, false, false, '.', 1e-9)), Error);
    CompensationOptions backwards;
    backwards.from = 100;
    backwards.to = 0;
    QVERIFY_EXCEPTION_THROWN(write(CompensationFormat::csv, backwards), Error);
    Test gap = test;
    for (Run &run : std::get<PositioningMeasurement>(gap.measurement).runs)
        run.deviations[1].reset();
    QVERIFY_EXCEPTION_THROWN((void)compensationTable(gap, evaluated(gap), CompensationFormat::csv, {}),
                             Error);
    for (const char *text : {"", "hello", "1 2\n", "0 0 0\n0 1 1\n", "$AA_ENC_COMP[0,0,X]=1\n",
                             "# Palmer compensation\n1;2;3\n"})
        QVERIFY_EXCEPTION_THROWN((void)readCompensation(text), Error);
}

void CompensationTest::readingsReadBack_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("comma");
    for (const char *name :
         {"iso230-2-1988-example", "rotary-axis", "one-direction", "long-axis-with-zone"}) {
        for (const bool comma : {false, true})
            QTest::addRow("%s, %s", name, comma ? "comma" : "point") << QString(name) << comma;
    }
}

void CompensationTest::readingsReadBack() {
    QFETCH(QString, name);
    QFETCH(bool, comma);
    const Test test = example(name);
    const QByteArray csv =
        readingsCsv(test, evaluated(test), Language(Language::Id::english), comma ? ',' : '.');
    const Imported imported = importMeasurement(csv, "x.csv");
    QVERIFY(imported.test);
    const auto &expected = std::get<PositioningMeasurement>(test.measurement);
    const auto &read = std::get<PositioningMeasurement>(imported.test->measurement);
    QVERIFY(read.targets == expected.targets);
    QVERIFY(read.runs == expected.runs);
    QCOMPARE(read.axis.name, expected.axis.name);
    QVERIFY(read.axis.motion == expected.axis.motion);
    for (const Remark &remark : imported.remarks)
        QVERIFY2(remark.grade != RemarkGrade::problem, remark.message.text.source);
}

void CompensationTest::jsonHasTheReadings() {
    const auto document = std::make_shared<const Document>(openDocument(EXAMPLES "one-direction.palmer"));
    const QJsonObject test = QJsonDocument::fromJson(readingsJson(
        evaluate(document), "x", Language(Language::Id::english)))["tests"][0]
                                 .toObject();
    const auto &m = std::get<PositioningMeasurement>(document->tests.front()->measurement);
    const QJsonObject readings = test["readings"].toObject();
    QCOMPARE(readings["targets"].toArray().size(), static_cast<qsizetype>(m.targets.size()));
    QCOMPARE(readings["runs"].toArray().size(), static_cast<qsizetype>(m.runs.size()));
    QCOMPARE(readings["runs"][0]["approach"].toString(), QString("positive"));
    QCOMPARE(readings["runs"][0]["deviations"][0].toDouble(), *m.runs[0].deviations[0]);
    QVERIFY(test["parameters"].toArray().size() > 0);
}

QTEST_GUILESS_MAIN(CompensationTest)
#include "compensationtest.moc"
