// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/testfigures.h"

#include "core/kernel/uncertainty/uncertaintydata.h"
#include "kernel/simulation/simulate.h"

#include <QTest>

#include <numeric>

using namespace palmer;
using namespace palmer::testdata;
using namespace Qt::StringLiterals;

namespace {

constexpr long long trials = 20000;

TestEvaluation simulated(const Test &test) {
    static const Machine machine;
    Surroundings surroundings;
    surroundings.machine = &machine;
    SimulationOptions options;
    options.trials = trials;
    const auto result = simulate(test, surroundings, *findEdition(test.edition), options);
    surroundings.simulation = std::make_shared<const Simulation>(result.value());
    return evaluateTest(test, surroundings);
}

} // namespace

/// What a simulation gave, as a histogram.
class HistogramFigureTest : public QObject {
    Q_OBJECT

private slots:
    void showsWhatWasSimulated() {
        Test test = example1988("ISO 230-2:2006");
        stateX1(measurement(test));
        const TestEvaluation evaluation = simulated(test);
        const Parameter &a = *parameter(evaluation, "A");
        const auto figure = histogramFigure(test, evaluation, a, Language(Language::Id::english));
        QVERIFY(figure);
        QVERIFY(figure->title.contains(u"A"_s));
        QCOMPARE(figure->x.symbol, u"A"_s);
        QCOMPARE(figure->x.unit, u"µm"_s);
        QCOMPARE(figure->evaluated, a.simulated->value * 1000);
        QCOMPARE(figure->mean, a.simulated->mean * 1000);
        QCOMPARE(figure->coverage.from, a.simulated->low * 1000);
        QCOMPARE(figure->coverage.to, a.simulated->high * 1000);
        QCOMPARE(std::accumulate(figure->counts.begin(), figure->counts.end(), 0LL), trials);
        for (const double value :
             {figure->evaluated, figure->mean, figure->coverage.from, figure->coverage.to})
            QVERIFY(value > figure->x.from && value < figure->x.to);
        QVERIFY(figure->evaluatedText.contains(u"16.2"_s));
    }

    void aValueThatNeverDiffersIsShown() {
        Test test = example1988("ISO 230-2:2006");
        stateNothing(measurement(test));
        const TestEvaluation evaluation = simulated(test);
        const auto figure =
            histogramFigure(test, evaluation, *parameter(evaluation, "A"), Language(Language::Id::english));
        QVERIFY(figure);
        QCOMPARE(figure->width, 0.0);
        QVERIFY(figure->x.from < figure->evaluated && figure->evaluated < figure->x.to);
    }

    void nothingWithoutASimulation() {
        const Test test = example1988("ISO 230-2:2006");
        const TestEvaluation evaluation = evaluated(test);
        QVERIFY(
            !histogramFigure(test, evaluation, *parameter(evaluation, "A"), Language(Language::Id::english)));
    }
};

QTEST_APPLESS_MAIN(HistogramFigureTest)
#include "histogramfigure.moc"
