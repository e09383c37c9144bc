#include "report/readingtable.h"

#include "core/kernel/evaluation/positioningdata.h"

#include <QTest>

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
