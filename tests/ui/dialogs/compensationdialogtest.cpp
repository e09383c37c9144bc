// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/dialogs/compensationdialog.h"

#include "document/savedocument.h"
#include "kernel/evaluation/evaluatetest.h"
#include "ui/figures/figurecard.h"
#include "ui/window/exports.h"
#include "ui/window/shownwindow.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

using namespace palmer;
using namespace palmer::ui;

namespace {

EvaluatedDocument small(const char *edition = "ISO 230-2:2014") {
    PositioningMeasurement m;
    m.axis.name = "X";
    m.targets = {0, 100, 200};
    m.runs = {{Direction::positive, {-0.003, 0.0002, -0.005}},
              {Direction::negative, {0.0023, 0.0054, -0.0015}},
              {Direction::positive, {-0.003, 0.0002, -0.005}},
              {Direction::negative, {0.0023, 0.0054, -0.0015}}};
    Test test;
    test.edition = edition;
    test.measurement = std::move(m);
    Document document;
    document.tests.push_back(std::make_shared<const Test>(test));
    return evaluate(std::make_shared<const Document>(document));
}

void choose(QDialog &dialog, const char *name, int index) {
    auto *box = dialog.findChild<QComboBox *>(name);
    if (!box)
        qFatal("no %s", name);
    box->setCurrentIndex(index);
    emit box->activated(index);
}

QStringList row(const QDialog &dialog, const QString &symbol) {
    const auto *table = dialog.findChild<QTableWidget *>("prediction");
    for (int i = 0; i < table->rowCount(); ++i) {
        if (table->item(i, 0)->text() == symbol)
            return {table->item(i, 1)->text(), table->item(i, 2)->text()};
    }
    return {};
}

} // namespace

