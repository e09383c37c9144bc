// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/numerics/risingindices.h"

#include <QTest>
#include <algorithm>
#include <random>

using namespace palmer;

/// Against a plain list of the same indices.
class RisingIndicesTest : public QObject {
    Q_OBJECT

private slots:
    void saysWhatAListSays() {
        std::mt19937 random(3);
        for (int trial = 0; trial < 500; ++trial) {
            const auto often = random() % 6; // how many of five are taken
            std::vector<std::size_t> list;
            RisingIndices indices;
            const std::size_t end = random() % 60;
            for (std::size_t i = random() % 3; i < end; ++i) {
                if (random() % 5 < often) {
                    list.push_back(i);
                    indices.add(i);
                }
            }
            QCOMPARE(indices.empty(), list.empty());
            QCOMPARE(indices.size(), list.size());
            for (std::size_t place = 0; place < list.size(); ++place)
                QCOMPARE(indices[place], list[place]);
            for (std::size_t index = 0; index < 62; ++index) {
                const auto at = std::ranges::find(list, index);
                const auto place = indices.placeOf(index);
                QCOMPARE(place.has_value(), at != list.end());
                if (place)
                    QCOMPARE(*place, static_cast<std::size_t>(at - list.begin()));
            }
            if (list.empty())
                continue;
            QCOMPARE(indices.front(), list.front());
            QCOMPARE(indices.back(), list.back());
            std::vector<std::size_t> walked;
            for (const auto &[first, size, place] : indices.stretches()) {
                QCOMPARE(place, walked.size());
                for (std::size_t i = first; i < first + size; ++i)
                    walked.push_back(i);
            }
            QCOMPARE(walked, list);
        }
    }

    void whatFollowsTakesOneStretch() {
        RisingIndices indices;
        for (std::size_t i = 7; i < 1007; ++i)
            indices.add(i);
        QCOMPARE(indices.stretches().size(), std::size_t{1});
        QVERIFY(RisingIndices::upTo(0).empty());
        RisingIndices counted;
        for (std::size_t i = 0; i < 9; ++i)
            counted.add(i);
        QVERIFY(RisingIndices::upTo(9) == counted);
        QVERIFY(RisingIndices::upTo(8) != counted);
    }
};

QTEST_GUILESS_MAIN(RisingIndicesTest)
#include "risingindices.moc"
