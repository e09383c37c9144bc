// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/kernel/evaluation/positioningdata.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace palmer;
using namespace palmer::testdata;

/// Identities that hold for every test, over thousands of random ones.
class Properties : public QObject {
    Q_OBJECT

private slots:
    void init() { m_random.seed(20061); }
    void orderOfParameters();
    void offsetChangesTheMeansOnly();
    void exchangingTheDirections();
    void scaling();
    void permutingTheRuns();
    void totalForAnyMeasurement();

private:
    static constexpr int rounds = 3000;

    std::mt19937_64 m_random;

    double uniform(double from, double to) { return std::uniform_real_distribution(from, to)(m_random); }
    std::size_t whole(std::size_t from, std::size_t to) {
        return std::uniform_int_distribution(from, to)(m_random);
    }

    Test randomTest(std::size_t leastRuns = 2) {
        const std::size_t m = whole(1, 14);
        std::vector<double> targets;
        for (std::size_t i = 0; i < m; ++i)
            targets.push_back(100.0 * static_cast<double>(i) + uniform(0, 50));
        std::vector<double> systematic[2];
        std::vector<double> scatter[2];
        for (int d = 0; d < 2; ++d) {
            for (std::size_t i = 0; i < m; ++i) {
                systematic[d].push_back(uniform(-20, 20));
                scatter[d].push_back(whole(0, 3) ? uniform(0, 3) : 0);
            }
        }
        std::vector<std::vector<double>> runs[2];
        for (int d = 0; d < 2; ++d) {
            const std::size_t n = whole(leastRuns, 8);
            for (std::size_t j = 0; j < n; ++j) {
                runs[d].emplace_back();
                for (std::size_t i = 0; i < m; ++i)
                    runs[d].back().push_back(systematic[d][i] + scatter[d][i] * uniform(-1, 1));
            }
        }
        return positioningTest("ISO 230-2:2014", std::move(targets), runs[0], runs[1]);
    }

    static double value(const TestEvaluation &evaluation, const char *id) {
        return *parameter(evaluation, id)->value * 1000;
    }
};

void Properties::orderOfParameters() {
    const double rounding = 1e-10; // µm; values up to 50 µm
    for (int round = 0; round < rounds; ++round) {
        for (const char *edition : {"ISO 230-2:1988", "ISO 230-2:2014"}) {
            const auto e = evaluated(randomTest(), edition);
            QVERIFY(value(e, "R") >= std::max(value(e, "R+"), value(e, "R-")) - rounding);
            QVERIFY(value(e, "A") >= std::max({value(e, "A+"), value(e, "A-"), value(e, "R")}) - rounding);
            if (e.edition->c == 3)
                continue;
            QVERIFY(value(e, "A") >= value(e, "E") - rounding);
            QVERIFY(value(e, "E") >=
                    std::max({value(e, "E+"), value(e, "E-"), value(e, "M"), value(e, "B")}) - rounding);
            QVERIFY(value(e, "M") <= (value(e, "E+") + value(e, "E-")) / 2 + rounding);
            QVERIFY(value(e, "B") >= std::abs(value(e, "Bmean")) - rounding);
            QCOMPARE(value(e, "UPR"), std::min(value(e, "R+"), value(e, "R-")));
        }
    }
}

void Properties::offsetChangesTheMeansOnly() {
    for (int round = 0; round < rounds / 3; ++round) {
        Test test = randomTest();
        const auto before = evaluated(test);
        const double offset = uniform(-1, 1); // mm
        for (Run &run : measurement(test).runs) {
            for (auto &reading : run.deviations)
                *reading += offset;
        }
        const auto after = evaluated(test);
        // adding 1 mm to 1 nm costs digits: 1e-16 of it per operation
        for (std::size_t k = 0; k < before.parameters.size(); ++k)
            QVERIFY(std::abs(*after.parameters[k].value - *before.parameters[k].value) < 1e-13);
        const auto &old = std::get<PositioningResults>(before.results).targets;
        const auto &moved = std::get<PositioningResults>(after.results).targets;
        for (std::size_t i = 0; i < old.size(); ++i) {
            QVERIFY(std::abs(moved[i].positive.mean - old[i].positive.mean - offset) < 1e-14);
            QVERIFY(std::abs(moved[i].negative.s - old[i].negative.s) < 1e-13);
        }
    }
}

