// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/figures/bandoverlap.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>

using namespace palmer;

namespace {

/// Limits of a band at x; nothing outside its targets.
std::optional<std::pair<double, double>> at(const std::vector<BandPoint> &band, double x) {
    for (std::size_t i = 1; i < band.size(); ++i) {
        const BandPoint &a = band[i - 1];
        const BandPoint &b = band[i];
        if (x < a.x || x > b.x)
            continue;
        const double t = b.x > a.x ? (x - a.x) / (b.x - a.x) : 0;
        return std::pair{a.lower + t * (b.lower - a.lower), a.upper + t * (b.upper - a.upper)};
    }
    return std::nullopt;
}

} // namespace

/// Where the limits of two directions lie over each other.
class BandOverlap : public QObject {
    Q_OBJECT

private slots:
    void crossingBands();
    void bandsApart();
    void oneInsideTheOther();
    void bandsOfOneTarget();
    void agreesWithTheLimitsEverywhere();
};

void BandOverlap::crossingBands() {
    // One rises from −1…1 to 3…5, the other lies at 2…3: they meet where the first reaches 2 (x = 2.5) and
    // part where its lower limit passes 3 (x = 10).
    const auto overlaps = bandOverlap({{0, -1, 1}, {10, 3, 5}}, {{0, 2, 3}, {10, 2, 3}});
    QCOMPARE(overlaps.size(), std::size_t{1});
    const auto &overlap = overlaps.front();
    QCOMPARE(overlap.front().x, 2.5);
    QCOMPARE(overlap.front().lower, 2.0);
    QCOMPARE(overlap.front().upper, 2.0);
    QCOMPARE(overlap.back().x, 10.0);
    // Corners where the upper (x = 5) and the lower limits (x = 7.5) cross.
    QVERIFY(std::ranges::any_of(overlap, [](const BandPoint &p) { return p.x == 5 && p.upper == 3; }));
    QVERIFY(std::ranges::any_of(overlap, [](const BandPoint &p) { return p.x == 7.5 && p.lower == 2; }));
}

void BandOverlap::bandsApart() {
    QVERIFY(bandOverlap({{0, 0, 1}, {10, 0, 1}}, {{0, 2, 3}, {10, 2, 3}}).empty());
    QVERIFY(bandOverlap({{0, 0, 1}, {10, 0, 1}}, {{20, 0, 1}, {30, 0, 1}}).empty());
}

void BandOverlap::oneInsideTheOther() {
    const auto overlaps = bandOverlap({{0, 0, 9}, {10, 0, 9}, {20, 0, 9}}, {{10, 4, 5}, {20, 3, 6}});
    QCOMPARE(overlaps.size(), std::size_t{1});
    QCOMPARE(overlaps.front(), (std::vector<BandPoint>{{10, 4, 5}, {20, 3, 6}}));
}

void BandOverlap::bandsOfOneTarget() {
    QVERIFY(bandOverlap({{0, 0, 1}}, {{0, 0, 1}, {1, 0, 1}}).empty());
    QVERIFY(bandOverlap({}, {}).empty());
}

void BandOverlap::agreesWithTheLimitsEverywhere() {
    std::mt19937_64 random(3);
    const auto uniform = [&](double from, double to) {
        return std::uniform_real_distribution(from, to)(random);
    };
    for (int round = 0; round < 300; ++round) {
        std::vector<BandPoint> bands[2];
        for (auto &band : bands) {
            double x = uniform(0, 3);
            for (int i = 0; i < 8; ++i, x += uniform(0.1, 2)) {
                const double middle = uniform(-2, 2);
                const double half = uniform(0.1, 1.5);
                band.push_back({x, middle - half, middle + half});
            }
        }
        const auto overlaps = bandOverlap(bands[0], bands[1]);
        for (int sample = 0; sample < 200; ++sample) {
            const double x = uniform(0, 18);
            const auto a = at(bands[0], x);
            const auto b = at(bands[1], x);
            double expected = 0;
            if (a && b)
                expected = std::max(0.0, std::min(a->second, b->second) - std::max(a->first, b->first));
            double found = 0;
            for (const auto &overlap : overlaps) {
                if (const auto here = at(overlap, x))
                    found = std::max(found, here->second - here->first);
            }
            // A few operations on numbers of at most 4.
            QVERIFY2(std::abs(found - expected) < 1e-12, qPrintable(QString::number(x)));
        }
    }
}

QTEST_GUILESS_MAIN(BandOverlap)
#include "bandoverlap.moc"
