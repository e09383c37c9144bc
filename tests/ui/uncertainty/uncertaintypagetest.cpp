// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/uncertainty/uncertaintypage.h"
#include "editing/typicalvalues.h"
#include "kernel/evaluation/decideuncertainty.h"
#include "ui/chip.h"
#include "ui/circles.h"
#include "ui/examples.h"
#include "ui/figures/figurecard.h"
#include "ui/forms/field.h"
#include "ui/guards.h"
#include "ui/model/documentmodel.h"
#include "ui/model/evaluator.h"
#include "ui/rowtable.h"
#include "ui/theme.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>
#include <QWheelEvent>

using namespace palmer;
using namespace palmer::ui;
using namespace palmer::testdata;
using namespace Qt::StringLiterals;

namespace {

/// The worked example with a complete budget, and a drift test of 3.2 µm.
Document budgetExample(std::optional<long long> trials) {
    palmer::Test test = example1988("ISO 230-2:2006");
    test.id = "x1";
    auto &inputs = measurement(test).uncertainty;
    inputs.method = UncertaintyMethod::budget;
    inputs.device.fixed = 0.0;
    inputs.device.perMetre = 0.5;
    inputs.misalignmentRange = 1.0;
    inputs.temperatureRange = {0.2, 0.0};
    inputs.expansionRange = {2.0, 0.0};
    inputs.environmentalVariation = 1.6;
    inputs.trials = trials;
    auto &conditions = measurement(test).conditions.common;
    conditions.sensors = {{SensorMeasures::machine, "", 20.8, 20.8, std::nullopt},
                          {SensorMeasures::instrument, "", 20.0, 20.0, std::nullopt}};
    conditions.expansion = {11.5, 0.0};
    palmer::Test drift;
    drift.id = "d1";
    drift.title = "at rest";
    DriftMeasurement readings;
    readings.axis.name = "X";
    readings.times = {0, 60, 120};
    readings.deviations = {0.0, 0.0032, 0.001};
    drift.measurement = readings;
    Document document;
    document.tests.push_back(std::make_shared<const palmer::Test>(std::move(test)));
    document.tests.push_back(std::make_shared<const palmer::Test>(std::move(drift)));
    return document;
}

/// The page that edits a document, as in a window: what is typed is evaluated and shown again.
struct Edited {
    explicit Edited(Document document)
        : page(model, evaluator, selection) {
        QObject::connect(&model, &DocumentModel::changed, &evaluator,
                         [this] { evaluator.setDocument(model.document()); });
        QObject::connect(&evaluator, &Evaluator::evaluated, &page,
                         [this](const EvaluatedDocument &evaluated) { page.show(evaluated, 0); });
        model.setDocument(std::move(document), {});
        page.resize(600, 900);
        page.QWidget::show();
        page.activateWindow();
        if (!QTest::qWaitForWindowActive(&page))
            qFatal("the window does not become active");
    }

    QLineEdit *line(const QString &key) {
        for (auto *edit : page.findChildren<QLineEdit *>()) {
            if (edit->objectName().startsWith(u"field."_s + key + u'.'))
                return edit;
        }
        return nullptr;
    }
    void type(const QString &key, const QString &text) {
        QLineEdit *edit = line(key);
        QVERIFY(edit);
        edit->setFocus(Qt::TabFocusReason);
        edit->selectAll();
        QTest::keyClicks(edit, text);
    }
    QComboBox *choice(const QString &key) {
        for (auto *box : page.findChildren<QComboBox *>()) {
            if (box->objectName().startsWith(u"field."_s + key + u'.'))
                return box;
        }
        return nullptr;
    }
    void choose(const QString &key, int index) {
        QComboBox *box = choice(key);
        QVERIFY(box);
        box->setCurrentIndex(index);
        emit box->activated(index);
    }
    template <class Widget>
    Widget *part(const char *name) {
        return page.findChild<Widget *>(QString::fromLatin1(name));
    }
    QString cell(const char *table, int row, int column) {
        return part<RowTable>(table)->item(row, column)->text();
    }
    const TestEvaluation &evaluation() { return *evaluator.current().tests[0]; }
    const PositioningUncertaintyInputs &inputs() {
        return std::get<PositioningMeasurement>(model.document()->tests[0]->measurement).uncertainty;
    }
    void simulate() {
        part<QPushButton>("simulate")->click();
        QTRY_VERIFY(evaluation().uncertainty.simulation);
        QTRY_VERIFY(part<QPushButton>("simulate")->isVisible());
    }

