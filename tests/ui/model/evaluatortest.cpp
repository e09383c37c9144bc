// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/evaluator.h"
#include "core/kernel/uncertainty/uncertaintydata.h"
#include "document/savedocument.h"

#include <QSignalSpy>
#include <QTest>
#include <cmath>

using namespace palmer;
using palmer::ui::Evaluator;

namespace {

std::shared_ptr<const Document> example(const char *name) {
    return std::make_shared<const Document>(
        openDocument(QStringLiteral(":/examples/%1.palmer").arg(QLatin1StringView(name))));
}

/// A test of that many targets in ten runs.
std::shared_ptr<const Document> large(int targets, double deviation) {
    PositioningMeasurement measurement;
    for (int i = 0; i < targets; ++i)
        measurement.targets.push_back(i);
    for (int run = 0; run < 10; ++run) {
        measurement.runs.push_back(
            {run % 2 == 0 ? Direction::positive : Direction::negative,
             std::vector<std::optional<double>>(static_cast<std::size_t>(targets), deviation * run)});
    }
    auto test = std::make_shared<Test>();
    test->id = "large";
    test->edition = "ISO 230-2:2006";
    test->measurement = std::move(measurement);
    Document document;
    document.tests.push_back(std::move(test));
    return std::make_shared<const Document>(std::move(document));
}

} // namespace

class EvaluatorTest : public QObject {
    Q_OBJECT

private slots:
    void evaluatesSmallTestsInTheCall();
    void viewsChangeResultsAndNotTheDocument();
    void viewsBelongToOneTest();
    void forgetsViewsOfTestsThatAreGone();
    void evaluatesLargeTestsOnAThread();
    void tellsOnlyTheLatest();
    void tellsTheDocumentBeforeItsResults();
    void evaluatesForAnotherMachineOnAThread();
    void putsSimulationsOfLargeTestsOnAThread();
};

void EvaluatorTest::evaluatesSmallTestsInTheCall() {
    Evaluator evaluator;
    QSignalSpy evaluated(&evaluator, &Evaluator::evaluated);
    const auto document = example("rotary-axis");
    evaluator.setDocument(document);
    QCOMPARE(evaluated.count(), 1);
    QVERIFY(evaluator.current().document == document);
    QCOMPARE(evaluator.current().tests.size(), document->tests.size());
    QVERIFY(evaluator.current().tests[0]->verdict);
}

void EvaluatorTest::viewsChangeResultsAndNotTheDocument() {
    Evaluator evaluator;
    const auto document = example("iso230-2-1988-example");
    evaluator.setDocument(document);
    const double own = evaluator.current().tests[0]->parameters.front().value.value_or(0);
    evaluator.setView(0, "ISO 230-2:2006");
    const TestEvaluation &view = *evaluator.current().tests[0];
    QVERIFY(view.view);
    QVERIFY(!view.verdict);
    QCOMPARE(std::string(view.edition->word), std::string("ISO 230-2:2006"));
    QVERIFY(view.parameters.front().value.value_or(0) != own);
    QVERIFY(evaluator.current().document == document);
    QCOMPARE(document->tests[0]->edition, std::string("ISO 230-2:1988"));
    evaluator.setView(0, document->tests[0]->edition);
    QVERIFY(!evaluator.current().tests[0]->view);
}

void EvaluatorTest::viewsBelongToOneTest() {
    Evaluator evaluator;
    evaluator.setDocument(example("long-axis-with-zone"));
    evaluator.setView(1, "ISO 230-2:1988");
    QVERIFY(!evaluator.current().tests[0]->view);
    QVERIFY(evaluator.current().tests[1]->view);
}

void EvaluatorTest::forgetsViewsOfTestsThatAreGone() {
    Evaluator evaluator;
    const auto first = example("long-axis-with-zone");
    evaluator.setDocument(first);
    evaluator.setView(1, "ISO 230-2:1988");
    Document without = *first;
    without.tests.pop_back();
    evaluator.setDocument(std::make_shared<const Document>(without));
    evaluator.setDocument(first);
    QVERIFY(!evaluator.current().tests[1]->view);
}

void EvaluatorTest::evaluatesLargeTestsOnAThread() {
    Evaluator evaluator;
    QSignalSpy evaluated(&evaluator, &Evaluator::evaluated);
    const auto document = large(2000, 0.001); // 20 000 readings
    evaluator.setDocument(document);
    QCOMPARE(evaluated.count(), 0);
    QVERIFY(evaluator.isBusy());
    QTRY_COMPARE(evaluated.count(), 1);
    QVERIFY(!evaluator.isBusy());
    QVERIFY(evaluator.current().document == document);
}

