// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/conditionsform.h"

#include "document/evaluateddocument.h"
#include "document/fieldvalue.h"
#include "kernel/measurement/testfacts.h"

#include <QTest>
#include <algorithm>
#include <map>
#include <memory>

using namespace palmer;

namespace {

std::map<std::string, int> cellsOf(const ConditionsForm &form) {
    std::map<std::string, int> cells;
    for (const auto *groups : {&form.asked, &form.usual, &form.other}) {
        for (const FormGroup &group : *groups) {
            for (const FormCell &cell : group.cells)
                ++cells[std::string(cell.key) + '/' + std::string(cell.part)];
        }
    }
    return cells;
}

bool has(const std::vector<FormGroup> &groups, std::string_view key) {
    return std::ranges::any_of(groups, [key](const FormGroup &group) {
        return std::ranges::find(group.cells, key, &FormCell::key) != group.cells.end();
    });
}

TestEvaluation evaluationOf(const Test &test) {
    auto document = std::make_shared<Document>();
    document->tests.push_back(std::make_shared<const Test>(test));
    return *evaluate(std::shared_ptr<const Document>(document)).tests[0];
}

Test axisTest(const Edition &edition, Motion motion) {
    Test test = testOf(Kind::positioning);
    test.edition = edition.word;
    auto &measurement = std::get<PositioningMeasurement>(test.measurement);
    measurement.axis.motion = motion;
    measurement.targets = {0, 100, 200};
    measurement.runs = {{Direction::positive, {0., 0., 0.}}, {Direction::negative, {0., 0., 0.}}};
    return test;
}

} // namespace

/// What the conditions are asked for.
class ConditionsFormTest : public QObject {
    Q_OBJECT

private slots:
    /// In every edition each key of the conditions has its place, once, and what is missing can be stated.
    void everyStatementHasOnePlace_data() {
        QTest::addColumn<QString>("edition");
        QTest::addColumn<bool>("rotary");
        for (const Kind kind : {Kind::positioning, Kind::circular}) {
            for (const Edition *edition : editionsOf(kind)) {
                for (const bool rotary : {false, true}) {
                    if (kind == Kind::positioning || !rotary)
                        QTest::addRow("%s %s", edition->word, rotary ? "rotary" : "linear")
                            << QString::fromUtf8(edition->word) << rotary;
                }
            }
        }
    }
    void everyStatementHasOnePlace() {
        QFETCH(QString, edition);
        QFETCH(bool, rotary);
        const Edition &rules = *findEdition(edition.toStdString());
        Test test = testOf(Kind::circular);
        test.edition = rules.word;
        if (rules.kind == Kind::positioning)
            test = axisTest(rules, rotary ? Motion::rotary : Motion::linear);
        const TestEvaluation evaluation = evaluationOf(test);
        const ConditionsForm form = conditionsForm(test, evaluation);
        const auto cells = cellsOf(form);
        for (const auto &[cell, count] : cells)
            QVERIFY2(count == 1, cell.c_str());
        const auto hasCell = [&](std::string_view key) {
            return has(form.asked, key) || has(form.usual, key) || has(form.other, key);
        };
        for (const std::string_view key : conditionKeys(test)) {
            const bool withAnother = key == "expansion"; // stated with its sensor
            const bool ofAnotherAxis = key == "continuousDevice" && !rotary;
            QVERIFY2(hasCell(key) != (withAnother || ofAnotherAxis), std::string(key).c_str());
        }
        for (const Finding &finding : evaluation.findings) {
            if (!finding.missing || finding.subject != Subject::conditions)
                continue;
            const std::string key = finding.keys.front().substr(finding.keys.front().rfind('.') + 1);
            // α stands beside the temperatures, the plane above the table of points.
            QVERIFY2(key == "expansion" || key == "plane" || has(form.asked, key) || has(form.usual, key),
                     key.c_str());
        }
    }

    void onlyWhatApplies() {
        const Edition &edition = *findEdition("ISO 230-2:2006");
        Test test = axisTest(edition, Motion::linear);
        auto &measurement = std::get<PositioningMeasurement>(test.measurement);
        const auto form = [&] { return conditionsForm(test, evaluationOf(test)); };
        QCOMPARE(cellsOf(form()).count("faces/"), std::size_t(0));
        QCOMPARE(cellsOf(form()).count("zone/"), std::size_t(0));
        measurement.targetChoice.kind = TargetChoiceKind::polygon;
        QVERIFY(has(form().asked, "faces"));
        QCOMPARE(cellsOf(form()).count("targetChoice/period"), std::size_t(0));
        measurement.targetChoice.period = 2; // stated, so that it can be removed
        QCOMPARE(cellsOf(form()).count("targetChoice/period"), std::size_t(1));
        measurement.axis.travel = 3000;
        QVERIFY(has(form().asked, "zone"));
        QVERIFY(has(form().asked, "dwell") && has(form().usual, "load") && has(form().other, "motion"));
    }

    /// VDI/DGQ 3441 was not read and asks for nothing by itself: what is usual stands in view.
    void anEditionThatAsksForNothing() {
        const Test test = axisTest(*findEdition("VDI/DGQ 3441:1977"), Motion::linear);
        const ConditionsForm form = conditionsForm(test, evaluationOf(test));
        QVERIFY(has(form.asked, "otherAxes") && has(form.asked, "load"));
    }

    void groupsThatLackSomething() {
        Test test = axisTest(*findEdition("ISO 230-2:2006"), Motion::linear);
        const auto lacks = [&](std::string_view key) {
            const ConditionsForm form = conditionsForm(test, evaluationOf(test));
            for (const FormGroup &group : form.asked) {
                if (std::ranges::find(group.cells, key, &FormCell::key) != group.cells.end())
                    return group.lacks;
            }
            return false;
        };
        QVERIFY(lacks("warmUp"));
        QVERIFY(!lacks("title"));
        auto &warmUp = conditionsOf(test)->warmUp;
        warmUp.kind = WarmUpKind::procedure;
        warmUp.text = "60 min";
        warmUp.specifiedBy = SpecifiedBy::maker;
        QVERIFY(!lacks("warmUp"));
    }

    void clausesOfDeclarations() {
        QCOMPARE(clauseOfDeclaration(*findEdition("ISO 230-2:2006"), "complete"), std::string("3.2"));
        QCOMPARE(clauseOfDeclaration(*findEdition("ISO 230-4:2005"), "shielded"), std::string("4.1"));
        QCOMPARE(clauseOfDeclaration(*findEdition("ISO 230-2:2014"), "complete"), std::string());
        QCOMPARE(declarationKeys().size(), std::size_t(5));
    }

    void noConditions() {
        const Test test = testOf(Kind::drift);
        const ConditionsForm form = conditionsForm(test, evaluationOf(test));
        QVERIFY(form.asked.empty() && form.usual.empty() && form.other.empty());
    }
};

QTEST_APPLESS_MAIN(ConditionsFormTest)
#include "conditionsform.moc"
