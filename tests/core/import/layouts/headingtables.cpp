// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "core/import/importpicture.h"
#include "core/import/layouts/headingtable.h"
#include "core/import/layouts/workshoptable.h"
#include "import/importmeasurement.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <set>

using namespace palmer;

namespace {

const PositioningMeasurement *measurementOf(const Imported &imported) {
    return imported.test ? std::get_if<PositioningMeasurement>(&imported.test->measurement) : nullptr;
}

/// The group that a run is of; −1: of none, or of several. The numbers tell it in whatever unit they were
/// read.
int groupOf(const Run &run, const testdata::GroupedTable &table) {
    const auto isSame = [](double read, double written) {
        constexpr std::array factors{1e-3, 1.0, 25.4, 1.0 / 3600, 0.0254};
        return std::ranges::any_of(factors, [&](double factor) {
            return std::abs(std::abs(read) - written * factor) < 1e-9 * (1 + std::abs(read));
        });
    };
    for (std::size_t g = 0; g < table.groups.size(); ++g) {
        for (const std::vector<double> &column : table.groups[g]) {
            bool same = column.size() == run.deviations.size();
            for (std::size_t i = 0; same && i < column.size(); ++i)
                same = run.deviations[i] && isSame(*run.deviations[i], column[i]);
            if (same)
                return static_cast<int>(g);
        }
    }
    return -1;
}

/// Whether runs of several groups are read as those of one test.
bool isPooled(const Imported &imported, const testdata::GroupedTable &table) {
    const PositioningMeasurement *measurement = measurementOf(imported);
    std::set<int> groups;
    for (const Run &run : measurement ? measurement->runs : std::vector<Run>())
        groups.insert(groupOf(run, table));
    return groups.size() > 1;
}

QByteArray textOf(const testdata::PlainTable &table) {
    QByteArray text;
    for (const QStringList &row : table.rows)
        text += row.join(';').replace('.', ',').toUtf8() + '\n';
    return text;
}

} // namespace

/// Headings are whole, and what stands above a table is none of it.
class HeadingTablesTest : public QObject {
    Q_OBJECT

private slots:
    void groupsAreNotPooledInSilence_data() {
        QTest::addColumn<unsigned>("seed");
        // More of them when asked for: PALMER_SEEDS=33 makes 10 000.
        for (unsigned seed = 1; seed <= std::max(1U, qEnvironmentVariable("PALMER_SEEDS").toUInt()); ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }
    void groupsAreNotPooledInSilence() {
        QFETCH(unsigned, seed);
        constexpr int tables = 303;
        std::mt19937 random(seed);
        int pooled = 0;
        int taken = 0;
        int asked = 0;
        int refused = 0;
        for (int i = 0; i < tables; ++i) {
            const testdata::GroupedTable table = testdata::groupedTable(random);
            try {
                const Imported imported = importMeasurement(table.text, "x.csv");
                const bool isTaken = std::ranges::all_of(imported.questions, &Question::canBeAssumed);
                (isTaken ? taken : asked) += 1;
                if (isTaken && isPooled(imported, table)) {
                    ++pooled;
                    qInfo("%s\n%s\n%s", table.text.left(500).constData(),
                          qPrintable(testdata::picture(imported)), qPrintable(testdata::questions(imported)));
                }
            } catch (const Error &) {
                ++refused;
            }
        }
        qInfo("%d tables: pooled in silence %d, taken %d, asked %d, refused %d", tables, pooled, taken, asked,
              refused);
        QCOMPARE(pooled, 0);
    }

    void conditionsAboveChangeNoNumber_data() {
        QTest::addColumn<QByteArray>("block");
        for (const QByteArray &block : testdata::conditionBlocks())
            QTest::newRow(block.simplified().left(40).constData()) << block;
    }
    void conditionsAboveChangeNoNumber() {
        QFETCH(QByteArray, block);
        std::mt19937 random(3);
        for (int i = 0; i < 10; ++i) {
            const QByteArray text = textOf(testdata::plainTable(random));
            const Imported bare = importMeasurement(text, "x.csv");
            for (const char *gap : {"\n", ""}) {
                const Imported below = showMeasurement(block + gap + text, "x.csv", {});
                const bool isSame = measurementOf(below) &&
                                    measurementOf(below)->targets == measurementOf(bare)->targets &&
                                    measurementOf(below)->runs == measurementOf(bare)->runs;
                const bool isAsked = !std::ranges::all_of(below.questions, &Question::canBeAssumed);
                QVERIFY2(isSame || (*gap == 0 && isAsked),
                         qPrintable(QString::fromUtf8(block + gap + text) + testdata::picture(below) +
                                    testdata::questions(below)));
            }
        }
    }
};

QTEST_GUILESS_MAIN(HeadingTablesTest)
#include "headingtables.moc"
