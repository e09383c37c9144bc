// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "figures/diagnosisfigure.h"

#include "core/madecircles.h"
#include "figures/figuretexts.h"

#include <QTest>

#include <cmath>

using namespace palmer;
using namespace palmer::testdata;

namespace {

Language english() {
    return Language(Language::Id::english);
}

DiagnosedTest diagnosed(const CircularSynthesis &asked) {
    return *diagnosedTest(evaluate(madeCircles({asked})), 0);
}

std::vector<DiagnosedTest> diagnosedFeeds() {
    const EvaluatedDocument evaluated = evaluate(madeCircles(threeFeeds()));
    std::vector<DiagnosedTest> tests;
    for (std::size_t i = 0; i < 3; ++i)
        tests.push_back(*diagnosedTest(evaluated, i));
    return tests;
}

} // namespace

/// Pictures of a diagnosis against what the circles were made from.
class DiagnosisFigureTest : public QObject {
    Q_OBJECT

private slots:
    void drawsBothSensesAndTheSyntheticPath() {
        const DiagnosedTest test = diagnosed(mixedCircle());
        const std::vector<std::size_t> all = prevailingSources(test);
        const CircleFigure figure = diagnosisFigure(test, english());
        QCOMPARE(figure.traces.size(), std::size_t(4));
        QCOMPARE(std::ranges::count(figure.traces, true, &CircleTrace::synthetic), 2);
        QCOMPARE(figure.arrows.size(), std::size_t(2));
        QVERIFY(!figure.envelope);
        QCOMPARE(figure.legend.size(), std::size_t(3) + (all.size() - 1) / 3);
        QVERIFY(figure.legend[2].text.startsWith("synthetic: Scale mismatch X–Y"));
        // About the fitted radius, which is 30 µm off the nominal one.
        for (const CircleTrace &trace : figure.traces) {
            double sum = 0;
            for (const TracePoint &point : trace.points)
                sum += point.deviation / double(trace.points.size());
            QVERIFY(std::abs(sum) < 0.5);
        }
    }

    void theSyntheticPathIsThatOfItsSources() {
        const DiagnosedTest test = diagnosed(mixedCircle());
        const auto place = [&](InfluenceId id) {
            return static_cast<std::size_t>(test.diagnosis.find(id) - test.diagnosis.sources.data());
        };
        const std::vector<std::size_t> chosen{place(InfluenceId::scaleMismatch)};
        const CircleFigure figure = diagnosisFigure(test, chosen, english(), {});
        int looked = 0;
        for (const CircleTrace &trace : figure.traces) {
            if (!trace.synthetic)
                continue;
            ++looked;
            for (const TracePoint &point : trace.points) {
                const double expected = 60e-3 * 150 / 2 * std::cos(point.angle * std::acos(-1.0) / 90);
                QVERIFY(std::abs(point.deviation - expected) < 0.05); // noise of 0.05 µm
            }
        }
        QCOMPARE(looked, 2);
        QVERIFY(std::ranges::none_of(diagnosisFigure(test, {}, english(), {}).traces,
                                     [](const CircleTrace &trace) { return trace.synthetic; }));
    }

    void saysInTheTableWhichPathIsSynthetic() {
        const QByteArray csv =
            figureCsv(diagnosisFigure(diagnosed(mixedCircle()), english()), english(), '.');
        QVERIFY(csv.contains("1 ↺,"));
        QVERIFY(csv.contains("3 ↺ *,"));
        QVERIFY(!csv.contains("2 ↻ *"));
    }

    void theRestIsTheNoise() {
        const DiagnosedTest test = diagnosed(mixedCircle());
        const LineFigure figure = residualFigure(test, english(), 0);
        std::size_t points = 0;
        double square = 0;
        for (const FigureLine &line : figure.lines) {
            for (const QPointF &point : line.points) {
                QVERIFY(point.x() >= 0 && point.x() <= 360);
                QVERIFY(point.y() >= figure.y.from && point.y() <= figure.y.to);
                square += point.y() * point.y();
                ++points;
            }
        }
        QCOMPARE(points, std::size_t(720));
        QVERIFY(std::abs(std::sqrt(square / double(points)) - 0.05) < 0.008); // µm
        // In the unit of deviations, whichever it is.
        const Language inMm = english().withUnits({LengthDisplay::millimetres, AngleDisplay::arcSeconds});
        for (const auto &[own, other] :
             {std::pair(figure, residualFigure(test, inMm, 0)),
              std::pair(spectrumFigure(test, english(), 0), spectrumFigure(test, inMm, 0))}) {
            QCOMPARE(own.y.unit, QString::fromUtf8("µm"));
            QCOMPARE(other.y.unit, QString::fromUtf8("mm"));
            QVERIFY(std::abs(other.y.to - own.y.to / 1000) < 1e-9);
            QVERIFY(std::abs(other.lines[0].points[7].y() - own.lines[0].points[7].y() / 1000) < 1e-12);
        }
        QCOMPARE(figure.x.ticks.size(), std::size_t(5));
        QCOMPARE(figure.x.ticks[1].label, QString("90° (+Y)"));
        QCOMPARE(figure.y.unit, QString("µm"));
    }

    void linesEndWhereTheAnglePassesZero() {
        CircularSynthesis asked = mixedCircle();
        asked.arc = {-120, 240};
        const LineFigure figure = residualFigure(diagnosed(asked), english(), 0);
        QCOMPARE(figure.lines.size(), std::size_t(4)); // each sense in two
        for (const FigureLine &line : figure.lines) {
            for (std::size_t i = 1; i < line.points.size(); ++i)
                QVERIFY(std::abs(line.points[i].x() - line.points[i - 1].x()) < 2);
        }
        QCOMPARE(std::ranges::count_if(figure.lines, [](const FigureLine &l) { return l.name.isEmpty(); }),
                 2);
    }

