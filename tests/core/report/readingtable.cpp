// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/tables/readingtable.h"

#include "core/kernel/evaluation/positioningdata.h"

#include <QTest>
#include <algorithm>
#include <map>
#include <random>

using namespace palmer;
using namespace palmer::testdata;
using namespace Qt::StringLiterals;

namespace {

QString titles(const PositioningMeasurement &measurement, ReadingGrouping grouping) {
    QStringList shown;
    for (const ReadingColumn &column : readingColumns(measurement, grouping))
        shown << (column.approach == Direction::positive ? u"↑"_s : u"↓"_s) + QString::number(column.number) +
                     (column.endsGroup ? u"|"_s : QString());
    return shown.join(u' ');
}

} // namespace

/// Columns and texts of the table of readings.
class ReadingTableTest : public QObject {
    Q_OBJECT

private slots:
    void columnsByRunAndByDirection() {
        Test test = positioningTest("ISO 230-2:2006", {0, 1}, {{1, 2}, {1, 2}, {1, 2}}, {{1, 2}, {1, 2}});
        QCOMPARE(titles(measurement(test), ReadingGrouping::byRun), u"↑1 ↓1| ↑2 ↓2| ↑3|"_s);
        QCOMPARE(titles(measurement(test), ReadingGrouping::byDirection), u"↑1 ↑2 ↑3| ↓1 ↓2|"_s);
    }

    void columnsKnowTheirRun() {
        Test test = positioningTest("ISO 230-2:2006", {0}, {{1}, {2}}, {{3}, {4}});
        std::vector<std::size_t> runs;
        for (const ReadingColumn &column : readingColumns(measurement(test), ReadingGrouping::byDirection))
            runs.push_back(column.run);
        QCOMPARE(runs, (std::vector<std::size_t>{0, 2, 1, 3}));
    }

    void deviationsAndPositions() {
        const Test test = example1988("ISO 230-2:1988");
        const auto &m = std::get<PositioningMeasurement>(test.measurement);
        const Language french(Language::Id::french);
        const ReadingTexts deviations(m, french, ReadingUnit::deviations);
        QCOMPARE(deviations.reading(0, 0).text, u"−3,0"_s);
        QCOMPARE(deviations.position(10), u"1\u202f500,41"_s);
        QCOMPARE(deviations.label(1, 1), u"i = 2 · ↓ 1 · 5,4\u00a0µm"_s);
        const ReadingTexts positions(m, french, ReadingUnit::positions);
        QCOMPARE(positions.reading(0, 0).text, u"−0,0030"_s);
        QCOMPARE(positions.reading(1, 10).text, u"1\u202f500,4070"_s);
        QCOMPARE(positions.statistic(0.00092), u"0,92"_s); // statistics stay deviations
    }

    void missingAndSetAside() {
        Test test = testdata::exactHand("ISO 230-2:2006");
        auto &m = measurement(test);
        m.runs[2].deviations[1].reset();
        m.runs[3].deviations[4].reset();
        m.excluded.push_back({4, 5, 0.0954, "beam interrupted"});
        const ReadingTexts texts(m, Language(Language::Id::english), ReadingUnit::deviations);
        QCOMPARE(texts.reading(2, 1), (ShownReading{u"–"_s, true, false, {}}));
        QCOMPARE(texts.reading(3, 4), (ShownReading{u"95.4"_s, false, true, u"beam interrupted"_s}));
    }

    /// Every cell finds its own reading among those set aside, in whatever order they are listed.
    void eachOfManySetAside() {
        std::mt19937 random(7);
        Test test = positioningTest("ISO 230-2:2006", std::vector<double>(40),
                                    std::vector<std::vector<double>>(9, std::vector<double>(40)), {});
        auto &m = measurement(test);
        std::map<std::pair<std::size_t, std::size_t>, QString> reasons;
        for (std::size_t run = 0; run < 9; ++run) {
            for (std::size_t target = 0; target < 40; ++target) {
                if (random() % 3 == 0)
                    continue;
                m.runs[run].deviations[target].reset();
                if (random() % 3 == 0)
                    continue; // missing
                const QString reason = QStringLiteral("%1/%2").arg(run).arg(target);
                reasons[{run, target}] = reason;
                m.excluded.push_back(
                    {static_cast<int>(run) + 1, static_cast<int>(target) + 1, 0.001, reason.toStdString()});
            }
        }
        std::ranges::shuffle(m.excluded, random);
        const ReadingTexts texts(m, Language(Language::Id::english), ReadingUnit::deviations);
        for (std::size_t run = 0; run < 9; ++run) {
            for (std::size_t target = 0; target < 40; ++target) {
                const auto found = reasons.find({run, target});
                QCOMPARE(texts.reading(run, target).excluded, found != reasons.end());
                QCOMPARE(texts.reading(run, target).reason,
                         found == reasons.end() ? QString() : found->second);
            }
        }
    }

    void summaryOfASelection() {
        const Test test = testdata::exactHand("ISO 230-2:2006");
        const auto &m = std::get<PositioningMeasurement>(test.measurement);
        const Language english(Language::Id::english);
        const ReadingTexts texts(m, english, ReadingUnit::deviations);
        using Places = std::vector<std::pair<std::size_t, std::size_t>>;
        QCOMPARE(texts.summary(Places{}), QString());
        QCOMPARE(texts.summary(Places{{0, 0}}), texts.label(0, 0));
        // Target 2 upwards: 2, 2, 4, 6, 6.
        QCOMPARE(texts.summary(Places{{0, 1}, {2, 1}, {4, 1}, {6, 1}, {8, 1}}),
                 u"5 readings: mean 4.00\u00a0µm, range 4.0\u00a0µm"_s);
    }

    void computedColumns() {
        const auto ids = [](const Test &test) {
            QStringList list;
            for (const StatisticColumn &column :
                 statisticColumns(evaluated(test), Language(Language::Id::english)))
                list << QString::fromStdString(column.id);
            return list.join(u' ');
        };
        QCOMPARE(ids(testdata::exactHand("ISO 230-2:2006")), u"mean+ mean- reversal s+ s- R"_s);
        QCOMPARE(ids(positioningTest("ISO 230-2:2006", {0, 1}, {{1, 2}, {1, 2}}, {})), u"mean+ s+ R+"_s);
        QCOMPARE(ids(positioningTest("ISO 230-2:2006", {0, 1}, {{1, 2}}, {{1, 2}})),
                 u"mean+ mean- reversal"_s);
    }
};

QTEST_APPLESS_MAIN(ReadingTableTest)
#include "readingtable.moc"
