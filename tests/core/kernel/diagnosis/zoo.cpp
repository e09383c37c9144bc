// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "core/kernel/diagnosis/zoo.h"

#include <QTest>

using namespace palmer;
using namespace palmer::testdata;

/// Five circles of each animal of the zoo; palmer-diagnosis-zoo makes 500.
class ZooTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QCOMPARE(animals.size(), std::size_t(40)); }
    void animal_data() {
        QTest::addColumn<int>("place");
        for (std::size_t k = 0; k < animals.size(); ++k)
            QTest::newRow(animals[k].name) << int(k);
    }
    void animal() {
        QFETCH(int, place);
        constexpr unsigned trials = 5;
        constexpr std::size_t points = 720;
        const ZooCounts counts = zooCounts(animals[std::size_t(place)], trials, points);
        QCOMPARE(counts.circles, int(trials));
        QVERIFY(counts.sources >= int(trials) * 9);
        // The seeds are fixed: 45 sources of an animal of which 90 % hold are 40 ± 2.
        QVERIFY2(counts.held() > 0.8, qPrintable(QString::number(counts.held())));
        QVERIFY2(counts.falseClaims <= 1, qPrintable(QString::number(counts.falseClaims)));
        m_sources += counts.sources;
        m_held += counts.held() * counts.sources;
        m_falseClaims += counts.falseClaims;
    }
    void all() {
        QVERIFY2(m_held > 0.9 * m_sources, qPrintable(QString::number(m_held / m_sources)));
        QVERIFY2(m_falseClaims <= 2, qPrintable(QString::number(m_falseClaims))); // 1 % of 200
    }
    /// Although lateral play takes most of it up.
    void theStepBetweenTheSensesIsNamed() {
        const auto *apart = std::ranges::find(animals, std::string_view("radii of the senses 3 µm apart"),
                                              [](const Animal &each) { return std::string_view(each.name); });
        QVERIFY(apart != animals.end());
        ZooCounts counts = zooCounts(*apart, 20, 720);
        QCOMPARE(counts.seen["a step of the radius between the senses"], 20);
    }
    /// What the diagnosis models is not called wrong.
    void whatFitsIsValid() {
        const ZooCounts counts = zooCounts(animals[0], 20, 720);
        QVERIFY2(counts.notValid <= 1, qPrintable(QString::number(counts.notValid)));
        QVERIFY(counts.intervals >= (20 - counts.notValid) * 9 - 3);
    }

private:
    int m_sources = 0;
    double m_held = 0;
    int m_falseClaims = 0;
};

QTEST_GUILESS_MAIN(ZooTest)
#include "zoo.moc"
