// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/diagnosis/influences.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

using namespace palmer;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double radius = 150;      // mm
constexpr double feed = 1000 / 60.; // mm/s

/// Two axes that contour a circle, in small steps of time, each with its mechanics. Nothing in here knows a
/// signature of the circle.
struct BentMachine {
    double scaleX = 0, scaleY = 0;           ///< mm/mm
    double squareness = 0;                   ///< rad
    double lagX = 0, lagY = 0;               ///< s, pure delay
    double filterX = 0, filterY = 0;         ///< s, time constant of a first-order response
    double playX = 0, playY = 0;             ///< mm of lost motion
    double asideX = 0, asideY = 0;           ///< mm, stands to + of the other axis while moving to +
    double bowX = 0, bowY = 0;               ///< mm, ends to + of the other axis
    double waveX = 0, waveY = 0, pitch = 10; ///< mm
    double phase = 0;                        ///< of the waves in the centre, rad
    double growth = 0;                       ///< mm a turn
    double strokeX = 0, strokeY = 0;         ///< part of the stroke that is lost
};

struct Place {
    PathPosition position;
    double deviation = 0; ///< radial, mm
};

/// What a body does that follows with play: it is pushed from one side or the other.
class Follower {
public:
    explicit Follower(double play)
        : m_half(play / 2) {}
    double follow(double command) {
        m_at = std::clamp(m_at, command - m_half, command + m_half);
        return m_at;
    }

private:
    double m_half;
    double m_at = 0;
};

/// One turn after one turn of running in, from 20° on.
std::vector<Place> contour(const BentMachine &m, double sense) {
    constexpr int perTurn = 36000;
    const double omega = feed / radius;
    const double step = 2 * pi / perTurn / omega;
    const double start = 20 * pi / 180;
    Follower x(std::abs(m.playX));
    Follower y(std::abs(m.playY));
    const auto commandX = [&](double t) { return radius * std::cos(start + sense * omega * t); };
    const auto commandY = [&](double t) { return radius * std::sin(start + sense * omega * t); };
    double slowX = commandX(0);
    double slowY = commandY(0);
    std::vector<Place> places;
    for (int i = 0; i < 3 * perTurn; ++i) {
        const double t = i * step;
        const double x0 = commandX(t - m.lagX);
        const double y0 = commandY(t - m.lagY);
        slowX = m.filterX > 0 ? x0 + (slowX - x0) * std::exp(-step / m.filterX) : x0;
        slowY = m.filterY > 0 ? y0 + (slowY - y0) * std::exp(-step / m.filterY) : y0;
        // Play of negative size: the compensation overdoes it, the body runs ahead as much as it would lag.
        const double movedX = m.playX < 0 ? 2 * slowX - x.follow(slowX) : x.follow(slowX);
        const double movedY = m.playY < 0 ? 2 * slowY - y.follow(slowY) : y.follow(slowY);
        const double towardsX = commandX(t + step) > commandX(t) ? 1 : -1;
        const double towardsY = commandY(t + step) > commandY(t) ? 1 : -1;
        double px = movedX * (1 + m.scaleX) * (1 - m.strokeX) +
                    m.waveX * std::sin(2 * pi * movedX / m.pitch + m.phase);
        double py = movedY * (1 + m.scaleY) * (1 - m.strokeY) +
                    m.waveY * std::sin(2 * pi * movedY / m.pitch + m.phase);
        const double besideY = m.asideX / 2 * towardsX + m.bowX * (movedX / radius) * (movedX / radius);
        const double besideX = m.asideY / 2 * towardsY + m.bowY * (movedY / radius) * (movedY / radius);
        // The second axis leans away from the right angle.
        const double cx = px + besideX - std::sin(m.squareness) * py;
        const double cy = std::cos(m.squareness) * py + besideY;
        const double turns = double(i - 2 * perTurn) / perTurn;
        if (i < 2 * perTurn)
            continue;
        const double angle = start + sense * omega * t;
        Place place;
        place.position = {std::cos(angle), std::sin(angle), sense, radius, feed, turns};
        place.deviation = std::hypot(cx, cy) + m.growth * turns - radius;
        places.push_back(place);
    }
    return places;
}

} // namespace

Q_DECLARE_METATYPE(std::function<void(BentMachine &)>)