/// The compensation table in the window, and the other exports.
class CompensationDialogTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { prepareApplication(); }
    void init() { setWindowLanguage(Language::Id::english); }

    void predictsWhatTheTableWouldBring() {
        CompensationDialog dialog(small(), 0);
        dialog.show();
        // The mean of both directions is taken out; their difference stays.
        QCOMPARE(row(dialog, "M").value(1), QString("0.0\u00A0µm"));
        QCOMPARE(row(dialog, "B").value(0), QString("5.3\u00A0µm"));
        QCOMPARE(row(dialog, "B").value(1), QString("5.3\u00A0µm"));
        QCOMPARE(std::get<LineFigure>(*dialog.findChild<LineView *>()->figure()).lines.size(),
                 std::size_t(4));
        auto *each = dialog.findChild<QCheckBox *>("compensation.perDirection");
        each->setChecked(true);
        QCOMPARE(row(dialog, "B").value(1), QString("0.0\u00A0µm"));
        QCOMPARE(row(dialog, "E").value(1), QString("0.0\u00A0µm"));
        QVERIFY(dialog.findChild<QPlainTextEdit *>("compensationTable")
                    ->toPlainText()
                    .contains(QString::fromUtf8(dialog.written())));
    }

    void editionsWithoutMAreSeenUnderOneThatHasIt() {
        CompensationDialog dialog(small("ISO 230-2:1988"), 0);
        QVERIFY(!row(dialog, "M").isEmpty());
        QVERIFY(!row(dialog, "E").isEmpty());
    }

    void asksOnlyWhatTheFormatCanSay() {
        CompensationDialog dialog(small(), 0);
        dialog.show();
        const auto enabled = [&](const char *name) { return dialog.findChild<QWidget *>(name)->isEnabled(); };
        QVERIFY(enabled("compensation.perDirection"));
        QVERIFY(!enabled("compensation.incremental"));
        QVERIFY(!enabled("compensation.reference") && !enabled("compensation.encoder"));
        choose(dialog, "compensation.format", 1);
        QVERIFY(dialog.written().isEmpty()); // the reference point is owed
        QVERIFY(dialog.findChild<QLabel *>("compensationReason")->text().contains("reference point"));
        QVERIFY(dialog.findChild<LineView *>()->isVisible()); // stays with every control
        QCOMPARE(row(dialog, "M").value(1), QString("0.0\u00A0µm"));
        auto *reference = dialog.findChild<QLineEdit *>("compensation.reference");
        reference->setFocus();
        QTest::keyClicks(reference, "100");
        QVERIFY(dialog.written().contains("$AA_ENC_COMP[0,1,X]=0\n"));
        QVERIFY(dialog.findChild<QLabel *>("compensationNote")->text().contains("MD38000 has to be 3"));
        choose(dialog, "compensation.encoder", 1);
        QVERIFY(dialog.written().contains("$AA_ENC_COMP[1,1,X]=0\n"));
        QVERIFY(!enabled("compensation.perDirection"));
        choose(dialog, "compensation.format", 2);
        QVERIFY(dialog.written().startsWith("unit = mm\n[X]\n"));
        QVERIFY(enabled("compensation.sign") && enabled("compensation.perDirection"));
        QVERIFY(!enabled("compensation.reference") && !enabled("compensation.incremental"));
        const QByteArray nominalMinusActual = dialog.written();
        choose(dialog, "compensation.sign", 1);
        QVERIFY(dialog.written() != nominalMinusActual);
        choose(dialog, "compensation.sign", 0);
        choose(dialog, "compensation.format", 3);
        QVERIFY(enabled("compensation.incremental"));
        choose(dialog, "compensation.decimalMark", 1);
        QVERIFY(dialog.written().contains(';'));
        const QByteArray corrections = dialog.written();
        choose(dialog, "compensation.sign", 1);
        QVERIFY(dialog.written() != corrections);
        QCOMPARE(row(dialog, "M").value(1), QString("0.0\u00A0µm")); // whatever the sign is written with
    }

    void beginsWithTheControlOfTheMachine() {
        EvaluatedDocument of = small();
        Document document = *of.document;
        document.machine.controller = "Siemens SINUMERIK ONE";
        CompensationDialog dialog(evaluate(std::make_shared<const Document>(document)), 0);
        QCOMPARE(dialog.format(), CompensationFormat::siemens);
        QVERIFY(dialog.findChild<QWidget *>("compensation.reference")->isEnabled());
        document.machine.controller = "unknown";
        QCOMPARE(CompensationDialog(evaluate(std::make_shared<const Document>(document)), 0).format(),
                 CompensationFormat::linuxcnc);
    }

    /// Columns of both directions cannot be had of one.
    void oneDirectionHasNoOther() {
        EvaluatedDocument both = small();
        Test test = *both.document->tests[0];
        std::erase_if(std::get<PositioningMeasurement>(test.measurement).runs,
                      [](const Run &run) { return run.approach == Direction::negative; });
        Document document;
        document.tests.push_back(std::make_shared<const Test>(test));
        CompensationDialog dialog(evaluate(std::make_shared<const Document>(document)), 0);
        dialog.show();
        for (int format = 0; format < 4; ++format) {
            choose(dialog, "compensation.format", format);
            QVERIFY(!dialog.findChild<QWidget *>("compensation.perDirection")->isEnabled());
        }
        QVERIFY(dialog.findChild<QLabel *>("compensationNote")
                    ->text()
                    .contains("Only the positive direction was measured"));
    }

    void takesRangeAndInterval() {
        CompensationDialog dialog(small(), 0);
        dialog.show();
        auto *interval = dialog.findChild<QLineEdit *>("compensation.interval");
        interval->setFocus();
        QTest::keyClicks(interval, "50");
        QCOMPARE(readCompensation(dialog.written(), dialog.format(), {}).positions,
                 (std::vector<double>{0, 50, 100, 150, 200}));
        auto *from = dialog.findChild<QLineEdit *>("compensation.from");
        from->setFocus();
        QTest::keyClicks(from, "900");
        QVERIFY(dialog.written().isEmpty()); // behind the end
        QVERIFY(!dialog.findChild<QLabel *>("compensationReason")->text().isEmpty());
        QVERIFY(!dialog.findChild<QPushButton *>("saveCompensation")->isEnabled());
    }

    /// The file that was imported says nothing of the sign: it is asked once, for the document keeps the
    /// answer.
    void asksOnceForASignThatWasAssumed() {
        QTemporaryDir folder;
        Document document = *small().document;
        Test test = *document.tests[0];
        test.imports = {{"silent.csv", std::string(64, '0'), {}, {}, true}};
        document.tests[0] = std::make_shared<const Test>(test);
        saveDocument(document, folder.filePath("x.palmer"));
        const ShownWindow shown(folder.filePath("x.palmer"));
        const auto open = [&] {
            shown.find<QAction>("compensation")->trigger();
            return shown.window->findChild<CompensationDialog *>();
        };
        const auto box = [](const CompensationDialog &dialog) {
            return dialog.findChild<QCheckBox *>("compensation.signConfirmed");
        };
        CompensationDialog *dialog = open();
        QVERIFY(box(*dialog)->isVisible() && dialog->written().isEmpty());
        QVERIFY(
            dialog->findChild<QLabel *>("compensationReason")->text().contains("“silent.csv” does not say"));
        QTest::mouseClick(box(*dialog), Qt::LeftButton, {}, {8, box(*dialog)->height() / 2});
        QVERIFY(!dialog->written().isEmpty());
        dialog->reject();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        dialog = open();
        QVERIFY(!box(*dialog)->isVisible() && !dialog->written().isEmpty());
        dialog->reject();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        shown.find<QAction>("undo")->trigger();
        QVERIFY(open()->written().isEmpty());
    }

    void savesWhatIsShown() {
        QTemporaryDir folder;
        CompensationDialog dialog(small(), 0);
        QVERIFY(dialog.saveTo(folder.filePath("x.comp")));
        QFile file(folder.filePath("x.comp"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), dialog.written());
        QVERIFY(!dialog.saveTo(folder.filePath("none/x.comp")));
        QVERIFY(dialog.findChild<QMessageBox *>("errorBox"));
    }

    void comparesWithATableOfAControl() {
        QTemporaryDir folder;
        CompensationDialog dialog(small(), 0);
        dialog.show();
        QVERIFY(dialog.saveTo(folder.filePath("old.comp"))); // both directions together
        dialog.findChild<QCheckBox *>("compensation.perDirection")->setChecked(true);
        QVERIFY(dialog.compareWith(folder.filePath("old.comp")));
        const auto *table = dialog.findChild<QTableWidget *>("prediction");
        QCOMPARE(table->columnCount(), 4);
        const auto *note = dialog.findChild<QLabel *>("compensationNote");
        QVERIFY(note->text().contains("old.comp (LinuxCNC): the largest difference"));
        for (int i = 0; i < table->rowCount(); ++i) {
            if (table->item(i, 0)->text() == "B") {
                QCOMPARE(table->item(i, 2)->text(), QString("0.0\u00A0µm"));
                QVERIFY(table->item(i, 3)->text() == table->item(i, 1)->text()); // a mean leaves the reversal
            }
        }
        QFile none(folder.filePath("none.txt"));
        QVERIFY(none.open(QIODevice::WriteOnly));
        none.write("nothing of the kind\n");
        none.close();
        QVERIFY(!dialog.compareWith(none.fileName()));
        QVERIFY(dialog.findChild<QMessageBox *>("errorBox"));
        QCOMPARE(table->columnCount(), 4); // the table before stays
    }

    void theMenuOpensIt() {
        const ShownWindow shown(examplePath("iso230-2-1988-example"));
        auto *action = shown.find<QAction>("compensation");
        QVERIFY(action->isEnabled());
        action->trigger();
        QVERIFY(shown.find<CompensationDialog>("compensationDialog")->isVisible());
    }

    void exportsReadingsAndFigures() {
        const EvaluatedDocument evaluated = small();
        QVERIFY(exportedReadings(evaluated, 0, ExportForm::csvWithPoint, "x").contains("100,0.0002,"));
        QVERIFY(exportedReadings(evaluated, 0, ExportForm::csvWithComma, "x").contains("100;0,0002;"));
        const auto json =
            QJsonDocument::fromJson(exportedReadings(evaluated, 0, ExportForm::json, "x.palmer")).object();
        QCOMPARE(json["file"].toString(), QString("x.palmer"));
        QVERIFY_THROWS_EXCEPTION(Error, (void)exportedReadings(evaluated, 0, ExportForm::dcc, "x"));
        QVERIFY(exportedFigure(evaluated, 0, ExportForm::csvWithComma).contains(";100;0,2\n"));
    }

    void speaksFrench() {
        setWindowLanguage(Language::Id::french);
        CompensationDialog dialog(small(), 0);
        QCOMPARE(dialog.windowTitle(), QString("Table de compensation"));
    }
};

QTEST_MAIN(CompensationDialogTest)
#include "compensationdialogtest.moc"
