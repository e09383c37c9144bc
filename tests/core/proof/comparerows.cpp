// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/compare.h"

#include <QTest>
#include <random>

using namespace palmer;

namespace {

/// Lines of words on pages, as a table prints them: now and then with words before, between and behind, and
/// with values in two words.
class Pages {
public:
    explicit Pages(unsigned seed)
        : m_random(seed) {}

    void line(const QStringList &words) {
        if (m_pages.empty() || m_line > 20 || m_random() % 8 == 0) {
            m_pages.emplace_back();
            m_line = 0;
        }
        double x = 20;
        for (const QString &word : words) {
            const double drop = static_cast<double>(m_random() % 3); // words of one line are not equally high
            m_pages.back().push_back({word, QRectF(x, 15.0 * m_line + drop, 20, 9)});
            x += 30;
        }
        ++m_line;
    }

    void row(const PrintedRow &row, bool plain = false) {
        QStringList words;
        const auto noise = [&] {
            while (!plain && m_random() % 3 == 0)
                words << QStringLiteral("note%1").arg(m_random() % 10);
        };
        noise();
        words << row.label;
        for (const QString &value : row.values) {
            noise();
            if (!plain && value.size() > 2 && m_random() % 4 == 0)
                words << value.left(1) << value.mid(1);
            else
                words << value;
        }
        noise();
        line(words);
    }

    /// In any order, as a reader of columns gives them.
    std::vector<PrintedWords> take() {
        for (PrintedWords &page : m_pages)
            std::ranges::shuffle(page, m_random);
        return m_pages;
    }

private:
    std::mt19937 m_random;
    std::vector<PrintedWords> m_pages;
    int m_line = 0;
};

std::vector<PrintedRow> randomRows(std::mt19937 &random) {
    std::vector<PrintedRow> rows;
    const auto count = 1 + random() % 12;
    for (std::size_t i = 0; i < count; ++i) {
        PrintedRow row{QStringLiteral("S%1").arg(i), {}};
        for (auto k = 3 + random() % 2; k > 0; --k)
            row.values << QStringLiteral("%1,%2").arg(10 + random() % 90).arg(random() % 10);
        rows.push_back(row);
    }
    return rows;
}

} // namespace

class CompareRows : public QObject {
    Q_OBJECT

private slots:
    void rowsAreFoundInAnyLayout() {
        std::mt19937 random(1);
        for (unsigned trial = 0; trial < 300; ++trial) {
            const auto rows = randomRows(random);
            Pages pages(trial);
            for (const PrintedRow &row : rows) {
                pages.row(row);
                pages.line({QStringLiteral("other"), QStringLiteral("words")});
            }
            QVERIFY(compareRows(pages.take(), rows).empty());
        }
    }

    void aChangedValueIsFoundAtItsLine() {
        std::mt19937 random(2);
        for (unsigned trial = 0; trial < 300; ++trial) {
            const auto rows = randomRows(random);
            const std::size_t at = random() % rows.size();
            Pages pages(trial);
            QStringList forged;
            for (std::size_t i = 0; i < rows.size(); ++i) {
                PrintedRow row = rows[i];
                if (i == at) {
                    row.values[static_cast<qsizetype>(
                        random() % static_cast<std::size_t>(row.values.size()))] = QStringLiteral("7,77");
                    forged = QStringList{row.label} + row.values;
                }
                pages.row(row, i == at);
            }
            const auto found = compareRows(pages.take(), rows);
            QCOMPARE(found.size(), std::size_t(1));
            QVERIFY(found[0].page > 0);
            QVERIFY(!found[0].area.isEmpty());
            QCOMPARE(found[0].printed, forged.join(u' '));
            QCOMPARE(found[0].follows, (QStringList{rows[at].label} + rows[at].values).join(u' '));
        }
    }

    void anotherLabelOrAMissingRowIsNamed() {
        const std::vector<PrintedRow> rows{{"A", {"12,3", "0,4", "15"}}, {"R", {"5,0", "0,4", "8"}}};
        Pages other(1);
        other.row(rows[0]);
        other.row({"B", rows[1].values});
        const auto found = compareRows(other.take(), rows);
        QCOMPARE(found.size(), std::size_t(1));
        QCOMPARE(found[0].page, 0);
        QCOMPARE(found[0].follows, QStringLiteral("R 5,0 0,4 8"));
        QCOMPARE(compareRows({}, rows).size(), std::size_t(2));
        QVERIFY(compareRows({}, {}).empty());
    }

    /// The copy in the summary is right, that beside the results is not.
    void oneRightLineDoesNotHideAForgedOne() {
        const std::vector<PrintedRow> rows{{"A", {"12,3", "0,4", "15"}}};
        Pages pages(1);
        pages.row(rows[0]);
        pages.row({"A", {"12,3", "0,4", "16"}});
        QCOMPARE(compareRows(pages.take(), rows).size(), std::size_t(1));
    }

    /// The word of two tests stands twice.
    void equalRowsStandAsOftenAsTheyFollow() {
        const std::vector<PrintedRow> rows{{"Verdict", {"CONFORMS"}}, {"Verdict", {"CONFORMS"}}};
        Pages once(1);
        once.row(rows[0]);
        QCOMPARE(compareRows(once.take(), rows).size(), std::size_t(1));
        Pages twice(1);
        twice.row(rows[0]);
        twice.row(rows[0]);
        QVERIFY(compareRows(twice.take(), rows).empty());
    }

    /// 12,3 is not printed where 112,3 or 12,34 stands, and not before the label or in another order.
    void partsOfWordsAreNoValues_data() {
        QTest::addColumn<QStringList>("line");
        QTest::newRow("a digit before") << QStringList{"A", "112,3", "0,4"};
        QTest::newRow("a digit behind") << QStringList{"A", "12,34", "0,4"};
        QTest::newRow("a sign before") << QStringList{"A", "−12,3", "0,4"};
        QTest::newRow("before the label") << QStringList{"12,3", "A", "0,4"};
        QTest::newRow("in another order") << QStringList{"A", "0,4", "12,3"};
        QTest::newRow("another symbol") << QStringList{"A↑", "12,3", "0,4"};
    }
    void partsOfWordsAreNoValues() {
        QFETCH(const QStringList, line);
        Pages pages(1);
        pages.line(line);
        QCOMPARE(compareRows(pages.take(), {{"A", {"12,3", "0,4"}}}).size(), std::size_t(1));
    }
};

QTEST_APPLESS_MAIN(CompareRows)
#include "comparerows.moc"
