// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "editing/readingblock.h"

#include "core/kernel/evaluation/positioningdata.h"
#include "document/documenterror.h"
#include "editing/editreadings.h"
#include "editing/newtest.h"

#include <QTest>

using namespace palmer;
using namespace palmer::testdata;

namespace {

const PositioningMeasurement &exampleMeasurement() {
    // The doubles of the decimals, as reading a file gives them: 5.4/1000 need not be that of 0.0054.
    static const PositioningMeasurement exact = [] {
        Test test = example1988("ISO 230-2:1988");
        for (Run &run : measurement(test).runs) {
            for (auto &deviation : run.deviations)
                deviation = std::round(*deviation * 1e9) / 1e9;
        }
        return measurement(test);
    }();
    return exact;
}

/// The test of the example with its targets and no reading.
PositioningMeasurement emptyExample() {
    PositioningMeasurement m = exampleMeasurement();
    for (Run &run : m.runs)
        std::ranges::fill(run.deviations, std::nullopt);
    return m;
}

BlockPlace at(std::size_t row, std::size_t column, const PositioningMeasurement &m) {
    BlockPlace place{row, column, {}};
    for (std::size_t run = 0; run < m.runs.size(); ++run)
        place.runs.push_back(run);
    return place;
}

QString decimal(double value, QChar mark) {
    QString text = QString::number(value, 'g', 10);
    return text.replace(u'.', mark);
}

/// The example as a spreadsheet copies it: number, position, readings.
std::string block(QChar mark, const QString &delimiter, std::size_t firstColumn, const QString &minus = "-") {
    const PositioningMeasurement &m = exampleMeasurement();
    QStringList lines;
    for (std::size_t i = 0; i < m.targets.size(); ++i) {
        QStringList cells{QString::number(i + 1), decimal(m.targets[i], mark)};
        for (const Run &run : m.runs)
            cells << decimal(std::round(*run.deviations[i] * 1e4) / 10, mark).replace("-", minus);
        lines << cells.mid(static_cast<int>(firstColumn)).join(delimiter);
    }
    return (lines.join("\r\n") + "\r\n").toStdString();
}

} // namespace

class ReadingBlockTest : public QObject {
    Q_OBJECT

private slots:
    void takesWholeTestsInEveryLocale_data() {
        QTest::addColumn<QString>("mark");
        QTest::addColumn<QString>("delimiter");
        QTest::addColumn<QString>("minus");
        QTest::newRow("British: point, tabs") << "."
                                              << "\t"
                                              << "-";
        QTest::newRow("French: comma, tabs") << ","
                                             << "\t"
                                             << "-";
        QTest::newRow("Swedish: comma, typographical minus") << ","
                                                             << "\t"
                                                             << "−";
        QTest::newRow("German file: comma, semicolons") << ","
                                                        << ";"
                                                        << "-";
        QTest::newRow("English file: point, commas") << "."
                                                     << ","
                                                     << "-";
    }

    void takesWholeTestsInEveryLocale() {
        QFETCH(QString, mark);
        QFETCH(QString, delimiter);
        QFETCH(QString, minus);
        const PositioningMeasurement empty = emptyExample();
        for (const std::size_t column : {0, 1, 2}) {
            const PastedBlock pasted =
                pasteBlock(empty, block(mark[0], delimiter, column, minus), at(0, column, empty), {});
            QCOMPARE(pasted.readings, std::size_t{110});
            QCOMPARE(pasted.targets, std::size_t{column < 2 ? 11U : 0U});
            QVERIFY(pasted.remarks.empty());
            QVERIFY(pasted.measurement == exampleMeasurement());
            QCOMPARE(pasted.decimalMark.value, mark == "," ? DecimalMark::comma : DecimalMark::point);
            QVERIFY(pasted.hasMarks);
        }
    }

    void recognisesTargetsPutOnTheFirstReading() {
        const PositioningMeasurement empty = emptyExample();
        for (const std::size_t column : {0, 1}) {
            const PastedBlock pasted = pasteBlock(empty, block(u'.', "\t", column), at(0, 2, empty), {});
            QVERIFY(pasted.measurement == exampleMeasurement());
            QCOMPARE(pasted.remarks.size(), std::size_t{1});
        }
    }

    void bringsMoreTargets() {
        NewPositioningTest wanted;
        wanted.axis.name = "X";
        wanted.targets = {0, 1, 2};
        const Test test = newTest(wanted);
        const auto &m = std::get<PositioningMeasurement>(test.measurement);
        const PastedBlock pasted = pasteBlock(m, block(u',', "\t", 1), at(0, 1, m), {});
        QVERIFY(pasted.measurement.targets == exampleMeasurement().targets);
        QVERIFY(pasted.measurement.runs == exampleMeasurement().runs);
    }

