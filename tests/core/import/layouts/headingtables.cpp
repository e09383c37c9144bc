// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "core/import/importpicture.h"
#include "core/import/layouts/headingtable.h"
#include "core/import/layouts/workshoptable.h"
#include "import/importmeasurement.h"

#include <QDir>
#include <QRegularExpression>
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

    void conditionsAboveChangeNoNumber_data() { addBlocks(); }
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

    /// Likewise above each layout: those of the files of the tests, and those of workshops.
    void conditionsAboveAnyLayoutChangeNoNumber_data() { addBlocks(); }
    void conditionsAboveAnyLayoutChangeNoNumber() {
        QFETCH(QByteArray, block);
        int tried = 0;
        QStringList changed;
        for (const QByteArray &text : layouts()) {
            const QByteArray written = inTheFormOf(text, block);
            const Imported bare = showMeasurement(text, "x.csv", {});
            const Imported below = showMeasurement(written + '\n' + text, "x.csv", {});
            ++tried;
            if (numbersOf(below) != numbersOf(bare))
                changed << QString::fromUtf8(written + '\n' + text.left(300)) + numbersOf(bare).left(300) +
                               "\n>>>\n" + testdata::picture(below).left(400) + testdata::questions(below);
        }
        QVERIFY2(changed.isEmpty(),
                 qPrintable(QString("%1 of %2: ").arg(changed.size()).arg(tried) + changed.join("\n---\n")));
        QVERIFY(tried > 40);
    }

private:
    /// What was measured, without what a block may well say: the axis, the feed, temperatures.
    static QString numbersOf(Imported imported) {
        imported.sensors.clear();
        if (imported.test) {
            if (auto *axis = std::get_if<PositioningMeasurement>(&imported.test->measurement))
                axis->axis.name.clear();
            if (auto *drift = std::get_if<DriftMeasurement>(&imported.test->measurement))
                drift->axis.name.clear();
            if (auto *circles = std::get_if<CircularMeasurement>(&imported.test->measurement))
                circles->feed.reset();
        }
        return testdata::picture(imported);
    }

    static void addBlocks() {
        QTest::addColumn<QByteArray>("block");
        for (const QByteArray &block : testdata::conditionBlocks())
            QTest::newRow(block.simplified().left(40).constData()) << block;
    }

    /// Tables that can be read as they are.
    static const std::vector<QByteArray> &layouts() {
        static const auto all = [] {
            std::vector<QByteArray> texts;
            const QDir folder(DATA "tables");
            for (const QString &name : folder.entryList({"*.csv", "*.txt"})) {
                QFile file(folder.filePath(name));
                if (file.open(QIODevice::ReadOnly))
                    texts.push_back(file.readAll());
            }
            std::mt19937 random(8);
            while (texts.size() < 90)
                texts.push_back(testdata::workshopTable(random).text.toUtf8());
            std::erase_if(texts, [](const QByteArray &text) {
                return !text.isValidUtf8() || text.contains('\0') || !showMeasurement(text, "x.csv", {}).test;
            });
            return texts;
        }();
        return all;
    }

    /// With the delimiter and the decimal mark of a table.
    static QByteArray inTheFormOf(const QByteArray &table, QByteArray block) {
        const char delimiter =
            std::ranges::max({'\t', ';', '|', ','}, {}, [&](char c) { return table.count(c); });
        if (table.count(delimiter) == 0)
            return block.replace(',', '.').replace(';', "  ");
        static const QRegularExpression point("\\d\\.\\d+(?!\\.)\\b");
        if (delimiter == ',' || QString::fromUtf8(table).contains(point))
            block.replace(',', '.');
        return block.replace(';', delimiter);
    }
};

QTEST_GUILESS_MAIN(HeadingTablesTest)
#include "headingtables.moc"