    DocumentModel model;
    Evaluator evaluator;
    Selection selection;
    UncertaintyPage page;
};

} // namespace

class UncertaintyPageTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        installTheme();
        guardWidgets(*qApp);
    }

    void anInputChangesTheContributions() {
        Edited edited(budgetExample(std::nullopt));
        QVERIFY(edited.evaluation().uncertainty.complete);
        QVERIFY(edited.cell("contributions", 0, 0) != u"Environmental variation"_s);
        edited.type(u"environmentalVariation"_s, u"30"_s);
        QCOMPARE(edited.cell("contributions", 0, 0), u"Environmental variation"_s);
        QCOMPARE(edited.cell("contributions", 0, 3), u"18.00"_s); // 0.6 · 30 µm
        QCOMPARE(edited.part<RowTable>("contributions")->item(0, 2)->data(RowTable::barRole).toDouble(),
                 18.0 / 20); // on a scale of 20 µm
        QVERIFY(edited.part<QPushButton>("advice")->text().contains(u"environmental variation"_s));
        edited.model.undoStack()->undo(); // one step for the visit of the field
        QVERIFY(edited.cell("contributions", 0, 0) != u"Environmental variation"_s);
        QVERIFY(!edited.model.undoStack()->canUndo());
    }

    void impossibleInputIsRefusedInWords_data() {
        QTest::addColumn<QString>("field");
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("reason");
        QTest::newRow("negative") << u"environmentalVariation"_s << u"-1"_s
                                  << u"A negative number; 1.6\u00A0µm kept."_s;
        QTest::newRow("infinite") << u"environmentalVariation"_s << u"1e999"_s << QString();
        QTest::newRow("no number") << u"misalignmentRange"_s << u"much"_s << QString();
        QTest::newRow("length of nothing") << u"length"_s << u"0"_s << u"Not greater than 0."_s;
        QTest::newRow("no trials") << u"trials"_s << u"0"_s << u"Not greater than 0."_s;
        QTest::newRow("half a trial") << u"trials"_s << u"1000.5"_s << u"Not a whole number."_s;
        QTest::newRow("factor of nothing")
            << u"coverageFactor"_s << u"0"_s << u"Not greater than 0; 2 kept."_s;
    }

    void impossibleInputIsRefusedInWords() {
        QFETCH(QString, field);
        QFETCH(QString, typed);
        QFETCH(QString, reason);
        Edited edited(budgetExample(std::nullopt));
        const auto before = edited.inputs();
        edited.type(field, typed);
        auto *shown = qobject_cast<Field *>(edited.line(field)->parentWidget());
        QVERIFY(shown && shown->isRefused());
        if (reason.isEmpty())
            QVERIFY(!shown->refusal().isEmpty());
        else
            QCOMPARE(shown->refusal(), reason);
        // Letters that made a number on the way ("1" of "1000.5") are one step, taken back as one.
        while (edited.model.undoStack()->canUndo())
            edited.model.undoStack()->undo();
        QCOMPARE(edited.inputs(), before);
    }

    void aMissingInputIsMarkedAndNothingIsSimulated() {
        Document document = budgetExample(std::nullopt);
        palmer::Test test = *document.tests[0];
        measurement(test).uncertainty.expansionRange.machine.reset();
        document.tests[0] = std::make_shared<const palmer::Test>(test);
        Edited edited(std::move(document));
        QCOMPARE(countMissing(edited.evaluator.current(), 0, Page::uncertainty),
                 2); // the input, and the uncertainty that the text asks for
        QVERIFY(!edited.part<QPushButton>("simulate")->isEnabled());
        QCOMPARE(edited.cell("contributions", 0, 1), u"not stated"_s);
        QCOMPARE(edited.cell("contributions", 0, 3), u"–"_s);
        QVERIFY(!edited.part<QPushButton>("advice")->isVisible());
    }

    void typicalValuesAreOfferedWithTheirSource() {
        Edited edited(budgetExample(std::nullopt));
        QMenu *menu = edited.part<QToolButton>("typicalValues")->menu();
        emit menu->aboutToShow();
        QVERIFY(menu->actions().size() >= 3);
        for (const QAction *action : menu->actions())
            QVERIFY2(action->text().contains(u" – "_s), qPrintable(action->text())); // value – source
        QVERIFY(menu->actions()[0]->text().contains(u"ISO 230-2"_s));
        menu->actions()[0]->trigger();
        QCOMPARE(edited.inputs().expansionRange.machine, 3.4);
        edited.model.undoStack()->undo();
        QCOMPARE(edited.inputs().expansionRange.machine, 2.0);
    }

    void theDriftTestGivesTheEnvironmentalVariation() {
        Edited edited(budgetExample(std::nullopt));
        QCOMPARE(edited.choice(u"driftTest"_s)->currentIndex(), 0); // typed in
        QCOMPARE(edited.choice(u"driftTest"_s)->itemText(1), u"at rest"_s);
        edited.choose(u"driftTest"_s, 1);
        QCOMPARE(edited.inputs().driftTest, std::optional<std::string>("d1"));
        QVERIFY(!edited.inputs().environmentalVariation);
        QVERIFY(edited.evaluation().uncertainty.complete);
        QCOMPARE(edited.line(u"environmentalVariation"_s)->text(), QString());
        QCOMPARE(edited.line(u"environmentalVariation"_s)->placeholderText(), u"3.20"_s);
        const auto &contributions = edited.evaluation().uncertainty.contributions;
        QCOMPARE(std::string(contributions.back().id), std::string("environmentalVariation"));
        QVERIFY(std::abs(*contributions.back().expanded - 0.6 * 0.0032) < 1e-12);
        // A number that is typed in wins.
        edited.type(u"environmentalVariation"_s, u"5"_s);
        QCOMPARE(edited.choice(u"driftTest"_s)->currentIndex(), 0);
        QVERIFY(std::abs(*edited.evaluation().uncertainty.contributions.back().expanded - 0.003) < 1e-12);
    }

    void aDriftTestOfAnotherKindOfAxisGivesNothing() {
        Document document = budgetExample(std::nullopt);
        palmer::Test test = *document.tests[0];
        palmer::Test drift = *document.tests[1];
        std::get<DriftMeasurement>(drift.measurement).axis.motion = Motion::rotary; // arc seconds, not µm
        document.tests[1] = std::make_shared<const palmer::Test>(drift);
        QVERIFY(driftTestsFor(document, test).empty());
        measurement(test).uncertainty.environmentalVariation.reset();
        measurement(test).uncertainty.driftTest = "d1";
        document.tests[0] = std::make_shared<const palmer::Test>(test);
        Edited edited(document);
        QVERIFY(!edited.evaluation().uncertainty.complete);
        QCOMPARE(countMissing(edited.evaluator.current(), 0, Page::uncertainty),
                 2); // the input, and the uncertainty that the text asks for
        QCOMPARE(edited.choice(u"driftTest"_s)->currentIndex(), 1); // what the file says is shown
    }

    void aContributionLeadsToItsField() {
        Edited edited(budgetExample(std::nullopt));
        auto *table = edited.part<RowTable>("contributions");
        table->setFocus();
        table->setCurrentCell(table->rowOf(u"misalignment"_s), 0);
        QTest::keyClick(table, Qt::Key_Return);
        QCOMPARE(QApplication::focusWidget(), edited.line(u"misalignmentRange"_s));
    }

    void theMethodIsChosenAndUndone() {
        Edited edited(budgetExample(std::nullopt));
        QVERIFY(edited.part<QToolButton>("method1")->isChecked()); // budget
        edited.part<QToolButton>("method4")->click();
        QCOMPARE(edited.inputs().method, UncertaintyMethod::direct);
        QVERIFY(!edited.part<RowTable>("contributions"));
        edited.type(u"expanded"_s, u"4"_s); // of A
        QCOMPARE(edited.inputs().expanded, (ExpandedUncertainties{{"A", 4.0}}));
        QVERIFY(std::abs(*parameter(edited.evaluation(), "A")->expandedUncertainty - 0.004) < 1e-12);
        edited.model.undoStack()->undo();
        edited.model.undoStack()->undo();
        QVERIFY(edited.part<QToolButton>("method1")->isChecked());
        QVERIFY(edited.part<RowTable>("contributions"));
        edited.part<QToolButton>("method0")->click();
        QVERIFY(!edited.part<RowTable>("contributions"));
        QVERIFY(!parameter(edited.evaluation(), "A")->expandedUncertainty);
    }

    void theSimulationStandsBesideTheBudgetAndAgesWithAnEdit() {
        Edited edited(budgetExample(220000));
        QCOMPARE(edited.cell("methods", 0, 3), u"–"_s);
        QVERIFY(edited.cell("methods", 0, 2).startsWith(u"± "_s)); // with the actual targets
        QVERIFY(!edited.part<FigureCard>("distribution")->isVisible());
        edited.simulate();
        QVERIFY(edited.cell("methods", 0, 1).startsWith(u"± "_s));
        QVERIFY(edited.cell("methods", 0, 3).startsWith(u"± "_s));
        QVERIFY(edited.cell("methods", 0, 4).contains(u" … "_s));
        QVERIFY(edited.part<RowTable>("methods")->histogram(
            edited.part<RowTable>("methods")->model()->index(0, 5)));
        QVERIFY(!edited.part<QLabel>("simulationText")->text().contains(u"outdated"_s));
        edited.type(u"environmentalVariation"_s, u"2"_s);
        QVERIFY(edited.part<QLabel>("simulationText")->text().contains(u"outdated"_s));
    }

    /// Nothing that was simulated before an edit looks as if it held.
    void whatIsOutdatedStandsBack() {
        Document document = budgetExample(220000);
        palmer::Test test = *document.tests[0];
        measurement(test).uncertainty.method = UncertaintyMethod::monteCarlo;
        test.decisionRule.rule = Rule::iso14253_1;
        document.tests[0] = std::make_shared<const palmer::Test>(test);
        Edited edited(document);
        edited.simulate();
        auto *table = edited.part<RowTable>("methods");
        const auto isBold = [&](int row) { return table->item(row, 3)->font().bold(); };
        int decided = 0; // of some the budget decides, for their shift is large
        while (decided + 1 < table->rowCount() && !isBold(decided))
            ++decided;
        const QColor grey = token(Token::secondaryText, edited.page.palette());
        const auto colour = [&] { return table->item(decided, 3)->foreground().color(); };
        QVERIFY(isBold(decided));
        QVERIFY(colour() != grey);
        edited.type(u"environmentalVariation"_s, u"2"_s);
        QVERIFY(edited.part<QLabel>("simulationText")->text().startsWith(u"outdated"_s));
        QVERIFY(!isBold(decided));
        for (int column = 3; column < table->columnCount(); ++column)
            QVERIFY(table->item(decided, column)
                        ->data(Qt::AccessibleTextRole)
                        .toString()
                        .contains(u"outdated"_s));
        QCOMPARE(colour(), grey);
        QVERIFY(edited.part<QLabel>("distributionTitle")->text().contains(u"outdated"_s));
        QVERIFY(edited.part<QLabel>("decides")->text().startsWith(u"Grey"_s));
        edited.simulate();
        QTRY_VERIFY(!edited.evaluation().uncertainty.outdated);
        QVERIFY(isBold(decided));
    }

    /// The budget is complete: what is missing is a press on the button.
    void theSimulationThatWasNotMadeIsLedTo() {
        Document document = budgetExample(220000);
        palmer::Test test = *document.tests[0];
        measurement(test).uncertainty.method = UncertaintyMethod::monteCarlo;
        document.tests[0] = std::make_shared<const palmer::Test>(test);
        Edited edited(document);
        edited.page.resize(600, 300);
        QCOMPARE(edited.part<LinkChip>("missingChip")->text(), u"simulation not made yet"_s);
        auto *button = edited.part<QPushButton>("simulate");
        QVERIFY(button->visibleRegion().isEmpty());
        QVERIFY(edited.page.focusNextRequired(true));
        QVERIFY(button->hasFocus());
        QTRY_VERIFY(!button->visibleRegion().isEmpty());
        QVERIFY(!edited.page.focusNextRequired(true)); // it is the last that is missing here
        edited.part<QToolButton>("method0")->setFocus();
        QVERIFY(edited.page.focusField(u"uncertainty"_s));
        QVERIFY(button->hasFocus());
        QTest::keyClick(button, Qt::Key_Space);
        QTRY_VERIFY(edited.evaluation().uncertainty.simulation);
        QVERIFY(!edited.part<LinkChip>("missingChip")->isVisible());
    }

    void whichMethodDecidesIsBoldAndSaid() {
        Edited edited(budgetExample(220000));
        edited.simulate();
        auto *table = edited.part<RowTable>("methods");
        QVERIFY(table->item(0, 1)->font().bold());
        QVERIFY(!table->item(0, 3)->font().bold());
        QVERIFY(
            table->item(0, 1)->data(Qt::AccessibleTextRole).toString().endsWith(u"used for the verdict"_s));
        QVERIFY(edited.part<QLabel>("decides")->text().contains(u"The budget U is used for the verdict."_s));
        edited.part<QToolButton>("method3")->click();
        table = edited.part<RowTable>("methods");
        // A is shifted too far: the budget decides there, the simulation for what it does not shift.
        QVERIFY(edited.part<QLabel>("decides")->text().contains(
            u"Monte Carlo simulation is used for the verdict"_s));
        bool any = false;
        for (int row = 0; row < table->rowCount(); ++row)
            any |= table->item(row, 3)->font().bold();
        QVERIFY(any);
    }

    void headsSayWhatUStandsFor() {
        Edited edited(budgetExample(220000));
        edited.simulate();
        const auto head = [&](int column) {
            return edited.part<RowTable>("methods")->horizontalHeaderItem(column)->text();
        };
        QVERIFY(head(1).endsWith(u"k = 2"_s));
        QVERIFY(head(3).endsWith(u"95.45 %"_s));
        QCOMPARE(edited.part<QLabel>("methodNote")->text(), u"used for the verdict · k = 2"_s);
        edited.part<QToolButton>("method3")->click(); // Monte Carlo, for what it does not shift
        const QString both = edited.part<QLabel>("methodNote")->text();
        QVERIFY2(both.contains(u"95.45 % for "_s) && both.contains(u"k = 2 for the others"_s),
                 qPrintable(both));
        // All of it can be read, however narrow the page is.
        const auto *note = edited.part<QLabel>("methodNote");
        for (const int width : {600, 480, 380}) {
            edited.page.resize(width, 900);
            QTRY_VERIFY(note->wordWrap() && note->isVisible() &&
                        note->height() >= note->heightForWidth(note->width()));
        }
    }

    void tooFewTrialsAreSaid() {
        Edited edited(budgetExample(3));
        edited.simulate();
        edited.part<QToolButton>("method3")->click();
        auto *table = edited.part<RowTable>("methods");
        for (int row = 0; row < table->rowCount(); ++row)
            QVERIFY(table->item(row, 1)->font().bold() && !table->item(row, 3)->font().bold());
        QVERIFY(edited.part<QLabel>("simulationText")->text().contains(u"too few to decide"_s));
        QVERIFY(edited.part<QLabel>("decides")->text().contains(u"Too few trials to decide"_s));
    }

    void theActualTargetsDecideIfChosen() {
        Edited edited(budgetExample(std::nullopt));
        edited.part<QToolButton>("method2")->click();
        QCOMPARE(edited.inputs().method, UncertaintyMethod::budgetActual);
        auto *table = edited.part<RowTable>("methods");
        QVERIFY(table->item(0, 2)->font().bold() && !table->item(0, 1)->font().bold());
        QVERIFY(edited.part<RowTable>("contributions"));
        const auto *a = parameter(edited.evaluation(), "A");
        QCOMPARE(a->expandedUncertainty, a->actualUncertainty);
    }

    void methodsThatDifferAreMarkedInWords() {
        Edited edited(budgetExample(220000));
        edited.simulate();
        auto *table = edited.part<RowTable>("methods");
        int marked = 0;
        for (int row = 0; row < table->rowCount(); ++row) {
            const auto id = table->key(row).toStdString();
            const bool differs = methodsDiffer(*parameter(edited.evaluation(), id));
            QCOMPARE(!table->item(row, 7)->data(RowTable::warningRole).toString().isEmpty(), differs);
            marked += differs;
        }
        QVERIFY(marked > 0); // ruling targets closer together than L
    }

    void theHistogramIsThatOfTheChosenResult() {
        Edited edited(budgetExample(220000));
        edited.simulate();
        auto *table = edited.part<RowTable>("methods");
        auto *card = edited.part<FigureCard>("distribution");
        QVERIFY(card->isVisible());
        table->setCurrentCell(table->rowOf(u"B"_s), 0);
        QVERIFY(edited.part<QLabel>("distributionTitle")->text().contains(u"B"_s));
        const auto &shown = std::get<HistogramFigure>(*card->figure());
        QVERIFY(std::abs(shown.evaluated - *parameter(edited.evaluation(), "B")->value * 1000) < 1e-9);
        long long counted = 0;
        for (const long long count : shown.counts)
            counted += count;
        QCOMPARE(counted, 220000LL);
        // An edit elsewhere leaves it where it is.
        edited.type(u"misalignmentRange"_s, u"2"_s);
        QCOMPARE(table->key(table->currentRow()), u"B"_s);
    }

    void aCancelledSimulationLeavesNothing() {
        Edited edited(budgetExample(1'000'000'000));
        edited.part<QPushButton>("simulate")->setFocus();
        edited.part<QPushButton>("simulate")->click();
        auto *cancel = edited.part<QPushButton>("cancelSimulation");
        QVERIFY(cancel->isVisible());
        QCOMPARE(QApplication::focusWidget(), cancel);
        QTest::qWait(100);
        cancel->click(); // at once; the simulation would take many minutes
        QTRY_VERIFY(edited.part<QPushButton>("simulate")->isVisible());
        QVERIFY(!edited.evaluation().uncertainty.simulation);
    }

    void theRuleIsWrittenOut() {
        Edited edited(budgetExample(std::nullopt));
        QVERIFY(edited.part<QLabel>("decisionRuleText")->text().startsWith(u"Simple acceptance"_s));
        QComboBox *rule = nullptr;
        for (auto *box : edited.page.findChildren<QComboBox *>()) {
            if (box->accessibleName() == u"Rule"_s)
                rule = box;
        }
        QVERIFY(rule);
        rule->setCurrentIndex(1);
        emit rule->activated(1);
        QCOMPARE(edited.model.document()->tests[0]->decisionRule.rule, Rule::iso14253_1);
        QVERIFY(edited.part<QLabel>("decisionRuleText")->text().contains(u"ISO 14253-1"_s));
    }

    void theWheelScrollsThePageAndChangesNothing() {
        Edited edited(budgetExample(std::nullopt));
        edited.page.resize(600, 300);
        const auto before = edited.model.document();
        for (QWidget *widget : edited.page.findChildren<QWidget *>()) {
            if (!widget->isVisible() || widget->hasFocus())
                continue;
            const QPointF middle = widget->rect().center();
            QWheelEvent wheel(middle, widget->mapToGlobal(middle), QPoint(), QPoint(0, -120), Qt::NoButton,
                              Qt::NoModifier, Qt::NoScrollPhase, false);
            QApplication::sendEvent(widget, &wheel);
        }
        QCOMPARE(edited.model.document(), before);
    }

    void everythingHasAnAccessibleName() {
        Edited edited(budgetExample(220000));
        edited.simulate();
        for (const char *name : {"contributions", "methods"})
            QVERIFY(!edited.part<RowTable>(name)->accessibleName().isEmpty());
        QVERIFY(!edited.part<FigureCard>("distribution")->accessibleName().isEmpty());
        for (const QLineEdit *edit : edited.page.findChildren<QLineEdit *>())
            QVERIFY2(!edit->accessibleName().isEmpty(), qPrintable(edit->objectName()));
        for (const QToolButton *button : edited.page.findChildren<QToolButton *>())
            QVERIFY2(!button->accessibleName().isEmpty(), qPrintable(button->objectName()));
    }

    void aLaserNeedsNoRangesOfItsOwn() {
        Document document = budgetExample({});
        palmer::Test test = *document.tests[0];
        measurement(test).uncertainty.temperatureRange = {};
        measurement(test).uncertainty.expansionRange = {};
        document.tests[0] = std::make_shared<const palmer::Test>(test);
        Edited edited(document);
        const auto required = [&](const QString &key) {
            std::vector<bool> marks;
            for (const auto *field : edited.page.findChildren<Field *>()) {
                if (field->edit()->objectName().startsWith(u"field."_s + key + u'.'))
                    marks.push_back(field->isRequired());
            }
            return marks;
        };
        const std::vector machineOnly{true, false};
        QCOMPARE(required(u"temperatureRange"_s), machineOnly);
        QCOMPARE(required(u"expansionRange"_s), machineOnly);
        edited.type(u"expansionRange"_s, u"2"_s);
        QCOMPARE(required(u"expansionRange"_s), std::vector({false, false}));
        QCOMPARE(required(u"temperatureRange"_s), machineOnly);
    }

    void rotaryAxesHaveNoMetres() {
        palmer::Test test = positioningTest("ISO 230-2:2006", {0, 90, 180}, {{0, 10, 3}, {1, 9, 4}},
                                            {{2, 12, 5}, {1, 11, 6}});
        measurement(test).axis.motion = Motion::rotary;
        measurement(test).uncertainty.method = UncertaintyMethod::budget;
        Document document;
        document.tests.push_back(std::make_shared<const palmer::Test>(test));
        Edited edited(document);
        QVERIFY(!edited.line(u"misalignmentRange"_s));
        QVERIFY(!edited.line(u"temperatureRange"_s));
        QVERIFY(edited.line(u"environmentalVariation"_s));
        // A part per metre that a file has nevertheless can be seen and taken out.
        measurement(test).uncertainty.device.perMetre = 2;
        document.tests[0] = std::make_shared<const palmer::Test>(test);
        Edited wrong(document);
        int fields = 0;
        for (const auto *edit : wrong.page.findChildren<QLineEdit *>())
            fields += edit->objectName().startsWith(u"field.device."_s);
        QCOMPARE(fields, 2);
    }

    void circlesHaveTheirOwnInputs() {
        palmer::Test test = decidedPair();
        std::get<CircularMeasurement>(test.measurement).uncertainty.method = UncertaintyMethod::budget;
        Document document;
        document.tests.push_back(std::make_shared<const palmer::Test>(test));
        Edited edited(document);
        QVERIFY(edited.line(u"displacement"_s) && edited.line(u"pointNoise"_s));
        edited.type(u"displacement"_s, u"0.4"_s);
        QCOMPARE(std::get<CircularMeasurement>(edited.model.document()->tests[0]->measurement)
                     .uncertainty.displacement.expanded,
                 0.4);
        QVERIFY(edited.part<QToolButton>("method1")->text() == u"Budget"_s);
    }

    void frenchWritesFrenchNumbers() {
        Edited edited(budgetExample(std::nullopt));
        edited.page.setLanguage(Language(Language::Id::french));
        const QString size = edited.cell("contributions", 0, 3);
        QVERIFY2(size.contains(u','), qPrintable(size));
    }
};

QTEST_MAIN(UncertaintyPageTest)
#include "uncertaintypagetest.moc"
