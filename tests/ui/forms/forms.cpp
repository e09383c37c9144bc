#include "ui/examples.h"
#include "ui/forms/agreedpointspage.h"
#include "ui/forms/conditionspage.h"
#include "ui/forms/identificationpage.h"
#include "ui/forms/instrumentspage.h"
#include "ui/forms/limitspage.h"
#include "ui/forms/machinepage.h"
#include "ui/results/chip.h"

#include <QLabel>
#include <QTest>
#include <QToolButton>

using namespace palmer;
using namespace palmer::ui;
using namespace palmer::testdata;
using namespace Qt::StringLiterals;

namespace {

/// The fields of a page whose object name begins so, in the order of the page.
QList<Field *> fields(const QWidget &page, const QString &key) {
    QList<Field *> found;
    for (Field *field : page.findChildren<Field *>()) {
        if (field->edit()->objectName().startsWith(u"field."_s + key + u'.'))
            found << field;
    }
    return found;
}

} // namespace

/// The forms show a document.
class FormsTest : public QObject {
    Q_OBJECT

private slots:
    void conditionsShowWhatIsStated() {
        Test test = example1988("ISO 230-2:2006");
        auto &conditions = measurement(test).conditions;
        conditions.airPressure = 1013;
        conditions.feed = 2000;
        conditions.common.sensors = {{SensorMeasures::air, "ceiling", 20.6, 20.9, {}}};
        conditions.common.toolOffset = {0.0, 0.0, 120.5};
        conditions.common.correctionTo20 = CorrectionTo20::appliedByInstrument;
        Selection selection;
        ConditionsPage page(selection);
        page.setLanguage(Language(Language::Id::french));
        page.show(evaluatedDocument(test), 0);
        QCOMPARE(fields(page, u"airPressure"_s).at(0)->text(), u"1\u202f013"_s);
        QVERIFY(!fields(page, u"airPressure"_s).at(0)->isRequired());
        QCOMPARE(fields(page, u"feed"_s).at(0)->text(), u"2\u202f000\u00a0mm/min"_s);
        QCOMPARE(fields(page, u"sensors"_s).at(0)->text(), u"20,6"_s);
        QCOMPARE(fields(page, u"sensors"_s).at(2)->text(), u"ceiling"_s);
        QCOMPARE(fields(page, u"toolOffset"_s).at(0)->text(), u"0"_s); // stated to be zero
        QCOMPARE(fields(page, u"toolOffset"_s).at(2)->text(), u"120,5"_s);
        QVERIFY(!fields(page, u"correctionTo20"_s).at(0)->text().isEmpty());
    }

    void missingStatementsAreMarkedAndCounted() {
        Selection selection;
        ConditionsPage page(selection);
        const EvaluatedDocument evaluated = evaluatedDocument(example1988("ISO 230-2:2006"));
        page.show(evaluated, 0);
        Field *humidity = fields(page, u"airHumidity"_s).at(0);
        QVERIFY(humidity->isRequired());
        QVERIFY(!humidity->edit()->accessibleDescription().isEmpty());
        for (Field *field : page.findChildren<Field *>())
            QVERIFY(!field->isRequired() || field->text().isEmpty());
        auto *chip = page.findChild<Chip *>(u"missingChip"_s);
        QVERIFY(chip->isVisibleTo(&page));
        QVERIFY2(
            chip->text().startsWith(QString::number(countMissing(*evaluated.tests[0], Page::conditions))),
            qPrintable(chip->text()));
    }

    void aFindingLeadsToItsField() {
        Selection selection;
        ConditionsPage page(selection);
        page.show(evaluatedDocument(example1988("ISO 230-2:2006")), 0);
        page.resize(600, 400);
        page.setVisible(true);
        QVERIFY(QTest::qWaitForWindowActive(&page));
        QVERIFY(page.focusField(u"dwell"_s));
        QTRY_VERIFY(fields(page, u"dwell"_s).at(0)->edit()->hasFocus());
        QVERIFY(!page.focusField(u"drift"_s));
    }