    void readsTheUnitsOfTheHeading_data() {
        QTest::addColumn<std::string>("text");
        QTest::addColumn<std::size_t>("column");
        QTest::addColumn<QString>("sign"); // empty: said nowhere, or by each column another
        const auto row = [](const char *name, const char *text, std::size_t column, const char *sign) {
            QTest::newRow(name) << std::string(text) << column << QString(sign);
        };
        row("mm", "Dev (mm)\n0.0015\n-0.002", 2, "mm");
        row("nm", "nm\n1500\n-2000", 2, "nm");
        row("none", "Dev\n1.5\n-2", 2, "");
        row("first column alone", "run 1 [mm]\trun 2\n0.0015\t0.003\n-0.002\t0", 2, "mm");
        row("each its own", "mm\tµm\n0.0015\t3\n-0.002\t0", 2, "");
        row("targets in mm", "P (mm)\tDev\n0\t1.5\n150.71\t-2", 1, "");
        row("targets in m, put on the first reading", "P (m)\tDev (mm)\n0\t0.0015\n0.15071\t-0.002", 2, "mm");
    }
    void readsTheUnitsOfTheHeading() {
        QFETCH(const std::string, text);
        QFETCH(const std::size_t, column);
        QFETCH(const QString, sign);
        const PositioningMeasurement empty = emptyExample();
        const PastedBlock pasted = pasteBlock(empty, text, at(0, column, empty), {});
        QCOMPARE(readingAt(pasted.measurement, {0, 0}), std::optional(0.0015));
        QCOMPARE(readingAt(pasted.measurement, {0, 1}), std::optional(-0.002));
        if (const auto second = readingAt(pasted.measurement, {1, 0}))
            QCOMPARE(*second, 0.003);
        QCOMPARE(pasted.measurement.targets, empty.targets);
        QCOMPARE(QString(pasted.unit ? pasted.unit->sign : ""), sign);
    }

    void whatIsChosenWinsOverTheHeading() {
        const PositioningMeasurement empty = emptyExample();
        BlockChoices choices;
        choices.unitsOfHeading = false;
        const PastedBlock pasted = pasteBlock(empty, "(mm)\n1.5", at(0, 2, empty), choices);
        QCOMPARE(readingAt(pasted.measurement, {0, 0}), std::optional(0.0015));
    }

    void unitsThatAreNotReadAreRefused() {
        const PositioningMeasurement empty = emptyExample();
        for (const char *heading : {"(1/10 µm)", "ppm", "arcsec"})
            QVERIFY_EXCEPTION_THROWN(
                (void)pasteBlock(empty, std::string(heading) + "\n1.5", at(0, 2, empty), {}), Error);
    }

    void aBlockGoesWhereItIsPut() {
        const PositioningMeasurement empty = emptyExample();
        const PastedBlock pasted = pasteBlock(empty, "1.5\t2\n\t-3\n", at(4, 3, empty), {});
        PositioningMeasurement expected = empty;
        setReading(expected, {1, 4}, 0.0015);
        setReading(expected, {2, 4}, 0.002);
        setReading(expected, {2, 5}, -0.003);
        QVERIFY(pasted.measurement == expected);
        QCOMPARE(pasted.readings, std::size_t{3});
    }

    void anEmptyLineIsAMissingReading() {
        PositioningMeasurement m = exampleMeasurement();
        const PastedBlock pasted = pasteBlock(m, "1\n\n3\n", at(0, 2, m), {});
        QCOMPARE(readingAt(pasted.measurement, {0, 0}), std::optional(0.001));
        QCOMPARE(readingAt(pasted.measurement, {0, 1}), std::nullopt);
        QCOMPARE(readingAt(pasted.measurement, {0, 2}), std::optional(0.003));
    }

