// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/evaluatesheet.h"

#include <QTest>

using namespace palmer;

namespace {

using Range = std::pair<std::optional<double>, std::optional<double>>; // least, largest

SheetRow rowOf(const Range &permitted, std::optional<double> measured, std::optional<double> uncertainty) {
    SheetRow row;
    row.permitted = {permitted.first, permitted.second};
    row.measured = measured;
    row.uncertainty = uncertainty;
    return row;
}

SheetState stateOf(const SheetRow &row, Rule rule, std::span<const NamedTest> tests = {}) {
    return evaluateSheet({&row, 1}, {rule, 1.0}, tests).front().state;
}

/// A test "x1" with A = 7.8 µm, U = 3 µm, limit 12 µm, and G of both senses.
struct TestWithResults {
    TestEvaluation evaluation;
    std::vector<NamedTest> named{{"x1", &evaluation}};

    TestWithResults() {
        Parameter a;
        a.term.id = "A";
        a.value = 0.0078;
        a.expandedUncertainty = 0.003;
        a.limit = Limit{0.012, {}, ""};
        a.verdict = Verdict::conforms;
        Parameter e = a; // the validity at 20 °C is open
        e.term.id = "E";
        e.verdict = Verdict::notProven;
        Parameter m = a; // the limit was agreed for another edition
        m.term.id = "M";
        m.verdict.reset();
        Parameter f;
        f.term.id = "Fmin";
        f.term.also = "F";
        f.value = -0.004;
        f.bound = Bound::lower;
        f.limit = Limit{-0.003, {}, ""};
        f.verdict = Verdict::doesNotConform;
        Parameter g;
        g.term.id = "G";
        g.index = "XY";
        g.value = 0.002;
        Parameter other = g;
        other.index = "YX";
        other.value = 0.005;
        Parameter empty;
        empty.term.id = "R";
        evaluation.parameters = {a, e, m, f, g, other, empty};
    }
    [[nodiscard]] SheetResult of(const std::string &test, const std::string &parameter, Rule rule) const {
        SheetRow row;
        row.from = SheetSource{test, parameter};
        return evaluateSheet({&row, 1}, {rule, 1.0}, named).front();
    }
};

} // namespace

class EvaluateSheetTest : public QObject {
    Q_OBJECT

private slots:
    void rows_data();
    void rows();
    void rowsThatDoNotApply();
    void rowsFromTests();
    void verdicts_data();
    void verdicts();
    void findingsSayWhatIsMissing();
};

void EvaluateSheetTest::rows_data() {
    QTest::addColumn<Range>("permitted");
    QTest::addColumn<std::optional<double>>("measured");
    QTest::addColumn<std::optional<double>>("uncertainty");
    QTest::addColumn<Rule>("rule");
    QTest::addColumn<SheetState>("state");

    using O = std::optional<double>;
    const Range upTo20{{}, 20.0};
    const Range range{-10.0, 20.0};
    const auto row = [](const char *name, const Range &permitted, O measured, O u, Rule rule,
                        SheetState state) {
        QTest::newRow(name) << permitted << measured << u << rule << state;
    };
    constexpr Rule simple = Rule::simpleAcceptance;
    constexpr Rule proof = Rule::iso14253_1;
    row("at the limit", upTo20, 20.0, {}, simple, SheetState::conforms);
    row("above the limit", upTo20, 20.001, {}, simple, SheetState::doesNotConform);
    row("the magnitude counts", upTo20, -20.001, {}, simple, SheetState::doesNotConform);
    row("decimals are compared as written", upTo20, 0.1 + 0.2 + 19.7, {}, simple, SheetState::conforms);
    row("at the guard band", upTo20, 17.0, 3.0, proof, SheetState::conforms);
    row("within the guard band", upTo20, 17.001, 3.0, proof, SheetState::notProven);
    row("at its other end", upTo20, 23.0, 3.0, proof, SheetState::notProven);
    row("beyond the guard band", upTo20, 23.001, 3.0, proof, SheetState::doesNotConform);
    row("nothing is proven without U", upTo20, 1.0, {}, proof, SheetState::notProven);
    row("a range: its least value", range, -10.0, {}, simple, SheetState::conforms);
    row("a range: below it", range, -10.001, {}, simple, SheetState::doesNotConform);
    row("a range: guard at the lower end", range, -7.5, 3.0, proof, SheetState::notProven);
    row("a range: between both guards", range, -7.0, 3.0, proof, SheetState::conforms);
    row("a range: guard at the upper end", range, 17.5, 3.0, proof, SheetState::notProven);
    row("a range narrower than its guards", {{1.0}, {2.0}}, 1.5, 1.0, proof, SheetState::notProven);
    row("an empty row is not measured", upTo20, {}, {}, simple, SheetState::notMeasured);
    row("nor one without a limit", {}, {}, {}, simple, SheetState::notMeasured);
    row("a value without a limit", {}, 1.0, {}, simple, SheetState::noLimit);
    row("a tolerance of zero", {{}, {0.0}}, 0.0, {}, simple, SheetState::conforms);
}

