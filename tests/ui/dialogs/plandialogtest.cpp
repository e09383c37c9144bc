// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/dialogs/plandialog.h"

#include "document/readdocument.h"
#include "document/savedocument.h"
#include "ui/dialogs/cycleview.h"
#include "ui/examples.h"
#include "ui/model/documentmodel.h"
#include "ui/windowlanguage.h"

#include <QComboBox>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>

using namespace palmer;
using namespace palmer::ui;
using namespace palmer::testdata;

namespace {

Document emptyTest() {
    Test test;
    test.edition = "ISO 230-2:2006";
    PositioningMeasurement measurement;
    measurement.axis.name = "Y";
    measurement.axis.range = Interval{0, 1200};
    test.measurement = measurement;
    Document document;
    document.tests.push_back(std::make_shared<const Test>(test));
    return document;
}

void type(QDialog &dialog, const char *name, const char *text) {
    auto *edit = dialog.findChild<QLineEdit *>(QLatin1StringView(name));
    if (!edit)
        qFatal("no field %s", name);
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, text);
}

QPushButton *button(QDialog &dialog, const char *name) {
    auto *found = dialog.findChild<QPushButton *>(QLatin1StringView(name));
    if (!found)
        qFatal("no button %s", name);
    return found;
}

} // namespace