    /// A reading that is missing at the first target moves no other.
    void theFirstReadingMayBeMissing_data() {
        QTest::addColumn<std::string>("text");
        QTest::addColumn<bool>("isTwoRuns");
        QTest::newRow("an empty line") << std::string("\n2.2\n3.3\n") << false;
        QTest::newRow("an empty cell in quotes") << std::string("\"\"\n2.2\n3.3\n") << false;
        QTest::newRow("below a heading") << std::string("Run 1\n\n2.2\n3.3\n") << false;
        for (const char *mark : {"?", "n/a", "x", "-"})
            QTest::newRow(mark) << std::string(mark) + "\n2.2\n3.3\n" << false;
        QTest::newRow("two runs") << std::string("\t\n2.2\t4.4\n3.3\t5.5\n") << true;
        QTest::newRow("two runs, marks") << std::string("n/a\t?\n2.2\t4.4\n3.3\t5.5\n") << true;
        QTest::newRow("two runs, marks below headings")
            << std::string("Run 1\tRun 2\nn/a\t?\n2.2\t4.4\n3.3\t5.5\n") << true;
        QTest::newRow("two runs, a ruled line")
            << std::string("Run 1\tRun 2\n---\t---\n\t?\n2.2\t4.4\n3.3\t5.5\n") << true;
    }
    void theFirstReadingMayBeMissing() {
        QFETCH(std::string, text);
        QFETCH(bool, isTwoRuns);
        const auto block = pasteBlock(emptyExample(), text, at(1, 2, exampleMeasurement()), {});
        for (std::size_t run = 0; run < 2; ++run) {
            const auto &readings = block.measurement.runs[run].deviations;
            const bool isFilled = run == 0 || isTwoRuns;
            QVERIFY(!readings[0] && !readings[1]);
            QCOMPARE(readings[2], isFilled ? std::optional(run == 0 ? 0.0022 : 0.0044) : std::nullopt);
            QCOMPARE(readings[3], isFilled ? std::optional(run == 0 ? 0.0033 : 0.0055) : std::nullopt);
        }
    }

    void aChosenMarkRefusesTheOther() {
        const PositioningMeasurement empty = emptyExample();
        BlockChoices choices;
        choices.decimalMark = DecimalMark::point;
        const PastedBlock pasted = pasteBlock(empty, "32,56\t1,5\n2.5\t3\n", at(0, 2, empty), choices);
        QCOMPARE(pasted.readings, std::size_t{2});
        QCOMPARE(pasted.refused, std::size_t{2});
        QCOMPARE(refusedAt(pasted.measurement, {0, 0})->text, std::string("32,56"));
        choices.decimalMark = DecimalMark::comma;
        const PastedBlock comma = pasteBlock(empty, "32,56\t1,5\n2\t3\n", at(0, 2, empty), choices);
        QCOMPARE(readingAt(comma.measurement, {0, 0}), std::optional(0.03256));
    }

    void leavesHeadingsOut() {
        const PositioningMeasurement empty = emptyExample();
        const PastedBlock pasted = pasteBlock(empty, "Run 1 up\tRun 1 down\n1.5\t2.5\n", at(0, 2, empty), {});
        QCOMPARE(readingAt(pasted.measurement, {0, 0}), std::optional(0.0015));
        QCOMPARE(readingAt(pasted.measurement, {1, 0}), std::optional(0.0025));
        QCOMPARE(pasted.remarks.size(), std::size_t{1});
    }

    void keepsWhatIsNoNumber() {
        const PositioningMeasurement empty = emptyExample();
        const PastedBlock pasted = pasteBlock(empty, "1\t4,,8\nn/a\tlost\n", at(0, 2, empty), {});
        QCOMPARE(pasted.readings, std::size_t{1});
        QCOMPARE(pasted.refused, std::size_t{2});
        QCOMPARE(refusedAt(pasted.measurement, {1, 1})->text, std::string("lost"));
        QVERIFY(!refusedAt(pasted.measurement, {0, 1}));
    }

    void saysWhatHasNoPlace() {
        const PositioningMeasurement empty = emptyExample();
        const PastedBlock pasted = pasteBlock(empty, "1\t2\t3\n4\t5\t6\n", at(10, 10, empty), {});
        QCOMPARE(pasted.readings, std::size_t{2});
        QCOMPARE(pasted.left, std::size_t{4});
        QCOMPARE(pasted.remarks.size(), std::size_t{1});
    }

    void contentIsAChoice() {
        const PositioningMeasurement empty = emptyExample();
        BlockChoices choices;
        choices.content = BlockContent::longDeviations;
        PastedBlock pasted = pasteBlock(empty, "0.0054\n-0.0015\n", at(1, 3, empty), choices);
        QCOMPARE(readingAt(pasted.measurement, {1, 1}), std::optional(0.0054));
        choices.content = BlockContent::positions;
        pasted = pasteBlock(empty, "150.7154\n300.8485\n", at(1, 3, empty), choices);
        QCOMPARE(readingAt(pasted.measurement, {1, 1}), std::optional(0.0054));
        QCOMPARE(readingAt(pasted.measurement, {1, 2}), std::optional(-0.0015));
        // Taken for µm they are a question, not an answer.
        pasted = pasteBlock(empty, "0.0054\n-0.0015\n0.001\n0.002\n", at(1, 3, empty), {});
        QCOMPARE(pasted.remarks.size(), std::size_t{1});
    }