/// The columns against two axes that know nothing of them.
class Influences : public QObject {
    Q_OBJECT

private slots:
    void columnsAreWhatTheAxesDo_data();
    void columnsAreWhatTheAxesDo();
    void spikesBeginWhereAnAxisTurns();
    void wordsAreUnique();
    void unitsThereAndBack();
};

void Influences::columnsAreWhatTheAxesDo_data() {
    QTest::addColumn<InfluenceId>("id");
    QTest::addColumn<PlaneAxis>("axis");
    QTest::addColumn<double>("value");
    QTest::addColumn<double>("shape");
    QTest::addColumn<double>("shiftX"); // of the centre, mm
    QTest::addColumn<double>("shiftY");
    QTest::addColumn<std::function<void(BentMachine &)>>("set");
    using Set = std::function<void(BentMachine &)>;
    const auto none = PlaneAxis::none;
    const auto x = PlaneAxis::first;
    const auto y = PlaneAxis::second;
    const auto row = [](const char *name, InfluenceId id, PlaneAxis axis, double value, const Set &set,
                        double shape = 0, double shiftX = 0, double shiftY = 0) {
        QTest::newRow(name) << id << axis << value << shape << shiftX << shiftY << set;
    };
    row("both scales long", InfluenceId::radius, none, radius * 2e-6,
        [](BentMachine &m) { m.scaleX = m.scaleY = 2e-6; });
    row("X long, Y short", InfluenceId::scaleMismatch, none, 4e-6, [](BentMachine &m) {
        m.scaleX = 2e-6;
        m.scaleY = -2e-6;
    });
    row("angle above 90°", InfluenceId::squareness, none, 3e-6, [](BentMachine &m) { m.squareness = 3e-6; });
    row("angle below 90°", InfluenceId::squareness, none, -3e-6,
        [](BentMachine &m) { m.squareness = -3e-6; });
    row("X lags", InfluenceId::servoMismatch, none, 3e-5, [](BentMachine &m) { m.lagX = 3e-5; });
    row("Y lags", InfluenceId::servoMismatch, none, -3e-5, [](BentMachine &m) { m.lagY = 3e-5; });
    row("X loses motion", InfluenceId::backlash, x, 4e-4, [](BentMachine &m) { m.playX = 4e-4; });
    row("Y loses motion", InfluenceId::backlash, y, 4e-4, [](BentMachine &m) { m.playY = 4e-4; });
    row("X overcompensated", InfluenceId::backlash, x, -4e-4, [](BentMachine &m) { m.playX = -4e-4; });
    row("X steps aside", InfluenceId::lateralPlay, x, 4e-4, [](BentMachine &m) { m.asideX = 4e-4; });
    row("Y steps aside", InfluenceId::lateralPlay, y, 4e-4, [](BentMachine &m) { m.asideY = 4e-4; });
    row(
        "X on a bow", InfluenceId::straightness, x, 4e-4, [](BentMachine &m) { m.bowX = 4e-4; }, 0, 0, 1e-4);
    row(
        "Y on a bow", InfluenceId::straightness, y, 4e-4, [](BentMachine &m) { m.bowY = 4e-4; }, 0, 1e-4, 0);
    row(
        "X with its pitch", InfluenceId::cyclic, x, 4e-4, [](BentMachine &m) { m.waveX = 4e-4; }, 10);
    row(
        "Y with its pitch", InfluenceId::cyclic, y, 4e-4, [](BentMachine &m) { m.waveY = 4e-4; }, 10);
    for (const PlaneAxis axis : {x, y}) {
        row(
            axis == x ? "X with its pitch, of another phase" : "Y with its pitch, of another phase",
            InfluenceId::cyclic, axis, 4e-4,
            [axis](BentMachine &m) {
                (axis == PlaneAxis::first ? m.waveX : m.waveY) = 4e-4;
                m.phase = 0.5 * pi;
            },
            10);
    }
    row("both axes slow", InfluenceId::commonLag, none, 0.02 * 0.02,
        [](BentMachine &m) { m.filterX = m.filterY = 0.02; });
    const double omega = feed / radius;
    row("X loses stroke", InfluenceId::lagMismatch, none, 2 * 4e-6 / (omega * omega), [](BentMachine &m) {
        m.strokeX = 2e-6;
        m.strokeY = -2e-6;
    });
    row("radius grows", InfluenceId::radiusDrift, none, 4e-4, [](BentMachine &m) { m.growth = 4e-4; });
}

