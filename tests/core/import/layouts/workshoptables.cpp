// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "core/import/importpicture.h"
#include "core/import/layouts/workshoptable.h"
#include "import/importmeasurement.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

using namespace palmer;

namespace {

bool sameRun(const Run &run, const std::vector<double> &micrometres) {
    if (run.deviations.size() != micrometres.size())
        return false;
    for (std::size_t i = 0; i < micrometres.size(); ++i) {
        // What the decimals of the file say, to the last bits.
        if (!run.deviations[i] || std::abs(*run.deviations[i] - micrometres[i] / 1000) > 1e-12)
            return false;
    }
    return true;
}

bool isRight(const Imported &imported, const testdata::WorkshopTable &table) {
    const auto *read =
        imported.test ? std::get_if<PositioningMeasurement>(&imported.test->measurement) : nullptr;
    if (!read || read->targets != table.targets ||
        read->runs.size() != table.positive.size() + table.negative.size())
        return false;
    std::size_t up = 0;
    std::size_t down = 0;
    for (const Run &run : read->runs) {
        const bool positive = run.approach == Direction::positive;
        const auto &side = positive ? table.positive : table.negative;
        std::size_t &next = positive ? up : down;
        if (next >= side.size() || !sameRun(run, side[next++]))
            return false;
    }
    return true;
}

} // namespace