void Properties::exchangingTheDirections() {
    for (int round = 0; round < rounds / 3; ++round) {
        Test test = randomTest();
        const auto before = evaluated(test);
        for (Run &run : measurement(test).runs)
            run.approach = run.approach == Direction::positive ? Direction::negative : Direction::positive;
        const auto after = evaluated(test);
        for (const auto &[a, b] : {std::pair{"A+", "A-"}, {"E+", "E-"}, {"R+", "R-"}}) {
            QCOMPARE(value(after, a), value(before, b));
            QCOMPARE(value(after, b), value(before, a));
        }
        for (const char *id : {"A", "E", "M", "R", "B", "UPR"})
            QVERIFY(std::abs(value(after, id) - value(before, id)) < 1e-12);
        QCOMPARE(value(after, "Bmean"), -value(before, "Bmean"));
    }
}

void Properties::scaling() {
    for (int round = 0; round < rounds / 3; ++round) {
        Test test = randomTest();
        const auto before = evaluated(test);
        const double factor = uniform(-3, 3);
        for (Run &run : measurement(test).runs) {
            for (auto &reading : run.deviations)
                *reading *= factor;
        }
        const auto after = evaluated(test);
        for (const char *id : {"A", "A+", "E", "E-", "M", "R", "R+", "B", "UPR"})
            QVERIFY(std::abs(value(after, id) - std::abs(factor) * value(before, id)) < 1e-10);
        QVERIFY(std::abs(value(after, "Bmean") - factor * value(before, "Bmean")) < 1e-10);
    }
}

void Properties::permutingTheRuns() {
    for (int round = 0; round < rounds / 3; ++round) {
        Test test = randomTest();
        const auto before = evaluated(test);
        std::ranges::shuffle(measurement(test).runs, m_random);
        const auto after = evaluated(test);
        for (std::size_t k = 0; k < before.parameters.size(); ++k)
            QVERIFY(std::abs(*after.parameters[k].value - *before.parameters[k].value) < 1e-15);
    }
}

void Properties::totalForAnyMeasurement() {
    for (int round = 0; round < rounds; ++round) {
        Test test = randomTest(0);
        PositioningMeasurement &m = measurement(test);
        m.axis.motion = whole(0, 1) ? Motion::linear : Motion::rotary;
        if (whole(0, 1))
            m.axis.travel = uniform(1, 9000);
        if (whole(0, 1))
            m.axis.range = Interval{-10, uniform(0, 2000)};
        if (whole(0, 1))
            m.zone = Interval{uniform(-1, 1), uniform(500, 3000)};
        m.standardDeviation = whole(0, 3) ? DeviationMethod::calculation : DeviationMethod::range;
        m.targetChoice.kind = static_cast<TargetChoiceKind>(whole(0, 3));
        if (whole(0, 1))
            m.targetChoice.interval = uniform(0, 200);
        if (whole(0, 1))
            m.targetChoice.period = uniform(0, 20);
        for (Run &run : m.runs) {
            for (auto &reading : run.deviations) {
                if (whole(0, 5) == 0)
                    reading.reset();
            }
        }
        if (whole(0, 4) == 0)
            m.targets.clear();
        for (const Edition *edition : editions()) {
            if (edition->kind != Kind::positioning)
                continue;
            const auto e = evaluated(test, edition->word);
            for (const Parameter &p : e.parameters) {
                QVERIFY(!p.value || std::isfinite(*p.value));
                QVERIFY(p.value || finding(e, "noValue"));
                for (const auto &ruling : p.ruling)
                    QVERIFY(!ruling ||
                            (ruling->target >= 1 && ruling->target <= static_cast<int>(m.targets.size())));
            }
        }
    }
}

QTEST_GUILESS_MAIN(Properties)
#include "properties.moc"