/// The plan in the window.
class PlanDialogTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }

    void beginsWithWhatTheTestStates() {
        DocumentModel model;
        model.setDocument(emptyTest(), {});
        PlanDialog dialog(model, 0);
        QCOMPARE(dialog.program().axis, std::string("Y"));
        QCOMPARE(dialog.plan().targets.size(), std::size_t(6)); // 1 198 mm between the ends
        QVERIFY(dialog.plan().targets.front() - dialog.program().approach >= 0);
        QVERIFY(dialog.plan().targets.back() + dialog.program().approach <= 1200);
    }

    /// A long cycle is drawn row by row; all of its rows and all of their width are there.
    void aLongCycleFillsItsDiagram() {
        CycleProgram program;
        for (int i = 0; i < 100; ++i)
            program.targets.push_back(10 * i);
        program.runs = 200;
        for (const Cycle cycle : {Cycle::standard, Cycle::step}) {
            program.cycle = cycle;
            CycleView view;
            view.resize(460, 300);
            view.show(program, {});
            const QImage image = view.grab().toImage();
            for (int y = 45; y < 250; y += 3) {
                int coloured = 0;
                for (int x = 30; x < 430; ++x)
                    coloured += image.pixelColor(x, y).lightness() < 170 ? 1 : 0;
                // In the step cycle the axis stands at one of the 100 targets.
                QVERIFY2(cycle == Cycle::standard ? coloured > 380 : coloured > 0,
                         qPrintable(QStringLiteral("%1: %2").arg(y).arg(coloured)));
            }
        }
    }

    /// Its axis moves 5° beyond a turn either way, to approach 0° and 360°.
    void aRotaryAxisIsPlannedOverATurnWithinItsEnds() {
        DocumentModel model;
        model.setDocument(readDocument(readBytes(":/examples/rotary-axis.palmer")), {});
        PlanDialog dialog(model, 0);
        dialog.show();
        button(dialog, "planAnew")->click();
        const Interval ends =
            *std::get<PositioningMeasurement>(model.document()->tests[0]->measurement).axis.range;
        QVERIFY(dialog.plan().targets.front() - dialog.program().approach >= ends.from);
        QVERIFY(dialog.plan().targets.back() + dialog.program().approach <= ends.to);
        QCOMPARE(dialog.program().runs, 5); // no long axis
        const QString summary = dialog.findChild<QLabel *>("planSummary")->text();
        QVERIFY2(!summary.contains("long axis"), qPrintable(summary));
        QVERIFY(!dialog.findChild<QLabel *>("planOvertravel")->isVisible());
        QVERIFY2(summary.contains("nominal position + a random part"), qPrintable(summary));
        // Targets per metre are of lengths.
        QVERIFY(!dialog.findChild<QLineEdit *>("plan.perMetre")->isVisible());
        auto *motion = dialog.findChild<QComboBox *>("plan.motion");
        motion->setCurrentIndex(0);
        emit motion->activated(0);
        QVERIFY(dialog.findChild<QLineEdit *>("plan.perMetre")->isVisible());
    }

    /// 1988: quarter turns and free targets, which have no interval.
    void quarterTurnsAreSaidAsSuch() {
        Document document = emptyTest();
        Test test = *document.tests[0];
        test.edition = "ISO 230-2:1988";
        auto &measurement = std::get<PositioningMeasurement>(test.measurement);
        measurement.axis.motion = Motion::rotary;
        measurement.axis.range = Interval{-400, 400};
        document.tests[0] = std::make_shared<const Test>(test);
        DocumentModel model;
        model.setDocument(document, {});
        PlanDialog dialog(model, 0);
        dialog.show();
        QString summary = dialog.findChild<QLabel *>("planSummary")->text().replace(QChar(0xA0), ' ');
        QVERIFY2(summary.contains("multiples of 90° and, at random, one in each 120.0° of the travel"),
                 qPrintable(summary));
        QVERIFY2(!summary.contains("nominal position"), qPrintable(summary));
        type(dialog, "plan.travel", "720");
        QCOMPARE(dialog.program().runs, 5);
        summary = dialog.findChild<QLabel *>("planSummary")->text();
        QVERIFY2(!summary.contains("2006") && !summary.contains("long axis"), qPrintable(summary));
        button(dialog, "fillTest")->click();
        const auto &filled = std::get<PositioningMeasurement>(model.document()->tests[0]->measurement);
        QVERIFY(!filled.targetChoice.interval && filled.targetChoice.seed);
    }

    /// Whatever the ends and the way of approach: what is proposed at first stays within the ends.
    void theFirstPlanStaysWithinTheEnds() {
        for (const Motion motion : {Motion::linear, Motion::rotary}) {
            for (const Interval ends : {Interval{-5, 365}, Interval{0, 360}, Interval{-180, 190},
                                        Interval{-720, 720}, Interval{0, 90}, Interval{10, 1500}}) {
                for (const std::optional<double> approach :
                     {std::optional<double>(), std::optional(0.5), std::optional(3.0)}) {
                    Document document = emptyTest();
                    Test test = *document.tests[0];
                    auto &measurement = std::get<PositioningMeasurement>(test.measurement);
                    measurement.axis.motion = motion;
                    measurement.axis.range = ends;
                    measurement.conditions.approachDistance = approach;
                    document.tests[0] = std::make_shared<const Test>(test);
                    DocumentModel model;
                    model.setDocument(document, {});
                    PlanDialog dialog(model, 0);
                    QVERIFY(!dialog.plan().targets.empty());
                    const double beyond = dialog.program().approach;
                    QCOMPARE(beyond, approach.value_or(1.0));
                    QVERIFY(dialog.plan().targets.front() - beyond >= ends.from - 1e-9);
                    QVERIFY(dialog.plan().targets.back() + beyond <= ends.to + 1e-9);
                    if (motion == Motion::rotary)
                        QVERIFY(dialog.plan().targets.back() - dialog.plan().targets.front() <= 360 + 1e-9);
                }
            }
        }
    }

    void fillsATestWithoutReadings() {
        DocumentModel model;
        model.setDocument(emptyTest(), {});
        const Document before = *model.document();
        PlanDialog dialog(model, 0);
        dialog.show();
        type(dialog, "plan.travel", "1000");
        type(dialog, "plan.period", "10");
        const auto targets = dialog.plan().targets;
        button(dialog, "fillTest")->click();
        const auto &measurement = std::get<PositioningMeasurement>(model.document()->tests[0]->measurement);
        QCOMPARE(measurement.targets, targets);
        QCOMPARE(measurement.targetChoice.period, std::optional(10.0));
        QCOMPARE(measurement.runs.size(), std::size_t(10));
        QCOMPARE(measurement.axis.range, std::optional(Interval{0, 1200})); // stays
        model.undoStack()->undo();
        QVERIFY(*model.document() == before);
    }

    void neverOverwritesReadings() {
        DocumentModel model;
        Document document;
        document.tests.push_back(std::make_shared<const Test>(example1988("ISO 230-2:1988")));
        model.setDocument(document, {});
        PlanDialog dialog(model, 0);
        button(dialog, "planAnew")->click();
        QVERIFY(!button(dialog, "fillTest")->isEnabled());
        QSignalSpy made(&dialog, &PlanDialog::testMade);
        button(dialog, "makeTest")->click();
        QCOMPARE(made.count(), 1);
        QCOMPARE(model.document()->tests.size(), std::size_t(2));
        QCOMPARE(model.document()->tests[0], document.tests[0]);
        QCOMPARE(model.document()->tests[1]->edition, std::string("ISO 230-2:1988"));
    }

    /// Its targets, sheet and program; others only when they are asked for, and red what the axis cannot
    /// reach.
    void aTestWithTargetsIsItsOwnPlan() {
        Document document;
        Test test = example1988("ISO 230-2:1988");
        auto &measurement = std::get<PositioningMeasurement>(test.measurement);
        measurement.axis.range.reset();
        measurement.axis.travel = measurement.targets.back() - measurement.targets.front() + 1;
        document.tests.push_back(std::make_shared<const Test>(test));
        document.machine.controller = "Heidenhain TNC 640";
        DocumentModel model;
        model.setDocument(document, {});
        PlanDialog dialog(model, 0);
        dialog.show();
        QVERIFY(QTest::qWaitForWindowActive(&dialog));
        QCOMPARE(dialog.plan().targets, measurement.targets);
        QCOMPARE(dialog.program().runs, 5);
        const auto *over = dialog.findChild<QLabel *>("planOvertravel");
        QVERIFY(over->isVisible() && over->text().contains("more than the travel"));
        QVERIFY(!dialog.findChild<QLineEdit *>("plan.travel")->isEnabled());
        QVERIFY(dialog.findChild<QLineEdit *>("plan.approach")->isEnabled());
        QVERIFY(!button(dialog, "makeTest")->isVisible() && !button(dialog, "fillTest")->isVisible());
        type(dialog, "plan.approach", "0.4");
        QVERIFY(!over->isVisible());
        const QTemporaryDir folder;
        QVERIFY(dialog.saveProgram(folder.filePath("own.h"))); // the machine's control is chosen
        QFile program(folder.filePath("own.h"));
        QVERIFY(program.open(QIODevice::ReadOnly) && program.readAll().contains("BEGIN PGM"));
        button(dialog, "planAnew")->click();
        QVERIFY(dialog.plan().targets != measurement.targets);
        QVERIFY(!button(dialog, "planAnew")->isVisible() && button(dialog, "makeTest")->isVisible());
        QVERIFY(dialog.findChild<QLineEdit *>("plan.travel")->isEnabled());
        QCOMPARE(dialog.program().approach, 0.4);
        QVERIFY(*model.document() == document); // asking for new ones changes nothing yet
    }

    void otherTargetsComeFromAnotherSeed() {
        DocumentModel model;
        model.setDocument(emptyTest(), {});
        PlanDialog dialog(model, 0);
        const auto before = dialog.plan().targets;
        button(dialog, "reseed")->click();
        QVERIFY(dialog.plan().targets != before);
        QCOMPARE(dialog.findChild<QLineEdit *>("plan.seed")->text(), QString("2"));
    }

    void whatMakesNoPlanIsSaid() {
        DocumentModel model;
        model.setDocument(emptyTest(), {});
        PlanDialog dialog(model, 0);
        dialog.show();
        type(dialog, "plan.travel", "2");
        type(dialog, "plan.decimals", "0");
        QVERIFY(dialog.plan().targets.empty());
        QVERIFY(!button(dialog, "makeTest")->isEnabled());
        QVERIFY(!dialog.findChild<QLabel *>("planSummary")->text().isEmpty());
    }

    /// Axis X1 has no name of its own but at a SINUMERIK.
    void whatMakesNoProgramIsSaid() {
        DocumentModel model;
        model.setDocument(emptyTest(), {});
        PlanDialog dialog(model, 0);
        dialog.show();
        const auto *reason = dialog.findChild<QLabel *>("programReason");
        QVERIFY(!reason->isVisible() && button(dialog, "saveProgram")->isEnabled());
        type(dialog, "plan.axis", "X1");
        auto *dialects = dialog.findChild<QComboBox *>("dialect");
        for (int i = 0; i < dialects->count(); ++i) {
            dialects->setCurrentIndex(i);
            const bool siemens = dialects->itemText(i).contains("SINUMERIK");
            QCOMPARE(reason->isVisible(), !siemens);
            QCOMPARE(button(dialog, "saveProgram")->isEnabled(), siemens);
            QVERIFY(siemens || reason->text().contains("X1 before a position"));
        }
    }

    void writesProgramAndPlan() {
        DocumentModel model;
        model.setDocument(emptyTest(), {});
        PlanDialog dialog(model, 0);
        QTemporaryDir folder;
        for (int dialect = 0; dialect < 5; ++dialect) {
            dialog.findChild<QComboBox *>("dialect")->setCurrentIndex(dialect);
            QVERIFY(dialog.saveProgram(folder.filePath("p.nc")));
            QFile program(folder.filePath("p.nc"));
            QVERIFY(program.open(QIODevice::ReadOnly));
            const QByteArray text = program.readAll();
            QVERIFY(text.contains("M30"));
            QCOMPARE(text.contains("BEGIN PGM"), dialect == 2);
        }
        QVERIFY(dialog.savePlan(folder.filePath("plan.pdf")));
        QFile pdf(folder.filePath("plan.pdf"));
        QVERIFY(pdf.open(QIODevice::ReadOnly) && pdf.readAll().startsWith("%PDF-"));
    }
};

QTEST_MAIN(PlanDialogTest)
#include "plandialogtest.moc"