/// Random tables with known truth: nearly all are read right, and none wrong without a question.
class WorkshopTablesTest : public QObject {
    Q_OBJECT

private slots:
    void areReadRightOrAsked_data() {
        QTest::addColumn<unsigned>("seed");
        for (const unsigned seed : {20240312U, 1U, 2U})
            QTest::addRow("seed %u", seed) << seed;
        // More of them when asked for: PALMER_SEEDS=20 takes 3 to 20.
        for (unsigned seed = 3; seed <= qEnvironmentVariable("PALMER_SEEDS").toUInt(); ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }
    void areReadRightOrAsked() {
        QFETCH(unsigned, seed);
        constexpr int tables = 600;
        constexpr int mostWrong = tables * 5 / 100;
        std::mt19937 random(seed);
        int wrong = 0;
        int silent = 0;
        int taken = 0; // all questions are assumed: --accept takes them
        int wrongTaken = 0;
        int stated = 0;
        int asIs = 0; // of the stated: right, and nothing is asked
        for (int i = 0; i < tables; ++i) {
            const testdata::WorkshopTable table = testdata::workshopTable(random);
            QString outcome;
            bool asked = true; // a refusal is said
            stated += table.statesUnits ? 1 : 0;
            try {
                const Imported imported = importMeasurement(table.bytes, "x.csv");
                const bool isTaken = std::ranges::all_of(imported.questions, &Question::canBeAssumed);
                taken += isTaken ? 1 : 0;
                if (isRight(imported, table)) {
                    asIs += table.statesUnits && imported.questions.empty() ? 1 : 0;
                    continue;
                }
                wrongTaken += isTaken ? 1 : 0;
                asked = std::ranges::any_of(imported.questions, isAboutThisFile);
                outcome = testdata::picture(imported) + '\n' + testdata::questions(imported);
            } catch (const Error &error) {
                outcome = Language(Language::Id::english).sentence(error.message);
            }
            ++wrong;
            silent += asked ? 0 : 1;
            qInfo("%d %s\n%s\n%s", i, qPrintable(table.description), qPrintable(table.text.left(600)),
                  qPrintable(outcome));
        }
        qInfo(
            "%d of %d tables wrong, %d of them silently; taken by --accept: %d, %d of them wrong; of %d that "
            "state unit and direction %d asked nothing and were right",
            wrong, tables, silent, taken, wrongTaken, stated, asIs);
        QCOMPARE(wrongTaken, 0);
        QVERIFY(asIs * 10 >= stated * 9);
        QCOMPARE(silent, 0);
        QVERIFY(wrong <= mostWrong);
    }

    /// Columns in another order, one more that says nothing, another delimiter, the other mark: the same
    /// numbers.
    void theFormChangesNoNumber() {
        std::mt19937 random(7);
        static const QStringList further{"Wxyz",   "B",         "s",         "Mean",
                                         "Remark", "Tolerance", "Temp (°C)", "Batch 7"};
        for (int trial = 0; trial < 200; ++trial) {
            const testdata::PlainTable table = testdata::plainTable(random);
            const QString expected = numbersOf(written(table.rows, u';', false));
            QVERIFY(!expected.isEmpty());
            for (const QChar delimiter : {u'\t', u'|', u',', u';'})
                QCOMPARE(numbersOf(written(table.rows, delimiter, false)), expected);
            for (const QChar delimiter : {u'\t', u'|', u';'})
                QCOMPARE(numbersOf(written(table.rows, delimiter, true)), expected);
            std::vector<qsizetype> order(static_cast<std::size_t>(table.rows.front().size()));
            std::iota(order.begin(), order.end(), 0);
            std::shuffle(order.begin(), order.end(), random);
            std::vector<QStringList> permuted;
            for (const QStringList &row : table.rows) {
                permuted.emplace_back();
                for (const qsizetype c : order)
                    permuted.back() << row[c];
            }
            QCOMPARE(numbersOf(written(permuted, u';', false)), expected);
            const auto at = static_cast<qsizetype>(random() % order.size());
            for (std::size_t i = 0; i < permuted.size(); ++i)
                permuted[i].insert(at, i == 0
                                           ? further[static_cast<qsizetype>(random() % 8)]
                                           : QString::number(static_cast<double>(random() % 70) / 10 + 18));
            QCOMPARE(numbersOf(written(permuted, u';', false)), expected);
        }
    }

    /// Pages with their headings again, comments and lines of text between the rows change no number; rising
    /// or falling, with rows of statistics behind.
    void pagesChangeNoNumber() {
        std::mt19937 random(5);
        for (int trial = 0; trial < 300; ++trial) {
            testdata::PlainTable table = testdata::plainTable(random);
            const QString expected = numbersOf(written(table.rows, u';', false));
            if (random() % 2 == 0)
                std::reverse(table.rows.begin() + 1, table.rows.end());
            const QStringList &head = table.rows.front();
            QStringList lines{head.join(u';')};
            for (std::size_t i = 1; i < table.rows.size(); ++i) {
                lines << table.rows[i].join(u';');
                if (i + 1 == table.rows.size())
                    break;
                switch (random() % 6) {
                case 0:
                    lines << "" << QString("Page %1").arg(i + 1) << head.join(u';');
                    break;
                case 1:
                    lines << "# stopped for lunch";
                    break;
                case 2:
                    lines << head.join(u';');
                    break;
                default:
                    break;
                }
            }
            if (random() % 2 == 0)
                lines << QString("Mean") + QString(";0.5").repeated(head.size() - 1);
            const QByteArray text = lines.join(u'\n').toUtf8();
            QVERIFY2(numbersOf(text) == expected, text.constData());
        }
    }

    /// Lists whose second reading stands at a target of its own: where those are none, whole passes may be
    /// without a reading; nothing else is lost, and it is asked.
    void ownTargetsMayBeNone() {
        std::mt19937 random(13);
        for (int trial = 0; trial < 300; ++trial) {
            const auto targets = static_cast<int>(2 + random() % 5);
            const auto often = static_cast<unsigned>(random() % 5); // in how many of four lines there is none
            QByteArray text = "Target (mm);Direction;Dev 1 (µm);Target (mm);Dev 2 (µm)\n";
            std::multiset<std::pair<double, double>> expected;
            bool asked = false;
            for (const bool up : {true, false}) {
                const bool any = random() % 3 > 0;
                for (int k = 0; k < targets; ++k) {
                    const int i = up ? k : targets - 1 - k;
                    const bool none = !any || random() % 4 < often;
                    const int one = static_cast<int>(random() % 90) + 1;
                    const int other = static_cast<int>(random() % 90) + 1;
                    text += QStringLiteral("%1;%2;%3;%4;%5\n")
                                .arg(i * 100)
                                .arg(up ? '+' : '-')
                                .arg(one)
                                .arg(none ? QString(random() % 2 ? "x" : "") : QString::number(i * 100 + 0.5))
                                .arg(other)
                                .toUtf8();
                    expected.insert({i * 100, one / 1000.0});
                    if (!none)
                        expected.insert({i * 100 + 0.5, other / 1000.0});
                    asked |= none;
                }
            }
            const Imported imported = importMeasurement(text, "x.csv");
            const auto &read = std::get<PositioningMeasurement>(imported.test->measurement);
            std::multiset<std::pair<double, double>> readings;
            for (const Run &run : read.runs) {
                for (std::size_t i = 0; i < run.deviations.size(); ++i) {
                    if (run.deviations[i])
                        readings.insert({read.targets[i], *run.deviations[i]});
                }
            }
            const bool hasOwn = expected.size() > static_cast<std::size_t>(2 * targets);
            QVERIFY2(!hasOwn || readings == expected || asked, text.constData());
            QVERIFY2(!asked || std::ranges::any_of(imported.questions, isAboutThisFile), text.constData());
        }
    }

    void textThatIsNoTableIsAskedAbout() {
        std::mt19937 random(11);
        int read = 0;
        for (int trial = 0; trial < 3000; ++trial) {
            const QByteArray text = testdata::randomText(random);
            try {
                const Imported imported = importMeasurement(text, "x.txt");
                ++read;
                QVERIFY2(std::ranges::any_of(imported.questions, isAboutThisFile), text.constData());
            } catch (const Error &error) {
                QVERIFY(!error.message.text.empty());
            }
        }
        QVERIFY(read > 50); // else nothing was tried
    }

private:
    static QByteArray written(const std::vector<QStringList> &rows, QChar delimiter, bool comma) {
        QString text;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            QString line = rows[i].join(delimiter);
            text += (comma && i > 0 ? line.replace('.', ',') : line) + '\n';
        }
        return text.toUtf8();
    }

    /// Targets and runs; empty for what cannot be read.
    static QString numbersOf(const QByteArray &text) {
        try {
            return testdata::picture(importMeasurement(text, "x.csv"));
        } catch (const Error &) {
            return {};
        }
    }

    /// Sign and correction to 20 °C are asked of every file: they say nothing about a doubt.
    static bool isAboutThisFile(const Question &question) {
        return question.id != "sign" && question.id != "correctionTo20";
    }
};

QTEST_GUILESS_MAIN(WorkshopTablesTest)
#include "workshoptables.moc"