    void everyMissingStatementHasAField() {
        const EvaluatedDocument evaluated = evaluatedDocument(example1988("ISO 230-2:2006"));
        Selection selection;
        ConditionsPage conditions(selection);
        AgreedPointsPage points(selection);
        MachinePage machine;
        InstrumentsPage instruments;
        for (Form *page : std::initializer_list<Form *>{&conditions, &machine, &instruments})
            page->show(evaluated, 0);
        points.show(evaluated, 0);
        for (const Finding &finding : evaluated.tests[0]->findings) {
            const Edition *edition = evaluated.tests[0]->edition;
            if (!isMissing(finding, edition))
                continue;
            const QString id = QString::fromStdString(finding.id);
            bool found = false;
            switch (pageOf(finding, edition)) {
            case Page::conditions:
                found = conditions.focusField(id);
                break;
            case Page::agreedPoints:
                found = points.focusField(id);
                break;
            case Page::machine:
                found = machine.focusField(id);
                break;
            case Page::instruments:
                found = instruments.focusField(id);
                break;
            default:
                break;
            }
            QVERIFY2(found, qPrintable(id));
        }
    }

    void agreedPoints() {
        Test test = example1988("ISO 230-2:2006");
        test.agreedPoints = {{"warmUp", AgreementState::agreed, "30 min"},
                             {"zone", AgreementState::notApplicable, ""}};
        Selection selection;
        AgreedPointsPage page(selection);
        page.show(evaluatedDocument(test), 0);
        QCOMPARE(page.findChild<Chip *>(u"missingChip"_s)->text(), u"7 of 9 points not agreed"_s);
        QCOMPARE(page.findChild<QLineEdit *>(u"field.agreedPoints.warmUp"_s)->text(), u"30 min"_s);
        const auto state = [&](const QString &point) {
            return page.findChild<QLineEdit *>(u"field.agreedPoints."_s + point)->accessibleDescription();
        };
        QCOMPARE(state(u"warmUp"_s), u"Agreed"_s);
        QCOMPARE(state(u"zone"_s), u"Not applicable"_s);
        QCOMPARE(state(u"feed"_s), u"Not agreed"_s);
        // Another edition has other points.
        page.show(evaluatedDocument(example1988("ISO 230-2:1988")), 0);
        QVERIFY(page.findChild<QLineEdit *>(u"field.agreedPoints.measuringReference"_s));
        QVERIFY(!page.findChild<QLineEdit *>(u"field.agreedPoints.dwell"_s));
    }

    void limits() {
        Selection selection;
        LimitsPage page(selection);
        Test test = decidedExample();
        test.limits["R"].source = "contract 12";
        page.setLanguage(Language(Language::Id::french));
        page.show(evaluatedDocument(test), 0);
        const QList<Field *> shown = fields(page, u"limits"_s);
        QCOMPARE(shown.size(), 12);
        QCOMPARE(shown.at(0)->text(), u"20"_s);
        QVERIFY(shown.at(0)->edit()->accessibleName().endsWith(u'A'));
        QStringList all;
        for (Field *field : page.findChildren<Field *>())
            all << field->text();
        QVERIFY(all.contains(u"contract 12"_s));
        page.show(evaluatedDocument(example1988("ISO 230-2:1988")), 0);
        QCOMPARE(fields(page, u"limits"_s).size(), 10);
    }

    void eachInstrumentHasItsFields() {
        auto document = std::make_shared<Document>();
        Instrument laser;
        laser.id = "laser";
        laser.serialNumber = "L-7";
        laser.resolution = 0.00001;
        Instrument ballbar;
        ballbar.id = "ballbar";
        ballbar.serialNumber = "B-9";
        document->instruments = {laser, ballbar};
        document->machine.year = 2024;
        document->report.laboratory.name = "Métrologie du Rhône";
        const EvaluatedDocument evaluated = evaluate(std::move(document));
        InstrumentsPage instruments;
        instruments.show(evaluated, 0);
        QCOMPARE(fields(instruments, u"serialNumber"_s).size(), 2);
        QCOMPARE(fields(instruments, u"serialNumber"_s).at(1)->text(), u"B-9"_s);
        QStringList texts;
        for (Field *field : instruments.findChildren<Field *>())
            texts << field->text();
        QVERIFY(texts.contains(u"0.01"_s)); // µm
        IdentificationPage identification;
        identification.show(evaluated, 0);
        texts.clear();
        for (Field *field : identification.findChildren<Field *>())
            texts << field->text();
        QVERIFY(texts.contains(u"Métrologie du Rhône"_s));
    }

    void withoutTests() {
        Selection selection;
        ConditionsPage conditions(selection);
        AgreedPointsPage points(selection);
        LimitsPage limits(selection);
        const EvaluatedDocument empty = evaluate(std::make_shared<Document>());
        conditions.show(empty, 0);
        points.show(empty, 0);
        limits.show(empty, 0);
        for (Field *field : conditions.findChildren<Field *>())
            QVERIFY(field->text().isEmpty());
    }
};

QTEST_MAIN(FormsTest)
#include "forms.moc"