void Influences::columnsAreWhatTheAxesDo() {
    QFETCH(InfluenceId, id);
    QFETCH(PlaneAxis, axis);
    QFETCH(double, value);
    QFETCH(double, shape);
    QFETCH(double, shiftX);
    QFETCH(double, shiftY);
    QFETCH(std::function<void(BentMachine &)>, set);
    BentMachine machine;
    set(machine);
    for (const double sense : {1.0, -1.0}) {
        double largest = 0;
        for (const Place &place : contour(machine, sense)) {
            const PathPosition &p = place.position;
            // A body with play of 4e-4 mm begins to move √(2·4e-4/150) = 0.0023 after the axis has turned.
            if (std::min(std::abs(p.sine), std::abs(p.cosine)) < 3e-3)
                continue;
            const bool second = machine.phase != 0; // a quarter of a period on
            const double column =
                value * (second ? influence(id).second : influence(id).column)(p, axis, shape);
            const double expected = column + shiftX * p.cosine + shiftY * p.sine;
            // Deviations of 4e-4 mm on 150 mm: the second order is below 1e-8 mm; a delay turns the point by
            // 1e-5 of an angle, a body with play is 1e-6 late.
            const double off = std::abs(place.deviation - expected);
            QVERIFY2(off <= 2e-6, qPrintable(QStringLiteral("s %1, cos %2, sin %3: %4 instead of %5")
                                                 .arg(sense)
                                                 .arg(p.cosine)
                                                 .arg(p.sine)
                                                 .arg(place.deviation)
                                                 .arg(expected)));
            largest = std::max(largest, std::abs(column));
        }
        QVERIFY(largest > 4e-5); // twenty times the tolerance: the comparison says something
    }
}

void Influences::spikesBeginWhereAnAxisTurns() {
    constexpr double width = 2;
    for (const double sense : {1.0, -1.0}) {
        for (const PlaneAxis axis : {PlaneAxis::first, PlaneAxis::second}) {
            double since = -1; // unknown before the first reversal
            double last = 0;
            for (int i = 0; i <= 7200; ++i) {
                const double angle = sense * (i * 0.1 + 0.05) * pi / 180;
                const double velocity =
                    axis == PlaneAxis::first ? -sense * std::sin(angle) : sense * std::cos(angle);
                if (last * velocity < 0)
                    since = 0.05;
                last = velocity;
                if (since < 0)
                    continue;
                const PathPosition p{std::cos(angle), std::sin(angle), sense, radius, feed, 0};
                const double value = influence(InfluenceId::reversalSpike).column(p, axis, width);
                QVERIFY(std::abs(value - std::exp(-since / width)) < 1e-9);
                const double wider = influence(InfluenceId::reversalSpike).column(p, axis, width + 1e-5);
                const double slope = influence(InfluenceId::reversalSpike).second(p, axis, width);
                QVERIFY(std::abs((wider - value) / 1e-5 - slope) < 1e-5);
                since += 0.1;
            }
        }
    }
}

void Influences::wordsAreUnique() {
    for (const Influence &row : influences()) {
        QCOMPARE(&influence(row.id), &row);
        QCOMPARE(findInfluence(row.word), &row);
    }
    QVERIFY(!findInfluence("unknown"));
}

void Influences::unitsThereAndBack() {
    QCOMPARE(shownParameter(InfluenceId::backlash, 6e-3), 6.0);
    QCOMPARE(shownParameter(InfluenceId::scaleMismatch, 65e-6), 65.0);
    QCOMPARE(shownParameter(InfluenceId::squareness, 30e-6), 30.0);
    QCOMPARE(shownParameter(InfluenceId::servoMismatch, 6e-4), 0.6);
    QCOMPARE(shownParameter(InfluenceId::commonLag, -4e-4), -20.0);
    for (const Influence &row : influences()) {
        for (const double shown : {-3.0, 0.0, 0.5}) {
            const double back = shownParameter(row.id, baseParameter(row.id, shown));
            QVERIFY(std::abs(back - shown) < 1e-12);
        }
    }
}

QTEST_GUILESS_MAIN(Influences)
#include "influences.moc"