void EvaluateSheetTest::rows() {
    QFETCH(Range, permitted);
    QFETCH(std::optional<double>, measured);
    QFETCH(std::optional<double>, uncertainty);
    QFETCH(Rule, rule);
    QFETCH(SheetState, state);
    QCOMPARE(stateOf(rowOf(permitted, measured, uncertainty), rule), state);
}

void EvaluateSheetTest::rowsThatDoNotApply() {
    SheetRow row = rowOf({{}, 20.0}, 30.0, {});
    row.notApplicable = "no C axis";
    QCOMPARE(stateOf(row, Rule::simpleAcceptance), SheetState::notApplicable);
}

void EvaluateSheetTest::rowsFromTests() {
    const TestWithResults tests;
    const SheetResult a = tests.of("x1", "A", Rule::iso14253_1);
    QCOMPARE(a.state, SheetState::conforms);
    QCOMPARE(a.value, std::optional(0.0078));
    QCOMPARE(a.uncertainty, std::optional(0.003));
    QCOMPARE(a.permitted.high, std::optional(0.012));
    QCOMPARE(a.test, std::optional(std::size_t{0}));
    QCOMPARE(tests.of("x1", "E", Rule::simpleAcceptance).state, SheetState::notProven);
    QCOMPARE(tests.of("x1", "M", Rule::simpleAcceptance).state, SheetState::noLimit);
    // A limit from below: −4 is less than −3.
    QCOMPARE(tests.of("x1", "F", Rule::simpleAcceptance).state, SheetState::doesNotConform);
    QCOMPARE(tests.of("x1", "G_XY", Rule::simpleAcceptance).value, std::optional(0.002));
    QCOMPARE(tests.of("x1", "G", Rule::simpleAcceptance).value, std::optional(0.005));
    QCOMPARE(tests.of("x1", "G", Rule::simpleAcceptance).state, SheetState::noLimit);
    const SheetResult empty = tests.of("x1", "R", Rule::simpleAcceptance);
    QCOMPARE(empty.state, SheetState::notMeasured);
    QCOMPARE(empty.gap, std::optional(SheetGap::noValue));
    QCOMPARE(tests.of("x1", "B", Rule::simpleAcceptance).gap, std::optional(SheetGap::noSuchParameter));
    QCOMPARE(tests.of("y1", "A", Rule::simpleAcceptance).gap, std::optional(SheetGap::noSuchTest));
    QCOMPARE(tests.of("", "A", Rule::simpleAcceptance).gap, std::optional(SheetGap::noSuchTest));
}

void EvaluateSheetTest::verdicts_data() {
    QTest::addColumn<std::vector<SheetState>>("states");
    QTest::addColumn<std::optional<Verdict>>("verdict");

    using S = std::vector<SheetState>;
    using V = std::optional<Verdict>;
    constexpr SheetState met = SheetState::conforms;
    QTest::newRow("no row") << S{} << V{};
    QTest::newRow("all met") << S{met, met} << V{Verdict::conforms};
    QTest::newRow("what does not apply does not count")
        << S{met, SheetState::notApplicable} << V{Verdict::conforms};
    QTest::newRow("nothing applies") << S{SheetState::notApplicable} << V{};
    QTest::newRow("an empty row") << S{met, SheetState::notMeasured} << V{Verdict::notProven};
    QTest::newRow("only empty rows") << S{SheetState::notMeasured} << V{Verdict::notProven};
    QTest::newRow("a row without limit") << S{met, SheetState::noLimit} << V{Verdict::notProven};
    QTest::newRow("no limit at all") << S{SheetState::noLimit} << V{};
    QTest::newRow("one exceeded") << S{met, SheetState::doesNotConform, SheetState::notMeasured}
                                  << V{Verdict::doesNotConform};
}

void EvaluateSheetTest::verdicts() {
    QFETCH(std::vector<SheetState>, states);
    QFETCH(std::optional<Verdict>, verdict);
    std::vector<SheetResult> results(states.size());
    for (std::size_t i = 0; i < states.size(); ++i)
        results[i].state = states[i];
    QCOMPARE(verdictOf(results), verdict);
}

void EvaluateSheetTest::findingsSayWhatIsMissing() {
    const TestWithResults tests;
    std::vector<SheetRow> rows(3);
    rows[0].from = SheetSource{"x1", "A"};
    rows[1].from = SheetSource{"y1", "A"};
    rows[2].from = SheetSource{"x1", "R"};
    rows[2].number = "P3";
    const auto found = findingsOf(rows, evaluateSheet(rows, {}, tests.named));
    QCOMPARE(found.size(), std::size_t{2});
    QCOMPARE(found[0].keys.front(), std::string("report.sheet[1].from"));
    QVERIFY(found[0].message.arguments.front() == Argument(std::string("2")));
    QVERIFY(found[1].message.arguments.front() == Argument(std::string("P3")));
}

QTEST_APPLESS_MAIN(EvaluateSheetTest)
#include "evaluatesheet.moc"
