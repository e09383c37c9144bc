// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "kernel/thermal/response.h"

#include "core/kernel/thermal/computedresponse.h"
#include "core/kernel/thermal/simulatedrecords.h"

#include <QTest>
#include <limits>

using namespace palmer;
using namespace palmer::testdata;

namespace {

bool isNear(double actual, double expected, double relative) {
    return std::abs(actual - expected) <= relative * std::abs(expected);
}

/// The definition, as a double loop.
double slowVariation(const std::vector<double> &times, const std::vector<double> &values, double duration) {
    double result = 0;
    const double reach = duration + 1e-9 * (times.back() - times.front());
    for (std::size_t i = 0; i < times.size(); ++i) {
        for (std::size_t j = i; j < times.size() && times[j] <= times[i] + reach; ++j) {
            for (std::size_t k = i; k < j; ++k) {
                if (!std::isnan(values[k]) && !std::isnan(values[j]))
                    result = std::max(result, std::abs(values[k] - values[j]));
            }
        }
    }
    return result;
}

ThermalResponse of(const SimulatedRecord &record, bool settled = true, int temperatures = 1) {
    return thermalResponse(record.record(settled), temperatures);
}

} // namespace

class ThermalTest : public QObject {
    Q_OBJECT

private slots:
    void variationIsThatOfADoubleLoop() {
        std::mt19937_64 random(3);
        std::uniform_real_distribution<double> uniform;
        for (int round = 0; round < 60; ++round) {
            std::vector<double> times;
            std::vector<double> values;
            double time = -5;
            for (int i = 0; i < 40; ++i) {
                times.push_back(time);
                time += round % 3 == 0 ? 1 : 0.1 + uniform(random); // equal and any steps
                const bool isMissing = round % 2 == 0 && uniform(random) < 0.2;
                values.push_back(isMissing ? std::numeric_limits<double>::quiet_NaN()
                                           : std::floor(8 * uniform(random)) + 0.5 * round * uniform(random));
            }
            for (const double duration : {0.0, 1.0, 3.0, 7.5, 100.0}) {
                const auto found = variation(times, values, duration);
                QVERIFY(found);
                QCOMPARE(found->value, slowVariation(times, values, duration));
                QVERIFY(found->to - found->from <= duration + 1e-6);
                QCOMPARE(found->high - found->low, found->value);
            }
            QCOMPARE(variation(times, values, {})->value, slowVariation(times, values, 1e9));
        }
    }
    void variationOfPartOfTheRecordIsALowerBound() {
        const std::vector<double> times{0, 60, 120, 180, 600, 660};
        const std::vector<double> values{0, 1, 2, 3, 4, 5};
        QVERIFY(!variation(times, values, {})->isLowerBound);
        QVERIFY(variation(times, values, 661.0)->isLowerBound); // longer than the record
        QVERIFY(variation(times, values, 120.0)->isLowerBound); // a gap of 420 s
        std::vector<double> dense;
        for (int i = 0; i <= 20; ++i)
            dense.push_back(10 * i);
        QVERIFY(!variation(dense, dense, 200.0)->isLowerBound);
        QVERIFY(variation(dense, dense, 90.0)->isLowerBound); // gaps of 10 s
        QVERIFY(!variation({}, {}, {}));
    }
    /// A time without a value was not recorded.
    void missingValuesAreNoRecord() {
        const double none = std::numeric_limits<double>::quiet_NaN();
        const std::vector<double> times{0, 10, 20, 30, 40};
        QVERIFY(!variation(times, std::vector{none, 1.0, none, none, none}, 30.0));
        const std::vector values{none, 1.0, 3.0, 2.0, none};
        const auto found = variation(times, values, 30.0);
        QVERIFY(found && found->isLowerBound);
        QCOMPARE(found->recorded, 20.0);
    }
    void theWindowOfAWholeRecordIsTheRecord() {
        const std::vector<double> times{0, 10, 20, 30};
        const std::vector<double> values{0, 3, 1, 1};
        for (const std::optional<double> duration : {std::optional<double>(), std::optional(40.0)}) {
            const auto found = variation(times, values, duration);
            QCOMPARE(found->value, 3.0);
            QCOMPARE(std::pair(found->from, found->to), std::pair(0.0, 30.0));
        }
        QCOMPARE(variation(times, values, 10.0)->to, 10.0);
    }
    /// 0.1 + 0.2 is more than 0.3: a window of three steps holds four values all the same.
    void roundedTimesDoNotLeaveTheWindow() {
        std::vector<double> times;
        std::vector<double> values;
        for (int i = 0; i < 20; ++i) {
            times.push_back(0.1 * i);
            values.push_back(i);
        }
        QCOMPARE(variation(times, values, 0.3)->value, 3.0);
    }
    void responsesAgreeWithAnIndependentComputation() {
        for (const ComputedResponse &expected : computedResponses) {
            std::vector<double> times;
            for (std::size_t i = 0; i < expected.deviations.size(); ++i)
                times.push_back(60.0 * static_cast<double>(i) + 1000);
            const ThermalResponse found =
                thermalResponse({times, expected.deviations, expected.temperatures, 0, expected.settled});
            QCOMPARE(int(found.state), int(ResponseState::found));
            // S is flat at its minimum: τ is known to the root of its rounding, the script's τ to 1e-6.
            QVERIFY2(isNear(found.tau, expected.tau, 1e-5), qPrintable(QString::number(found.tau, 'g', 12)));
            QVERIFY(isNear(found.k, expected.k, 1e-5));
            QVERIFY(isNear(found.slope, expected.slope, 1e-4));
            QVERIFY(isNear(found.squares, expected.squares, 1e-7));
            QVERIFY(covers(found.kRange, 3) && covers(found.tauRange, 900) && covers(found.slopeRange, 2e-4));
        }
    }
    /// 120 records: of 95 % three standard deviations are 6 %. The table of 10³ is printed by
    /// palmer-thermal-coverage.
    void intervalsCoverTheTruth_data() {
        QTest::addColumn<int>("shape");
        QTest::addColumn<bool>("settled");
        QTest::newRow("step, settled") << int(Shape::step) << true;
        QTest::newRow("wave, start fitted") << int(Shape::wave) << false;
    }
    void intervalsCoverTheTruth() {
        QFETCH(int, shape);
        QFETCH(bool, settled);
        constexpr int records = 120;
        int found = 0;
        int ofK = 0;
        int ofTau = 0;
        for (unsigned i = 0; i < records; ++i) {
            Simulated truth;
            truth.step = 40;
            truth.shape = static_cast<Shape>(shape);
            truth.length = 4 * 3600.0;
            truth.noise = 0.1;
            const ThermalResponse response = of(simulated(truth, i), settled);
            if (response.state != ResponseState::found)
                continue;
            ++found;
            ofK += covers(response.kRange, truth.k) ? 1 : 0;
            ofTau += covers(response.tauRange, truth.tau) ? 1 : 0;
        }
        qInfo("found %d, k %d, tau %d of %d", found, ofK, ofTau, records);
        // Noise may look so slow that it explains as much as the response: rare.
        QVERIFY(found >= 0.95 * records);
        QVERIFY(ofK >= 0.89 * found);
        QVERIFY(ofTau >= 0.89 * found);
    }
    void noResponseIsClaimedWithoutOne() {
        int claimed = 0;
        for (unsigned i = 0; i < 60; ++i) {
            Simulated truth;
            truth.k = 0;
            truth.step = 40;
            truth.shape = Shape::wave;
            claimed += of(simulated(truth, i)).state == ResponseState::found ? 1 : 0;
        }
        QVERIFY2(claimed <= 9, qPrintable(QString::number(claimed))); // 5 %: more than 9 in one run of 10 000
    }
    void whatTheDataCannotCarry() {
        const SimulatedRecord good = simulated({}, 1);
        const double missing = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(int(of(good).state), int(ResponseState::found));
        SimulatedRecord uneven = good;
        uneven.times[30] += 0.2; // of 10 s
        QCOMPARE(int(of(uneven).state), int(ResponseState::noEqualSteps));
        SimulatedRecord bridged = good;
        bridged.temperatures[100] = bridged.temperatures[101] = missing;
        bridged.deviations[200] = missing;
        QCOMPARE(int(of(bridged).state), int(ResponseState::found));
        QVERIFY(std::isnan(of(bridged).rest[200]));
        bridged.temperatures[102] = missing;
        QCOMPARE(int(of(bridged).state), int(ResponseState::gapInTemperature));
        SimulatedRecord few = good;
        for (auto *column : {&few.times, &few.deviations, &few.temperatures})
            column->resize(6);
        QCOMPARE(int(of(few).state), int(ResponseState::tooFewValues));
        SimulatedRecord constant = good;
        std::ranges::fill(constant.temperatures, 20.0);
        QCOMPARE(int(of(constant).state), int(ResponseState::notProven));
        SimulatedRecord still = good; // enough values, none of which moves
        std::ranges::fill(still.deviations, 0.3);
        QCOMPARE(int(of(still).state), int(ResponseState::notProven));
        SimulatedRecord straight = good; // a temperature that rises evenly
        for (std::size_t i = 0; i < straight.times.size(); ++i) {
            straight.temperatures[i] = 1e-4 * straight.times[i];
            straight.deviations[i] = 5 * straight.temperatures[i] + 0.001 * std::sin(double(i));
        }
        QVERIFY(of(straight).state != ResponseState::found);
        const ThermalRecord coarse{good.times, good.deviations, good.temperatures, 1.0, true};
        QCOMPARE(int(thermalResponse(coarse).state), int(ResponseState::noisyTemperature));
    }
    /// A step early in a short record looks like a start that decays: nothing is said, unless the start is
    /// known.
    void aStartThatLooksLikeTheResponse() {
        int found = 0;
        for (unsigned i = 0; i < 40; ++i) {
            Simulated truth;
            truth.step = 40;
            found += of(simulated(truth, i), false).state == ResponseState::found ? 1 : 0;
        }
        QVERIFY2(found <= 2, qPrintable(QString::number(found)));
        QCOMPARE(int(of(simulated({}, 1)).state), int(ResponseState::found));
    }
    /// Without delay the deviations follow at once: no lower bound of τ.
    void aResponseWithoutDelay() {
        Simulated truth;
        truth.tau = 0.01;
        truth.shape = Shape::wave;
        const ThermalResponse response = of(simulated(truth, 2));
        QCOMPARE(int(response.state), int(ResponseState::found));
        QVERIFY(!response.tauRange.low && response.tauRange.high);
        QVERIFY(covers(response.kRange, 5));
    }
    void whatItExplains() {
        Simulated truth;
        truth.length = 24 * 3600.0;
        truth.step = 60;
        truth.noise = 0.01;
        const SimulatedRecord record = simulated(truth, 3);
        const ThermalResponse response = of(record);
        const auto ofRest = variation(response.times, response.rest, 1200.0);
        QVERIFY(isNear(response.variationWhenHeld(1, 1200) - ofRest->value,
                       2 * response.k * (1 - std::exp(-1200 / response.tau)), 1e-12));
        // A step at a tenth of 24 h: a tenth is left after ln 10 time constants.
        const auto end = response.warmUp(record.temperatures);
        QVERIFY(end);
        QVERIFY2(std::abs(*end - (8640 + truth.tau * std::log(10.0))) < 120,
                 qPrintable(QString::number(*end)));
        truth.shape = Shape::wave; // never steady
        const SimulatedRecord wave = simulated(truth, 3);
        QVERIFY(!of(wave).warmUp(wave.temperatures));
    }
};

QTEST_GUILESS_MAIN(ThermalTest)
#include "thermaltest.moc"
