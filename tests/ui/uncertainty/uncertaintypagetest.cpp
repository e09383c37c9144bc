#include "ui/uncertainty/uncertaintypage.h"
#include "ui/examples.h"
#include "ui/forms/field.h"
#include "ui/model/documentmodel.h"
#include "ui/model/evaluator.h"

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QTest>
#include <QUndoStack>

using namespace palmer;
using namespace palmer::ui;
using namespace palmer::testdata;
using namespace Qt::StringLiterals;

namespace {

/// The worked example with a complete budget.
Document budgetExample(std::optional<long long> trials) {
    palmer::Test test = example1988("ISO 230-2:2006");
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
    conditions.sensors.clear();
    Sensor machine;
    machine.measures = SensorMeasures::machine;
    machine.start = 20.8;
    machine.end = 20.8;
    Sensor instrument;
    instrument.measures = SensorMeasures::instrument;
    instrument.start = 20.0;
    instrument.end = 20.0;
    conditions.sensors = {machine, instrument};
    conditions.expansion = {11.5, 0.0};
    Document document;
    document.tests.push_back(std::make_shared<const palmer::Test>(std::move(test)));
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
    template <class Widget>
    Widget *part(const char *name) {
        return page.findChild<Widget *>(QString::fromLatin1(name));
    }
    QString cell(const char *table, int row, int column) {
        return part<QTableWidget>(table)->item(row, column)->text();
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
    void anInputChangesTheContributions() {
        Edited edited(budgetExample(std::nullopt));
        QVERIFY(edited.model.document());
        QVERIFY(edited.evaluator.current().tests[0]->uncertainty.complete);
        QVERIFY(edited.cell("contributions", 0, 0) != u"Environmental variation, E_VE"_s);
        edited.type(u"environmentalVariation"_s, u"30"_s);
        QCOMPARE(edited.cell("contributions", 0, 0), u"Environmental variation, E_VE"_s);
        QCOMPARE(edited.cell("contributions", 0, 3), u"18.00"_s); // 0.6 · 30 µm
        QVERIFY(edited.part<QLabel>("advice")->text().contains(u"environmental variation"_s));
        edited.model.undoStack().undo(); // one step for the visit of the field
        QVERIFY(edited.cell("contributions", 0, 0) != u"Environmental variation, E_VE"_s);
        QVERIFY(!edited.model.undoStack().canUndo());
    }

    void aMissingInputIsMarkedAndNothingIsSimulated() {
        Document document = budgetExample(std::nullopt);
        palmer::Test test = *document.tests[0];
        measurement(test).uncertainty.expansionRange.machine.reset();
        document.tests[0] = std::make_shared<const palmer::Test>(test);
        Edited edited(std::move(document));
        const auto &evaluation = *edited.evaluator.current().tests[0];
        QCOMPARE(countMissing(evaluation, Page::uncertainty), 1);
        QVERIFY(!edited.part<QPushButton>("simulate")->isEnabled());
        QCOMPARE(edited.cell("contributions", 0, 1), u"not stated"_s);
        edited.part<QPushButton>("typicalRange")->click();
        QCOMPARE(countMissing(*edited.evaluator.current().tests[0], Page::uncertainty), 0);
        QVERIFY(edited.part<QPushButton>("simulate")->isEnabled());
    }

    void theSimulationStandsBesideTheBudgetAndAgesWithAnEdit() {
        Edited edited(budgetExample(20000));
        QCOMPARE(edited.cell("methods", 0, 2), u"–"_s);
        edited.part<QPushButton>("simulate")->click();
        QTRY_VERIFY(edited.evaluator.current().tests[0]->uncertainty.simulation);
        QTRY_VERIFY(edited.cell("methods", 0, 2).startsWith(u"± "_s));
        QTRY_VERIFY(edited.part<QPushButton>("simulate")->isVisible());
        QVERIFY(!edited.part<QLabel>("simulationText")->text().contains(u"outdated"_s));
        edited.type(u"environmentalVariation"_s, u"2"_s);
        QVERIFY(edited.part<QLabel>("simulationText")->text().contains(u"outdated"_s));
    }

    void aCancelledSimulationLeavesNothing() {
        Edited edited(budgetExample(1'000'000'000));
        edited.part<QPushButton>("simulate")->click();
        QVERIFY(edited.part<QPushButton>("cancelSimulation")->isVisible());
        edited.part<QPushButton>("cancelSimulation")->click();
        QTRY_VERIFY(edited.part<QPushButton>("simulate")->isVisible());
        QVERIFY(!edited.evaluator.current().tests[0]->uncertainty.simulation);
    }

    void everythingHasAnAccessibleName() {
        Edited edited(budgetExample(std::nullopt));
        for (const char *name : {"contributions", "methods"})
            QVERIFY(!edited.part<QTableWidget>(name)->accessibleName().isEmpty());
        for (const QLineEdit *edit : edited.page.findChildren<QLineEdit *>()) {
            if (edit->objectName().startsWith(u"field."_s))
                QVERIFY2(!edit->accessibleName().isEmpty(), qPrintable(edit->objectName()));
        }
    }

    void frenchWritesFrenchNumbers() {
        Edited edited(budgetExample(std::nullopt));
        edited.page.setLanguage(Language(Language::Id::french));
        const QString size = edited.cell("contributions", 0, 3);
        QVERIFY2(size.contains(u','), qPrintable(size));
        if (qEnvironmentVariableIsSet("PALMER_GRAB"))
            edited.page.grab().save(qEnvironmentVariable("PALMER_GRAB"));
    }
};

QTEST_MAIN(UncertaintyPageTest)
#include "uncertaintypagetest.moc"