    void targetsThatDoNotAscendStay() {
        const PositioningMeasurement empty = emptyExample();
        const PastedBlock pasted = pasteBlock(empty, "5\t1\n5\t2\n", at(0, 1, empty), {});
        QVERIFY(pasted.measurement.targets == empty.targets);
        QCOMPARE(pasted.readings, std::size_t{2});
        QCOMPARE(pasted.targets, std::size_t{0});
        QCOMPARE(pasted.remarks.size(), std::size_t{1});
    }

    void textWithoutNumbersChangesNothing() {
        const PositioningMeasurement m = exampleMeasurement();
        for (const char *text : {"", "\n\n", "hello\nworld\n"}) {
            const PastedBlock pasted = pasteBlock(m, text, at(0, 2, m), {});
            QVERIFY(pasted.measurement == m);
            QCOMPARE(pasted.remarks.size(), std::size_t{1});
        }
    }

    /// Lines and columns in any order, targets down or across: each reading goes where the headings say.
    void namedBlocksGoByTargetAndDirection() {
        PositioningMeasurement m;
        m.axis.name = "X";
        m.targets = {0, 100, 200};
        m.runs = {{Direction::positive, {{}, {}, {}}}, {Direction::negative, {{}, {}, {}}}};
        const auto values = [](const PastedBlock &pasted, std::size_t run) {
            std::vector<double> micrometres;
            for (const auto &deviation : pasted.measurement.runs[run].deviations)
                micrometres.push_back(deviation ? std::round(*deviation * 1e7) / 1e4 : -1);
            return micrometres;
        };
        for (const char *text : {"Position (mm)\t↓ (µm)\t↑ (µm)\n200\t6\t5\n0\t2\t1\n100\t4\t3\n",
                                 "Position (mm)\t0\t100\t200\n1 ↑ (µm)\t1\t3\t5\n1 ↓ (µm)\t2\t4\t6\n"}) {
            const PastedBlock pasted = pasteBlock(m, text, at(0, 2, m), {});
            QCOMPARE(values(pasted, 0), (std::vector<double>{1, 3, 5}));
            QCOMPARE(values(pasted, 1), (std::vector<double>{2, 4, 6}));
            QVERIFY(pasted.questions.empty() && pasted.left == 0);
        }
        // A run and a target that the test does not have are counted and put nowhere.
        m.runs[0].deviations[0] = 0.009;
        const PastedBlock more = pasteBlock(m,
                                            "Position (mm)\t1 ↑ (µm)\t1 ↓ (µm)\t2 ↑ (µm)\t2 ↓ (µm)\n"
                                            "0\t1\t2\t1.5\t2.5\n150\t3\t4\t3.5\t4.5\n",
                                            at(0, 2, m), {});
        QCOMPARE(values(more, 0), (std::vector<double>{1, -1, -1}));
        QCOMPARE(values(more, 1), (std::vector<double>{2, -1, -1}));
        QCOMPARE(more.left, std::size_t{6});
        QCOMPARE(more.measurement.targets, m.targets);
    }

    /// What a file would be doubted for is asked, and nothing is put; what it says of the sign is said.
    void namedBlocksAskWhatAFileWouldAsk() {
        PositioningMeasurement m;
        m.axis.name = "X";
        m.targets = {0, 100};
        m.runs = {{Direction::positive, {{}, {}}}, {Direction::negative, {{}, {}}}};
        const char *volts = "Position (mm)\t↑ (V)\t↓ (V)\n0\t1\t2\n100\t3\t4\n";
        const PastedBlock asked = pasteBlock(m, volts, at(0, 2, m), {});
        QVERIFY(!asked.questions.empty());
        QCOMPARE(asked.measurement, m);
        BlockChoices answered;
        answered.answers["unit"] = "um";
        QCOMPARE(pasteBlock(m, volts, at(0, 2, m), answered).measurement.runs[1].deviations[1].value(),
                 0.004);
        const PastedBlock turned = pasteBlock(
            m, "Deviation = target - actual\n\nPosition (mm)\t↑ (µm)\t↓ (µm)\n0\t1\t2\n100\t3\t4\n",
            at(0, 2, m), {});
        QCOMPARE(turned.measurement.runs[0].deviations[1].value(), -0.003);
        QVERIFY(std::ranges::any_of(turned.remarks, [](const Message &remark) {
            return QString::fromUtf8(remark.text.source).startsWith("Sign: the file says");
        }));
    }
};

QTEST_GUILESS_MAIN(ReadingBlockTest)
#include "readingblock.moc"