void EvaluatorTest::tellsOnlyTheLatest() {
    Evaluator evaluator;
    QSignalSpy evaluated(&evaluator, &Evaluator::evaluated);
    std::shared_ptr<const Document> latest;
    for (int i = 1; i <= 5; ++i) {
        latest = large(2000, 0.001 * i);
        evaluator.setDocument(latest);
    }
    QTRY_VERIFY(!evaluator.isBusy());
    QTest::qWait(50); // what is not told by now will not be
    QCOMPARE(evaluated.count(), 1);
    QVERIFY(evaluator.current().document == latest);
}

void EvaluatorTest::tellsTheDocumentBeforeItsResults() {
    Evaluator evaluator;
    evaluator.setDocument(large(2000, 0.001));
    QTRY_VERIFY(!evaluator.isBusy());
    const std::vector<Finding> before = evaluator.current().tests[0]->findings;
    QSignalSpy awaiting(&evaluator, &Evaluator::awaiting);
    const auto document = large(1500, 0.002); // fewer targets
    evaluator.setDocument(document);
    QCOMPARE(awaiting.count(), 1);
    QVERIFY(evaluator.isBusy());
    const EvaluatedDocument &latest = evaluator.latest();
    QVERIFY(latest.document == document);
    QVERIFY(latest.isPending(0));
    QVERIFY(latest.tests[0]->findings == before); // they lag, so that nothing blinks
    QCOMPARE(latest.tests[0]->parameters.size(), evaluator.current().tests[0]->parameters.size());
    const auto &results = std::get<PositioningResults>(latest.tests[0]->results);
    QCOMPARE(results.targets.size(), std::size_t{1500});
    QVERIFY(std::isnan(results.targets[7].mean()));
    QTRY_VERIFY(!evaluator.isBusy());
    QVERIFY(!evaluator.latest().isPending(0));
    QVERIFY(!evaluator.latest().tests[0]->parameters.empty());
}

/// The test is the same, what it is evaluated with is not.
void EvaluatorTest::evaluatesForAnotherMachineOnAThread() {
    Evaluator evaluator;
    const auto document = large(2000, 0.001);
    evaluator.setDocument(document);
    QTRY_VERIFY(!evaluator.isBusy());
    auto other = std::make_shared<Document>(*document);
    other->machine.name = "another";
    evaluator.setDocument(other);
    QVERIFY(evaluator.isBusy());
    QTRY_VERIFY(!evaluator.isBusy());
    QVERIFY(evaluator.current().document == other);
}

void EvaluatorTest::putsSimulationsOfLargeTestsOnAThread() {
    palmer::Test test = *large(1001, 0.001)->tests[0];
    auto &m = std::get<PositioningMeasurement>(test.measurement);
    testdata::stateNothing(m);
    m.uncertainty.device.fixed = 1;
    m.uncertainty.trials = 100;
    Document document;
    document.tests.push_back(std::make_shared<const palmer::Test>(test));
    Evaluator evaluator;
    evaluator.setDocument(std::make_shared<const Document>(document));
    QTRY_VERIFY(!evaluator.isBusy());
    const auto simulation = simulateTest(evaluator.current(), 0, simulationOptions(test), {}, {});
    QVERIFY(simulation);
    const auto isBeside = [&] { return bool(evaluator.current().tests[0]->uncertainty.simulation); };

    evaluator.setSimulation(0, *simulation);
    QVERIFY(evaluator.isBusy());
    QVERIFY(!isBeside());
    QTRY_VERIFY(!evaluator.isBusy());
    QVERIFY(isBeside());

    // An edit that comes between does not lose it.
    Evaluator edited;
    edited.setDocument(std::make_shared<const Document>(document));
    QTRY_VERIFY(!edited.isBusy());
    edited.setSimulation(0, *simulation);
    test.title = "edited";
    document.tests[0] = std::make_shared<const palmer::Test>(test);
    edited.setDocument(std::make_shared<const Document>(document));
    QTRY_VERIFY(!edited.isBusy() && edited.current().tests[0]->uncertainty.simulation);
    QCOMPARE(edited.current().document->tests[0]->title, std::string("edited"));
}

QTEST_GUILESS_MAIN(EvaluatorTest)
#include "evaluatortest.moc"