    void thinnedLinesKeepTheExtremes() {
        CircularSynthesis asked = mixedCircle();
        asked.points = 20'000;
        const DiagnosedTest test = diagnosed(asked);
        const auto extremes = [](const LineFigure &figure) {
            double least = 0;
            double most = 0;
            std::size_t points = 0;
            for (const FigureLine &line : figure.lines) {
                for (const QPointF &point : line.points) {
                    least = std::min(least, point.y());
                    most = std::max(most, point.y());
                }
                points += line.points.size();
            }
            return std::tuple(least, most, points);
        };
        const auto [least, most, points] = extremes(residualFigure(test, english(), 0));
        const auto [thinLeast, thinMost, thinPoints] = extremes(residualFigure(test, english(), 500));
        QCOMPARE(points, std::size_t(40'000));
        QVERIFY(thinPoints <= 2 * 4 * 502);
        QCOMPARE(thinLeast, least);
        QCOMPARE(thinMost, most);
    }

    void aVibrationStandsInTheSpectrum() {
        CircularSynthesis asked = mixedCircle();
        asked.points = 720;
        constexpr double waves = 150;
        asked.vibration = {1e-3, waves * asked.feed / 60 / (2 * std::acos(-1.0) * asked.radius)};
        const LineFigure figure = spectrumFigure(diagnosed(asked), english(), 0);
        QCOMPARE(figure.lines.size(), std::size_t(2));
        for (const FigureLine &line : figure.lines) {
            const auto highest =
                std::ranges::max_element(line.points, {}, [](const QPointF &p) { return p.y(); });
            QVERIFY(std::abs(highest->x() - waves) < 1e-6);
            QVERIFY(std::abs(highest->y() - 1) < 0.03);
        }
        QVERIFY(figure.x.to >= waves);
        QVERIFY(figure.y.to >= 1);
    }

    void feedsLieOverOneAnotherFromSlowToFast() {
        const std::vector<DiagnosedTest> tests = diagnosedFeeds();
        const std::vector<PathProfile> profiles = profilesAtFeeds(tests);
        QCOMPARE(profiles.size(), std::size_t(6));
        const CircleFigure figure = feedsFigure(tests, profiles, english(), {});
        QCOMPARE(figure.legend.size(), std::size_t(3));
        QCOMPARE(figure.legend[0].text, QString("500\u00A0mm/min"));
        QCOMPARE(figure.legend[2].layer, 2);
        std::vector<double> means(3);
        for (const CircleTrace &trace : figure.traces) {
            for (const TracePoint &point : trace.points)
                means[std::size_t(*trace.layer)] += point.deviation / double(2 * trace.points.size());
        }
        // The lag makes −qF²/2R of it: 0.0001 µm at 8.3 mm/s … 13.3 µm at 100 mm/s; the radius is 30 µm off.
        QVERIFY(std::abs(means[0] - 30 + 0.4e-3 / 2 * 8.3333 * 8.3333 / 150) < 0.2);
        QVERIFY(std::abs(means[2] - 30 + 0.4e-3 * 1e3 * 1e4 / 300) < 0.2);
        QVERIFY(means[0] > means[1] && means[1] > means[2]);
    }

    void aSourceOverTheFeed() {
        const std::vector<DiagnosedTest> tests = diagnosedFeeds();
        const LineFigure figure =
            overFeedFigure(tests, InfluenceId::servoMismatch, PlaneAxis::none, english());
        QCOMPARE(figure.lines.size(), std::size_t(3));
        const auto &values = figure.lines[0].points;
        QCOMPARE(values.size(), std::size_t(3));
        QCOMPARE(values[0].x(), 500.0);
        QCOMPARE(values[2].x(), 6000.0);
        QCOMPARE(figure.y.unit, QString("ms"));
        for (std::size_t i = 0; i < values.size(); ++i) {
            const double upper = figure.lines[1].points[i].y();
            const double lower = figure.lines[2].points[i].y();
            QVERIFY(lower < values[i].y() && values[i].y() < upper);
            QVERIFY(std::abs(values[i].y() - 0.4) < 2 * (upper - lower)); // ± 4 u … 8 u
            QVERIFY(figure.y.from <= lower && upper <= figure.y.to);
        }
        // No single circle tells a lag: it is seen as the radius that changes with the feed.
        const LineFigure lag = overFeedFigure(tests, InfluenceId::commonLag, PlaneAxis::none, english());
        const LineFigure radius = overFeedFigure(tests, InfluenceId::radius, PlaneAxis::none, english());
        QCOMPARE(lag.lines.size(), std::size_t(3));
        QCOMPARE(lag.lines[0].points, radius.lines[0].points);
        QCOMPARE(lag.title, radius.title);
    }

    void groupsTestsOfAPlaneAtSeveralFeeds() {
        auto asked = threeFeeds();
        asked.push_back(mixedCircle());
        asked.back().plane = {"Y", "Z"};
        asked.push_back(asked.front());
        asked.back().radius = 100;
        const EvaluatedDocument evaluated = evaluate(madeCircles(asked));
        const auto groups = testsAtSeveralFeeds(evaluated);
        QCOMPARE(groups.size(), std::size_t(1));
        QCOMPARE(groups[0], (std::vector<std::size_t>{0, 1, 2}));
    }

    void tooFewPointsGiveNone() {
        CircularSynthesis asked = mixedCircle();
        asked.points = 8;
        QVERIFY(!diagnosedTest(evaluate(madeCircles({asked})), 0));
    }
};

QTEST_APPLESS_MAIN(DiagnosisFigureTest)
#include "diagnosisfigure.moc"
