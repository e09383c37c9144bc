// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/edits.h"
#include "ui/chip.h"
#include "ui/circles.h"
#include "ui/examples.h"
#include "ui/forms/agreedpointspage.h"
#include "ui/forms/conditionspage.h"
#include "ui/forms/equipmentpages.h"
#include "ui/forms/identificationpage.h"
#include "ui/forms/limitspage.h"
#include "ui/forms/sectionhead.h"

#include "document/readdocument.h"
#include "document/writedocument.h"
#include "ui/forms/templatebutton.h"
#include "ui/guards.h"
#include "ui/model/documentmodel.h"
#include "ui/model/editname.h"
#include "ui/model/evaluator.h"
#include "ui/model/templatestore.h"
#include "ui/windowlanguage.h"

#include <QAccessible>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QStandardPaths>
#include <QStyleOptionButton>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>
#include <QWheelEvent>

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

palmer::Test positioningTest(Motion motion, std::vector<std::string> instruments) {
    palmer::Test test;
    test.id = "t";
    test.edition = "ISO 230-2:2014";
    test.instruments = std::move(instruments);
    PositioningMeasurement measurement;
    measurement.axis.name = "C";
    measurement.axis.motion = motion;
    test.measurement = std::move(measurement);
    return test;
}

/// A page that edits a document, as in a window: what is typed is evaluated and shown again.
template <class PageClass>
struct Edited {
    explicit Edited(Document document)
        : page(model, selection) {
        QObject::connect(&model, &DocumentModel::changed, &evaluator,
                         [this] { evaluator.setDocument(model.document()); });
        QObject::connect(&evaluator, &Evaluator::evaluated, &page,
                         [this](const EvaluatedDocument &evaluated) { page.show(evaluated, 0); });
        model.setDocument(std::move(document), {});
        page.resize(600, 700);
        page.QWidget::show();
        page.activateWindow();
        if (!QTest::qWaitForWindowActive(&page))
            qFatal("the window does not become active");
    }

    /// The first field of that key, with the focus.
    Field *enter(const QString &key, int index = 0) {
        const QList<Field *> found = fields(page, key);
        if (index >= found.size())
            qFatal("no field %s", qPrintable(key));
        found[index]->edit()->setFocus(Qt::TabFocusReason);
        if (auto *line = qobject_cast<QLineEdit *>(found[index]->edit()))
            line->selectAll();
        return found[index];
    }
    void type(const QString &key, const QString &text, int index = 0) {
        QWidget *field = enter(key, index)->edit();
        for (const QChar c : text) { // QTest types ASCII only
            QKeyEvent press(QEvent::KeyPress, 0, Qt::NoModifier, QString(c));
            QApplication::sendEvent(field, &press);
        }
    }
    const Test &test() { return *model.document()->tests.at(0); }
    const PositioningConditions &conditions() {
        return std::get<PositioningMeasurement>(test().measurement).conditions;
    }

    DocumentModel model;
    Evaluator evaluator;
    Selection selection;
    PageClass page;
};

Document documentOf(const Test &test) {
    Document document;
    document.tests.push_back(std::make_shared<const Test>(test));
    return document;
}

Document example() {
    return documentOf(example1988("ISO 230-2:2006"));
}

/// Chooses the word of that index as a user does.
void choose(Field *field, int index) {
    if (auto *answer = qobject_cast<QCheckBox *>(field->edit())) {
        while (field->choice() != index)
            answer->click();
        return;
    }
    auto *box = qobject_cast<QComboBox *>(field->edit());
    box->setCurrentIndex(index);
    emit box->activated(index);
}

/// The head of a section of the conditions.
SectionHead *section(const QWidget &page, const char *title) {
    auto *found = page.findChild<SectionHead *>(u"section."_s + QLatin1StringView(title));
    if (!found)
        qFatal("no section %s", title);
    return found;
}

/// As a page comes into view again.
void showAgain(QWidget &page) {
    page.hide();
    page.setVisible(true);
    page.activateWindow();
    if (!QTest::qWaitForWindowActive(&page))
        qFatal("the window does not become active");
}

QPushButton *button(QWidget &page, const char *name) {
    auto *found = page.findChild<QPushButton *>(QLatin1StringView(name));
    if (!found)
        qFatal("no button %s", name);
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
        DocumentModel model;
        ConditionsPage page(model, selection);
        page.setLanguage(Language(Language::Id::french));
        page.show(evaluatedDocument(test), 0);
        QCOMPARE(fields(page, u"airPressure"_s).at(0)->text(), u"1\u202f013"_s);
        QVERIFY(!fields(page, u"airPressure"_s).at(0)->isRequired());
        QCOMPARE(fields(page, u"feed"_s).at(0)->text(), u"2\u202f000"_s);
        QCOMPARE(fields(page, u"sensors"_s).at(0)->text(), u"20,6"_s);
        QCOMPARE(fields(page, u"sensors"_s).at(2)->text(), u"ceiling"_s);
        QCOMPARE(fields(page, u"toolOffset"_s).at(0)->text(), u"0"_s); // stated to be zero
        QCOMPARE(fields(page, u"toolOffset"_s).at(2)->text(), u"120,5"_s);
        QVERIFY(!fields(page, u"correctionTo20"_s).at(0)->text().isEmpty());
    }

    void missingStatementsAreMarkedAndCounted() {
        Selection selection;
        DocumentModel model;
        ConditionsPage page(model, selection);
        const EvaluatedDocument evaluated = evaluatedDocument(example1988("ISO 230-2:2006"));
        page.show(evaluated, 0);
        Field *humidity = fields(page, u"airHumidity"_s).at(0);
        QVERIFY(humidity->isUsual() && !humidity->isRequired()); // only practice asks for it
        QVERIFY(!humidity->edit()->accessibleDescription().isEmpty());
        int required = 0;
        int usual = 0;
        for (Field *field : page.findChildren<Field *>()) {
            QVERIFY((!field->isRequired() && !field->isUsual()) || field->text().isEmpty());
            required += field->isRequired();
            usual += field->isUsual();
        }
        QCOMPARE(required, countMissing(evaluated, 0, Page::conditions)); // as many marks as are counted
        QCOMPARE(page.findChild<LinkChip *>(u"usualChip"_s)->text(), u"%1 usual"_s.arg(usual));
        auto *chip = page.findChild<LinkChip *>(u"missingChip"_s);
        QVERIFY(chip->isVisibleTo(&page));
        QVERIFY2(chip->text().startsWith(QString::number(countMissing(evaluated, 0, Page::conditions))),
                 qPrintable(chip->text()));
    }

    void aFindingLeadsToItsField() {
        Selection selection;
        DocumentModel model;
        ConditionsPage page(model, selection);
        page.show(evaluatedDocument(example1988("ISO 230-2:2006")), 0);
        page.resize(600, 400);
        page.setVisible(true);
        QVERIFY(QTest::qWaitForWindowActive(&page));
        QVERIFY(page.focusField(u"dwell"_s));
        QTRY_VERIFY(fields(page, u"dwell"_s).at(0)->edit()->hasFocus());
        QVERIFY(!page.focusField(u"drift"_s));
    }

    void theFirstFieldIsToBeTypedOver() {
        Test test = example1988("ISO 230-2:2006");
        measurement(test).axis.name = "Xa";
        Edited<ConditionsPage> edited(documentOf(test));
        edited.enter(u"dwell"_s);
        edited.page.focusFirst();
        auto *first = qobject_cast<QLineEdit *>(edited.page.focusWidget());
        QVERIFY(first);
        QCOMPARE(first->selectedText(), u"Xa"_s);
    }

    void everyMissingStatementHasAField() {
        const EvaluatedDocument evaluated = evaluatedDocument(example1988("ISO 230-2:2006"));
        Selection selection;
        DocumentModel model;
        ConditionsPage conditions(model, selection);
        AgreedPointsPage points(model, selection);
        MachinePage machine(model, selection);
        InstrumentsPage instruments(model, selection);
        for (Form *page : std::initializer_list<Form *>{&conditions, &machine, &instruments})
            page->show(evaluated, 0);
        points.show(evaluated, 0);
        for (const Finding &finding : evaluated.tests[0]->findings) {
            if (!finding.missing)
                continue;
            const QString id = fieldOf(finding);
            bool found = false;
            switch (pageOf(finding, *evaluated.document)) {
            case Page::uncertainty: // a page of its own
                found = true;
                break;
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

    void theReferenceLengthOfACircleIsStated() {
        Test test = decidedPair();
        circular(test).referenceLength = {};
        circular(test).uncertainty.method = UncertaintyMethod::budget;
        Edited<ConditionsPage> edited(documentOf(test));
        Field *field = fields(edited.page, u"referenceLength"_s).at(0);
        QVERIFY(field->isRequired());
        QVERIFY(edited.page.focusField(u"referenceLength"_s));
        auto *choice = qobject_cast<QComboBox *>(field->edit());
        choice->setCurrentIndex(1);
        emit choice->activated(1);
        QCOMPARE(std::get<CircularMeasurement>(edited.test().measurement).referenceLength.calibrated,
                 std::optional(true));
        QVERIFY(!field->isRequired());
        // Its uncertainty is a matter of the budget.
        const TestEvaluation &evaluation = *edited.evaluator.current().tests[0];
        const auto missing = std::ranges::find(evaluation.findings, "referenceLength", &Finding::id);
        QVERIFY(missing != evaluation.findings.end());
        QCOMPARE(pageOf(*missing, *edited.model.document()), Page::uncertainty);
    }

    void theInstrumentOfATestIsChosenOnItsPage() {
        Document document;
        document.tests.push_back(std::make_shared<const palmer::Test>(example1988("ISO 230-2:2014")));
        for (const bool known : {false, true}) {
            if (known)
                document.instruments.emplace_back().id = "L1";
            const EvaluatedDocument evaluated = evaluate(std::make_shared<const Document>(document));
            const auto &findings = evaluated.tests[0]->findings;
            const auto missing = std::ranges::find(findings, "instruments", &Finding::id);
            QVERIFY(missing != findings.end());
            const Page page = pageOf(*missing, document);
            QCOMPARE(page, known ? Page::conditions : Page::instruments);
            if (!known)
                continue;
            DocumentModel model;
            Selection selection;
            ConditionsPage conditions(model, selection);
            conditions.show(evaluated, 0);
            QVERIFY(conditions.focusField(u"instruments"_s));
            QCOMPARE(conditions.focusWidget()->objectName(), u"uses.L1"_s);
        }
    }

    void agreedPoints() {
        Test test = example1988("ISO 230-2:2006");
        test.agreedPoints = {{"warmUp", AgreementState::agreed, "30 min"},
                             {"zone", AgreementState::notApplicable, ""}};
        Selection selection;
        DocumentModel model;
        AgreedPointsPage page(model, selection);
        page.show(evaluatedDocument(test), 0);
        QCOMPARE(page.findChild<LinkChip *>(u"missingChip"_s)->text(), u"4 of 9 points to be agreed"_s);
        QCOMPARE(page.findChild<QLineEdit *>(u"field.agreedPoints.warmUp"_s)->text(), u"30 min"_s);
        const auto state = [&](const QString &point) {
            return page.findChild<QLineEdit *>(u"field.agreedPoints."_s + point)->accessibleDescription();
        };
        QCOMPARE(state(u"warmUp"_s), u"Agreed"_s);
        QCOMPARE(state(u"zone"_s), u"Not applicable"_s);
        QCOMPARE(state(u"feed"_s), u"Not declared"_s);
        // Another edition has other points.
        page.show(evaluatedDocument(example1988("ISO 230-2:1988")), 0);
        QVERIFY(page.findChild<QLineEdit *>(u"field.agreedPoints.measuringReference"_s));
        QVERIFY(!page.findChild<QLineEdit *>(u"field.agreedPoints.dwell"_s));
    }

    void limits() {
        Selection selection;
        DocumentModel model;
        LimitsPage page(model, selection);
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
        DocumentModel model;
        Selection selection;
        InstrumentsPage instruments(model, selection);
        instruments.show(evaluated, 0);
        QCOMPARE(fields(instruments, u"serialNumber"_s).size(), 2);
        QCOMPARE(fields(instruments, u"serialNumber"_s).at(1)->text(), u"B-9"_s);
        QStringList texts;
        for (Field *field : instruments.findChildren<Field *>())
            texts << field->text();
        QVERIFY(texts.contains(u"0.01"_s)); // µm
        // As on the report: a rotary axis that names it makes it an angular instrument.
        auto rotary = std::make_shared<Document>(*evaluated.document);
        rotary->tests = {std::make_shared<const palmer::Test>(positioningTest(Motion::rotary, {"laser"}))};
        instruments.show(evaluate(std::move(rotary)), 0);
        texts.clear();
        for (Field *field : instruments.findChildren<Field *>())
            texts << field->text();
        QVERIFY2(texts.contains(u"0.036"_s), qPrintable(texts.join(u' '))); // seconds of arc
        IdentificationPage identification(model, selection);
        identification.show(evaluated, 0);
        texts.clear();
        for (Field *field : identification.findChildren<Field *>())
            texts << field->text();
        QVERIFY(texts.contains(u"Métrologie du Rhône"_s));
    }

    // ---- Editing

    void aTypedFieldIsOneStep() {
        Edited<ConditionsPage> edited(example());
        const Document before = *edited.model.document();
        edited.type(u"airPressure"_s, u"1 013,25"_s);
        QCOMPARE(edited.conditions().airPressure, std::optional(1013.25));
        QCOMPARE(edited.model.undoStack()->count(), 1);
        QCOMPARE(editName(edited.model.undoStack()->undoText()), u"change “Air pressure”"_s);
        edited.type(u"airHumidity"_s, u"48"_s);
        QCOMPARE(edited.model.undoStack()->count(), 2);
        QVERIFY(!fields(edited.page, u"airHumidity"_s).at(0)->isRequired());
        edited.type(u"airPressure"_s, u"990"_s); // another visit
        QCOMPARE(edited.model.undoStack()->count(), 3);
        while (edited.model.undoStack()->canUndo())
            edited.model.undoStack()->undo();
        QVERIFY(*edited.model.document() == before);
        QCOMPARE(fields(edited.page, u"airPressure"_s).at(0)->text(), QString());
        while (edited.model.undoStack()->canRedo())
            edited.model.undoStack()->redo();
        QCOMPARE(edited.conditions().airPressure, std::optional(990.0));
    }

    void numbersInEitherDecimalMark_data() {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<double>("value");
        QTest::newRow("a comma") << u"20,6"_s << 20.6;
        QTest::newRow("a point") << u"20.6"_s << 20.6;
        QTest::newRow("a minus of typography") << u"\u22123,5"_s << -3.5;
        QTest::newRow("groups of thousands") << u"1 234,5"_s << 1234.5;
    }
    void numbersInEitherDecimalMark() {
        QFETCH(QString, typed);
        QFETCH(double, value);
        for (const auto id : {Language::Id::english, Language::Id::french}) {
            Edited<ConditionsPage> edited(example());
            edited.page.setLanguage(Language(id));
            edited.type(u"sensors"_s, typed);
            const auto &sensors = edited.conditions().common.sensors;
            QCOMPARE(sensors.size(), std::size_t(1));
            QCOMPARE(sensors[0].measures, SensorMeasures::air);
            QCOMPARE(sensors[0].start, std::optional(value));
        }
    }

    void whatIsTypedStaysUntilTheFieldIsLeft() {
        Edited<ConditionsPage> edited(example());
        edited.page.setLanguage(Language(Language::Id::french));
        Field *pressure = edited.enter(u"airPressure"_s);
        QTest::keyClicks(pressure->edit(), u"1013."_s);
        QCOMPARE(pressure->text(), u"1013."_s);
        QTest::keyClicks(pressure->edit(), u"50"_s);
        QCOMPARE(pressure->text(), u"1013.50"_s);
        edited.enter(u"airHumidity"_s);
        QCOMPARE(pressure->text(), u"1\u202f013,5"_s);
    }

    void whatIsBeyondItsBoundsStaysInRed() {
        Edited<ConditionsPage> edited(documentOf(example1988("ISO 230-2:2006")));
        edited.page.setLanguage(Language(Language::Id::english));
        const auto refusalOf = [&](const QString &field, const QString &typed) {
            Field *entered = edited.enter(field);
            QTest::keyClicks(entered->edit(), typed);
            return entered->refusal();
        };
        QCOMPARE(refusalOf(u"sensors"_s, u"-300"_s), u"Expected a temperature of −273.15 °C or more."_s);
        QCOMPARE(refusalOf(u"expansion"_s, u"117"_s),
                 u"Expected a coefficient of expansion between −100 and 100 µm/(m·°C)."_s);
        QCOMPARE(refusalOf(u"expansion"_s, u"0.0000115"_s),
                 u"Expected 0 or a coefficient in µm/(m·°C), such as 11.5 for steel."_s);
    }

    void noNumberStaysInRed() {
        Test test = example1988("ISO 230-2:2006");
        measurement(test).conditions.airPressure = 1013;
        Edited<ConditionsPage> edited(documentOf(test));
        edited.page.setLanguage(Language(Language::Id::english));
        Field *pressure = edited.enter(u"airPressure"_s);
        QTest::keyClicks(pressure->edit(), u"12O"_s);
        QVERIFY(pressure->isRefused());
        QCOMPARE(pressure->refusal(), u"Not a number; 1\u202f013\u00a0hPa kept."_s);
        QCOMPARE(edited.conditions().airPressure, std::optional(1013.0));
        edited.enter(u"airHumidity"_s);
        QVERIFY(pressure->isRefused());
        QCOMPARE(pressure->text(), u"12O"_s);
        // Esc restores what was there when the focus came, now the kept value.
        edited.enter(u"airPressure"_s);
        QTest::keyClick(pressure->edit(), Qt::Key_Escape);
        QVERIFY(!pressure->isRefused());
        QCOMPARE(pressure->text(), u"1\u202f013"_s);
        QVERIFY(!edited.model.undoStack()->canUndo());
    }

    void aDegreeStandsAtItsNumber() {
        Test test = example1988("ISO 230-2:2006");
        measurement(test).axis.motion = Motion::rotary;
        measurement(test).axis.travel = 360;
        Edited<ConditionsPage> edited(documentOf(test));
        edited.page.setLanguage(Language(Language::Id::english));
        Field *travel = edited.enter(u"travel"_s);
        QTest::keyClicks(travel->edit(), u"all"_s);
        QCOMPARE(travel->refusal(), u"Not a number; 360° kept."_s);
    }

    void aRefusalFollowsTheLanguage() {
        Edited<ConditionsPage> edited(documentOf(example1988("ISO 230-2:2006")));
        edited.page.setLanguage(Language(Language::Id::english));
        Field *pressure = edited.enter(u"airPressure"_s);
        QTest::keyClicks(pressure->edit(), u"12O"_s);
        QCOMPARE(pressure->refusal(), u"Not a number."_s);
        setWindowLanguage(Language::Id::french);
        edited.page.setLanguage(Language(Language::Id::french));
        QCoreApplication::processEvents();
        QCOMPARE(pressure->refusal(), u"Pas un nombre."_s);
        setWindowLanguage(Language::Id::english);
    }

    /// A text longer than a test file holds is refused with a sentence, never cut; the one before is kept.
    void aTextTooLongStaysInRed_data() {
        QTest::addColumn<int>("index");
        QTest::addColumn<int>("most");
        QTest::newRow("address") << 0 << 65536;
        QTest::newRow("address of the customer") << 1 << 65536;
        QTest::newRow("adjustments") << 3 << 4096;
        QTest::newRow("remarks") << 4 << 65536;
        QTest::newRow("a line") << -1 << 4096;
    }
    void aTextTooLongStaysInRed() {
        QFETCH(const int, index);
        QFETCH(const int, most);
        Edited<IdentificationPage> edited(example());
        edited.page.setLanguage(Language(Language::Id::english));
        QWidget *edit = index < 0 ? static_cast<QWidget *>(edited.page.findChildren<QLineEdit *>().at(0))
                                  : edited.page.findChildren<QPlainTextEdit *>().at(index);
        auto *field = qobject_cast<Field *>(edit->parentWidget());
        QVERIFY(field);
        edit->setFocus(Qt::TabFocusReason);
        const auto paste = [&](const QString &text) {
            QMetaObject::invokeMethod(edit, "selectAll");
            QApplication::clipboard()->setText(text);
            QMetaObject::invokeMethod(edit, "paste");
        };
        const auto held = [&] {
            const QByteArray file = writeDocument(*edited.model.document());
            (void)readDocument(file); // can be opened again
            int longest = 0;
            int run = 0;
            for (const char c : file)
                longest = std::max(longest, run = c == 'x' ? run + 1 : 0);
            return longest;
        };
        paste(QString(most, u'x'));
        QVERIFY(!field->isRefused());
        QCOMPARE(held(), most);
        paste(QString(most + 1, u'x'));
        QVERIFY(field->isRefused());
        QCOMPARE(field->text().size(), qsizetype(most + 1));
        QVERIFY(field->refusal().startsWith(QString::number(most + 1)));
        QVERIFY(field->refusal().contains(QString::number(most)));
        QVERIFY(held() <= most);
        paste(u"short"_s);
        QVERIFY(!field->isRefused());
        QVERIFY(held() < 10);
    }

    /// Nor does the reason of a refusal, which comes and goes while a date is typed.
    void aTextThatIsNotFinishedMovesNothing() {
        for (const char *key : {"date", "travel", "dwell"}) {
            Edited<ConditionsPage> edited(example());
            Field *field = edited.enter(QString::fromLatin1(key));
            const auto places = [&] {
                QList<QRect> found;
                for (const Field *one : edited.page.findChildren<Field *>())
                    if (one->isVisible())
                        found << QRect(one->mapTo(&edited.page, QPoint()), one->size());
                return found;
            };
            QTest::qWait(20); // the page has scrolled to its field
            const QList<QRect> before = places();
            edited.type(QString::fromLatin1(key), u"2x"_s);
            QVERIFY(field->isRefused());
            QTest::qWait(20);
            QCOMPARE(places(), before);
            const auto labels = edited.page.findChildren<QLabel *>(u"refusal"_s);
            const auto shown =
                std::ranges::find_if(labels, [](const QLabel *label) { return label->isVisible(); });
            QVERIFY(shown != labels.end());
            QCOMPARE((*shown)->text(), field->refusal());
            QVERIFY((*shown)->width() >= (*shown)->sizeHint().width());
            const QWidget *row = (*shown)->parentWidget();
            const QRect reason(row->mapTo(&edited.page, QPoint()), row->size());
            QVERIFY(reason.top() >= before[0].top());
            for (const QRect &place : before)
                QVERIFY(!place.intersects(reason));
        }
    }

    /// It covers the label below only while it is typed; later the mark at its own label says it.
    void aRefusalCoversNoLabelOnceItsFieldIsLeft() {
        Edited<ConditionsPage> edited(example());
        for (const char *key : {"date", "time", "feed", "dwell"})
            edited.type(QString::fromLatin1(key), u"abc"_s);
        const auto reasons = [&] {
            const auto labels = edited.page.findChildren<QLabel *>(u"refusal"_s);
            return std::ranges::count_if(labels, [](const QLabel *label) { return label->isVisible(); });
        };
        QVERIFY(reasons() <= 1);
        edited.enter(u"compensation"_s);
        QCOMPARE(reasons(), 0);
        int refused = 0;
        for (const Field *field : edited.page.findChildren<Field *>()) {
            if (!field->isRefused())
                continue;
            ++refused;
            const auto labels = field->findChildren<QLabel *>();
            QVERIFY(std::ranges::any_of(labels, [](const QLabel *label) {
                return label->isVisible() && label->text().startsWith(u'⚠');
            }));
            QCOMPARE(field->edit()->toolTip(), field->refusal());
        }
        QCOMPARE(refused, 4);
    }

    void aTextOfAnAgreementThatIsTooLongIsRefused() {
        Edited<AgreedPointsPage> edited(example());
        auto *text = edited.page.findChildren<QLineEdit *>().at(0);
        auto *refusal = edited.page.findChild<QLabel *>(
            QString(text->objectName()).replace(u"field.agreedPoints"_s, u"refusal"_s));
        QVERIFY(refusal);
        const auto paste = [&](const QString &words) {
            text->selectAll();
            QApplication::clipboard()->setText(words);
            text->paste();
        };
        const auto held = [&] {
            std::size_t longest = 0;
            for (const AgreedPoint &point : edited.test().agreedPoints)
                longest = std::max(longest, point.text.size());
            return longest;
        };
        paste(QString(65536, u'x'));
        QVERIFY(refusal->isHidden());
        QCOMPARE(held(), std::size_t(65536));
        paste(QString(65537, u'y'));
        QVERIFY(!refusal->isHidden());
        QVERIFY(refusal->text().contains(u"65537"_s) && refusal->text().contains(u"65536"_s));
        QCOMPARE(text->text().size(), qsizetype(65537));
        QCOMPARE(held(), std::size_t(65536));
        paste(u"agreed"_s);
        QVERIFY(refusal->isHidden());
        QVERIFY(held() < 100);
    }

    void escapeTakesBackWhatWasTyped() {
        Edited<ConditionsPage> edited(example());
        const Document before = *edited.model.document();
        Field *pressure = edited.enter(u"airPressure"_s);
        QTest::keyClicks(pressure->edit(), u"990"_s);
        QTest::keyClick(pressure->edit(), Qt::Key_Escape);
        QVERIFY(*edited.model.document() == before);
        QVERIFY(!edited.model.undoStack()->canUndo());
    }

    void undoOfAFieldIsTheWindows() {
        Edited<ConditionsPage> edited(example());
        Field *pressure = edited.enter(u"airPressure"_s);
        QTest::keyClicks(pressure->edit(), u"990"_s);
        QKeyEvent undo(QEvent::ShortcutOverride, Qt::Key_Z, Qt::ControlModifier);
        undo.ignore();
        QApplication::sendEvent(pressure->edit(), &undo);
        QVERIFY(!undo.isAccepted()); // the shortcut of the window is taken instead
        edited.model.undoStack()->undo();
        QCOMPARE(pressure->text(), QString());
        QTest::keyClicks(pressure->edit(), u"7"_s);
        QCOMPARE(edited.conditions().airPressure, std::optional(7.0));
    }

    void wordsAreChosen() {
        Edited<ConditionsPage> edited(documentOf(example1988("ISO 230-2:1988")));
        Field *correction = edited.enter(u"correctionTo20"_s);
        choose(correction, 2);
        QCOMPARE(edited.conditions().common.correctionTo20, CorrectionTo20::appliedByInstrument);
        choose(edited.enter(u"complete"_s), 1);
        choose(edited.enter(u"levelled"_s), 2);
        QCOMPARE(edited.conditions().common.complete, std::optional(true));
        QCOMPARE(edited.conditions().common.levelled, std::optional(false));
        choose(edited.enter(u"levelled"_s), 0);
        QCOMPARE(edited.conditions().common.levelled, std::optional<bool>());
        QCOMPARE(edited.model.undoStack()->count(), 5); // on the way to no it was yes
    }

    void theWheelChangesNoUnfocusedField() {
        guardWidgets(*qApp);
        Edited<ConditionsPage> edited(example());
        edited.enter(u"airPressure"_s);
        const Document before = *edited.model.document();
        auto *box = qobject_cast<QComboBox *>(fields(edited.page, u"correctionTo20"_s).at(0)->edit());
        QWheelEvent wheel(QPointF(4, 4), box->mapToGlobal(QPointF(4, 4)), QPoint(), QPoint(0, -120),
                          Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(box, &wheel);
        QCOMPARE(box->currentIndex(), 0);
        // As from a real wheel, at which Qt moves the focus first.
        QSpontaneKeyEvent::setSpontaneous(&wheel);
        qApp->notify(box, &wheel);
        QCOMPARE(box->currentIndex(), 0);
        QVERIFY(!box->hasFocus());
        QVERIFY(*edited.model.document() == before);
    }

    void sensorsAreAddedAndRemoved() {
        Edited<ConditionsPage> edited(example());
        edited.type(u"sensors"_s, u"20.7"_s, 3); // machine, start
        button(edited.page, "addMachineSensor")->click();
        const auto &sensors = edited.conditions().common.sensors;
        QCOMPARE(sensors.size(), std::size_t(2));
        QCOMPARE(sensors[1].measures, SensorMeasures::machine);
        QCOMPARE(fields(edited.page, u"sensors"_s).size(), 12);
        QCOMPARE(edited.page.focusWidget(), fields(edited.page, u"sensors"_s).at(6)->edit());
        edited.type(u"sensors"_s, u"column"_s, 8); // position of the second one
        QCOMPARE(edited.conditions().common.sensors.at(1).position, std::string("column"));
        edited.model.undoStack()->undo();
        edited.model.undoStack()->undo();
        QCOMPARE(edited.conditions().common.sensors.size(), std::size_t(1));
        QCOMPARE(fields(edited.page, u"sensors"_s).size(), 9);
        // What says nothing more goes.
        Field *start = edited.enter(u"sensors"_s, 3);
        QTest::keyClick(start->edit(), Qt::Key_Delete);
        QVERIFY(edited.conditions().common.sensors.empty());
    }

    void aSensorOfNothingStatedIsShownAndRemoved() {
        Document document = example();
        editTest(document, 0, [](Test &test) {
            conditionsOf(test)->sensors.push_back({SensorMeasures::notStated, "table", 19.5, {}, {}});
        });
        Edited<ConditionsPage> edited(document);
        QCOMPARE(fields(edited.page, u"sensors"_s).size(), 12);
        QCOMPARE(fields(edited.page, u"sensors"_s).at(11)->text(), u"table"_s);
        for (auto *one : edited.page.findChildren<QAbstractButton *>()) {
            if (one->text() == u"Remove"_s)
                one->click();
        }
        QVERIFY(edited.conditions().common.sensors.empty());
        QCOMPARE(fields(edited.page, u"sensors"_s).size(), 9);
    }

    void datesAreReadInManyForms() {
        Edited<ConditionsPage> edited(example());
        edited.page.setLanguage(Language(Language::Id::english));
        edited.type(u"date"_s, u"12.03.2026"_s);
        QCOMPARE(edited.test().date, std::optional<std::string>("2026-03-12"));
        edited.enter(u"airPressure"_s);
        QCOMPARE(fields(edited.page, u"date"_s).at(0)->text(), u"12\u00a0March 2026"_s);
        edited.type(u"date"_s, u"31.02.2026"_s);
        QVERIFY(fields(edited.page, u"date"_s).at(0)->isRefused());
        QCOMPARE(edited.test().date, std::optional<std::string>("2026-03-12"));
    }

    void turningTheAxisIntoARotaryOneChangesTheUnits() {
        Edited<ConditionsPage> edited(example());
        for (Field *field : edited.page.findChildren<Field *>()) {
            if (field->edit()->accessibleName() == u"Motion"_s) {
                choose(field, 1);
                break;
            }
        }
        const auto &axis = std::get<PositioningMeasurement>(edited.test().measurement).axis;
        QCOMPARE(axis.motion, Motion::rotary);
        QStringList units;
        for (const QLabel *label : fields(edited.page, u"feed"_s).at(0)->findChildren<QLabel *>())
            units << label->text();
        QVERIFY(units.contains(u"°/min"_s));
    }

    void theFirstInstrumentIsThatOfTheTests() {
        Edited<InstrumentsPage> edited(example());
        edited.type(u"instruments"_s, u"laser"_s);
        const auto &instruments = edited.model.document()->instruments;
        QCOMPARE(instruments.size(), std::size_t(1));
        QCOMPARE(instruments[0].description, std::string("laser"));
        QCOMPARE(edited.test().instruments, std::vector{instruments[0].id});
        QCOMPARE(edited.model.undoStack()->count(), 1);
        edited.type(u"id"_s, u"xl80"_s);
        QCOMPARE(edited.test().instruments, std::vector<std::string>{"xl80"});
        button(edited.page, "addInstrument")->click();
        QCOMPARE(fields(edited.page, u"serialNumber"_s).size(), 2);
        QCOMPARE(edited.page.focusWidget(), fields(edited.page, u"instruments"_s).at(1)->edit());
        edited.type(u"id"_s, u"xl80"_s, 1);
        QVERIFY(fields(edited.page, u"id"_s).at(1)->isRefused());
        button(edited.page, "removeInstrument0")->click();
        QCOMPARE(edited.model.document()->instruments.size(), std::size_t(1));
        QVERIFY(edited.test().instruments.empty());
    }

    void agreementsHaveFourStates() {
        Edited<AgreedPointsPage> edited(example());
        auto *warmUp = edited.page.findChild<QLineEdit *>(u"field.agreedPoints.warmUp"_s);
        warmUp->setFocus();
        QTest::keyClicks(warmUp, u"30 min"_s);
        QCOMPARE(edited.test().agreedPoints.size(), std::size_t(1));
        QCOMPARE(edited.test().agreedPoints[0].text, std::string("30 min"));
        QCOMPARE(edited.test().agreedPoints[0].state, AgreementState::agreed);
        QCOMPARE(edited.model.undoStack()->count(), 1);
        QTest::mouseClick(edited.page.findChild<QToolButton *>(u"state2.warmUp"_s), Qt::LeftButton);
        QCOMPARE(edited.test().agreedPoints[0].state, AgreementState::notApplicable);
        QTest::mouseClick(edited.page.findChild<QToolButton *>(u"state1.warmUp"_s), Qt::LeftButton);
        QCOMPARE(edited.test().agreedPoints[0].state, AgreementState::notAgreed);
        QVERIFY(edited.page.findChild<QToolButton *>(u"state1.warmUp"_s)->isChecked());
        QVERIFY(!edited.page.findChild<QToolButton *>(u"state2.warmUp"_s)->isChecked());
        QVERIFY(!edited.page.findChild<QToolButton *>(u"state3.warmUp"_s)->isChecked());
        QTest::mouseClick(edited.page.findChild<QToolButton *>(u"state3.warmUp"_s), Qt::LeftButton);
        QVERIFY(edited.test().agreedPoints.empty()); // no entry: not declared
        QVERIFY(edited.page.findChild<QToolButton *>(u"state3.warmUp"_s)->isChecked());
    }

    void aNumberOutlivesTheTextOfItsAgreement() {
        Document document = example();
        editTest(document, 0, [](Test &test) {
            test.agreedPoints = {{"gradient", AgreementState::agreed, "x", 0.5}};
        });
        Edited<AgreedPointsPage> edited(document);
        auto *text = edited.page.findChild<QLineEdit *>(u"field.agreedPoints.gradient"_s);
        text->setFocus();
        text->selectAll();
        QTest::keyClick(text, Qt::Key_Backspace);
        QCOMPARE(edited.test().agreedPoints.size(), std::size_t(1));
        QVERIFY(edited.test().agreedPoints[0].value == 0.5);
        QVERIFY(edited.test().agreedPoints[0].text.empty());
    }

    void agreementsAreTakenFromTheConditions() {
        Test test = example1988("ISO 230-2:2006");
        measurement(test).conditions.dwell = 5;
        Edited<AgreedPointsPage> edited(documentOf(test));
        auto *take = button(edited.page, "take.dwell");
        QVERIFY(take->isVisibleTo(&edited.page));
        QVERIFY(!button(edited.page, "take.warmUp")->isVisibleTo(&edited.page));
        take->click();
        QCOMPARE(edited.test().agreedPoints.at(0).text, std::string("5\u00a0s"));
        QCOMPARE(edited.test().agreedPoints.at(0).state, AgreementState::agreed);
        QVERIFY(!take->isVisibleTo(&edited.page));
    }

    /// A text would be printed besides, in the decimals of the window whatever the language of the report.
    void theNumberOfAnAgreementIsTakenAsNumber() {
        Test test = example1988("ISO 230-2:2006");
        measurement(test).conditions.gradientPerHour = 0.4;
        Edited<AgreedPointsPage> edited(documentOf(test));
        edited.page.setLanguage(Language(Language::Id::french));
        auto *take = button(edited.page, "take.gradient");
        take->click();
        QVERIFY(edited.test().agreedPoints.at(0).value == 0.4);
        QCOMPARE(edited.test().agreedPoints[0].text, std::string());
        QCOMPARE(edited.test().agreedPoints[0].state, AgreementState::agreed);
        QVERIFY(!take->isVisibleTo(&edited.page));
    }

    void limitsAreEntered() {
        Edited<LimitsPage> edited(example());
        edited.type(u"limits"_s, u"20,5"_s); // µm
        QCOMPARE(edited.test().limits.at("A").value, std::optional(0.0205));
        QCOMPARE(edited.test().limits.size(), std::size_t(1));
        Field *limit = edited.enter(u"limits"_s);
        QTest::keyClick(limit->edit(), Qt::Key_Delete);
        QVERIFY(edited.test().limits.empty());
        choose(edited.enter(u"decisionRule"_s), 1);
        QCOMPARE(edited.test().decisionRule.rule, Rule::iso14253_1);
        edited.type(u"guardFactor"_s, u"-1"_s);
        QVERIFY(fields(edited.page, u"guardFactor"_s).at(0)->isRefused());
        QCOMPARE(edited.test().decisionRule.guardFactor, 1.0);
    }

    /// Edition and origin are those of all limits, a further one has them too; the guard band belongs to two
    /// rules.
    void limitsHaveOneEditionAndOrigin() {
        Edited<LimitsPage> edited(example());
        QVERIFY(fields(edited.page, u"guardFactor"_s).isEmpty()); // simple acceptance
        edited.type(u"limits"_s, u"20"_s);
        const auto setOrigin = [&](const char *origin) {
            edited.model.edit("test", [&](Document &document) {
                editTest(document, 0, [&](Test &test) { test.limits["A"].source = origin; });
            });
        };
        setOrigin("contract");
        edited.type(u"limits"_s, u"10"_s, 3);
        QCOMPARE(edited.test().limits.size(), std::size_t(2));
        for (const auto &[id, limit] : edited.test().limits)
            QCOMPARE(limit.source, std::string("contract"));
        setOrigin("another");
        int origins = 0;
        for (Field *field : edited.page.findChildren<Field *>())
            origins += field->edit()->accessibleName() == u"Origin"_s;
        QVERIFY(origins > 1); // row by row, as they differ
    }

    void limitsArePastedFromASpreadsheet() {
        Edited<LimitsPage> edited(example());
        edited.type(u"limits"_s, u"20"_s);
        const auto paste = [&](const QString &text, int row) {
            QGuiApplication::clipboard()->setText(text);
            QWidget *edit = fields(edited.page, u"limits"_s)[row]->edit();
            edit->setFocus();
            QTest::keySequence(edit, QKeySequence::Paste);
        };
        paste(u"A\t15\nR↑\t0,006 mm\n"_s, 3);
        QCOMPARE(edited.test().limits.at("A").value, std::optional(0.015));
        QCOMPARE(edited.test().limits.at("R+").value, std::optional(0.006));
        paste(u"1\n2\n"_s, 1); // from the row on that has the focus
        QCOMPARE(edited.test().limits.at("A+").value, std::optional(0.001));
        QCOMPARE(edited.test().limits.at("A-").value, std::optional(0.002));
        const Limits before = edited.test().limits;
        paste(u"A\t15\nno limit\n"_s, 0);
        QVERIFY(edited.test().limits == before);
        auto *box = edited.page.findChild<QMessageBox *>();
        QVERIFY(box && box->informativeText().startsWith(u"Line 2"_s)); // a sentence of its own
        QCOMPARE(box->textFormat(), Qt::PlainText);
        delete box;
        // A text of one line is what the field takes.
        paste(u"7"_s, 1);
        QVERIFY(!edited.page.findChild<QMessageBox *>());
    }

    /// The bar says in which unit limits were read; another one pastes anew, and Undo takes back that alone.
    void theBarChangesPastedLimits() {
        Edited<LimitsPage> edited(example());
        const Limits before = edited.test().limits;
        QGuiApplication::clipboard()->setText(u"A\t0.015\nR\t0.008\n"_s);
        button(edited.page, "pasteLimits")->click();
        QCOMPARE(edited.test().limits.at("A").value, std::optional(0.000015));
        auto *unit = edited.page.findChild<QComboBox *>(u"paste.unit"_s);
        QVERIFY(unit && unit->isVisibleTo(&edited.page));
        QCOMPARE(unit->currentData().toString(), u"um"_s);
        unit->setCurrentIndex(unit->findData(u"mm"_s));
        emit unit->activated(unit->currentIndex());
        QCOMPARE(edited.test().limits.at("A").value, std::optional(0.015));
        QCOMPARE(edited.test().limits.at("R").value, std::optional(0.008));
        edited.page.findChild<QToolButton *>(u"pasteUndo"_s)->click();
        QVERIFY(edited.test().limits == before);
        QVERIFY(!edited.page.findChild<QWidget *>(u"pasteBar"_s)->isVisibleTo(&edited.page));
    }

    void circlesHaveTheirOwnLimits() {
        Test test;
        test.edition = "ISO 230-4:2005";
        test.measurement = CircularMeasurement();
        Edited<LimitsPage> edited(documentOf(test));
        QStringList names;
        for (Field *field : fields(edited.page, u"limits"_s))
            names << field->edit()->accessibleName();
        QVERIFY(names.contains(u"Limit of F"_s));
        QVERIFY(names.contains(u"Limit of G(b)"_s));
        QStringList meant; // beside its symbol
        for (const QLabel *label : edited.page.findChildren<QLabel *>())
            meant << label->text();
        QVERIFY(meant.contains(u"Fmax and Fmin in size"_s));
        edited.type(u"limits"_s, u"30"_s, static_cast<int>(names.indexOf(u"Limit of G(b)"_s)));
        QCOMPARE(edited.test().limits.at("G(b)").value, std::optional(0.03));
    }

    void theHeadOfTheReportIsEntered() {
        Edited<IdentificationPage> edited(example());
        for (Field *field : edited.page.findChildren<Field *>()) {
            if (field->edit()->accessibleName() == u"Address"_s) {
                field->edit()->setFocus();
                QTest::keyClicks(field->edit(), u"1 rue de la Paix"_s);
                QTest::keyClick(field->edit(), Qt::Key_Return);
                QTest::keyClicks(field->edit(), u"69000 Lyon"_s);
                break;
            }
        }
        const ReportHead &head = edited.model.document()->report;
        QCOMPARE(head.laboratory.address, std::string("1 rue de la Paix\n69000 Lyon"));
        QCOMPARE(edited.model.undoStack()->count(), 1);
        auto *customer = edited.page.findChild<QCheckBox *>(u"signs.Customer"_s);
        QVERIFY(customer->isChecked());
        customer->click();
        QCOMPARE(edited.model.document()->report.signatures,
                 (std::vector{Signer::operatorSigns, Signer::supplier}));
        edited.type(u"country"_s, u"fr"_s); // files take capitals
        QCOMPARE(edited.model.document()->report.laboratory.country, std::string("FR"));
    }

    void templatesAreKeptAndApplied() {
        QStandardPaths::setTestModeEnabled(true);
        for (const StoredTemplate &stored : storedTemplates())
            removeTemplate(stored);
        Edited<MachinePage> edited(example());
        edited.type(u"name"_s, u"DMU 50"_s);
        auto *templates = edited.page.findChild<TemplateButton *>();
        QVERIFY(templates);
        storeTemplate(templates->current(u"ours"_s));
        storeTemplate(templates->current(u"ours"_s)); // replaced, not doubled
        const auto stored = storedTemplates();
        QCOMPARE(stored.size(), std::size_t(1));
        edited.type(u"name"_s, u"other"_s);
        QVERIFY(templates->apply(stored[0].content));
        QCOMPARE(edited.model.document()->machine.name, std::string("DMU 50"));
        QCOMPARE(fields(edited.page, u"name"_s).at(0)->text(), u"DMU 50"_s);
        edited.model.undoStack()->undo();
        QCOMPARE(edited.model.document()->machine.name, std::string("other"));
        QVERIFY(!templates->apply({"limits", LimitSet()})); // of another page
        removeTemplate(stored[0]);
        QVERIFY(storedTemplates().empty());
        storeTemplate(templates->current(u"a name that goes on "_s.repeated(20)));
        emit templates->menu()->aboutToShow();
        QVERIFY(templates->menu()->sizeHint().width() < 600);
        removeTemplate(storedTemplates()[0]);
    }

    /// One step says yes to what was not declared; what was declared stays.
    void allDeclarationsAtOnce() {
        Test test = example1988("ISO 230-2:2006");
        measurement(test).conditions.common.unloaded = false;
        Edited<ConditionsPage> edited(documentOf(test));
        button(edited.page, "allApply")->click();
        const Conditions &common = edited.conditions().common;
        QCOMPARE(common.unloaded, std::optional(false));
        for (const auto &declared : {common.complete, common.levelled, common.shielded, common.stabilised})
            QCOMPARE(declared, std::optional(true));
        QVERIFY(!common.temperatureControlled); // no requirement is met by it
        QCOMPARE(edited.model.undoStack()->count(), 1);
        edited.model.undoStack()->undo();
        QVERIFY(*edited.model.document()->tests[0] == test);
    }

    void whatIsUsualIsFoldedWhenCompleteAndComesIntoView() {
        Test test = example1988("ISO 230-2:2006");
        test.remarks = "after the collision\nof May";
        Edited<ConditionsPage> edited(documentOf(test));
        QVERIFY(section(edited.page, "Further statements")->isFolded());
        QVERIFY(
            section(edited.page, "Further statements")->summary().endsWith(u"after the collision of May"_s));
        SectionHead *usual = section(edited.page, "Usual in practice");
        QVERIFY(!usual->isFolded()); // something is missing
        Field *load = fields(edited.page, u"load"_s).at(0);
        edited.model.edit("state", [](Document &document) {
            editTest(document, 0, [](Test &changed) {
                conditionsOf(changed)->load = "none";
                conditionsOf(changed)->soak = "12 h";
                conditionsOf(changed)->toolOffset = conditionsOf(changed)->workpieceOffset = {0., 0., 0.};
                measurement(changed).conditions.airPressure = 1013;
                measurement(changed).conditions.airHumidity = 50;
            });
        });
        load->edit()->setFocus();
        QVERIFY(!usual->isFolded() && load->isVisible()); // never under the hands
        showAgain(edited.page);
        QVERIFY(!section(edited.page, "Usual in practice")->isFolded()); // the keyboard is in it
        edited.enter(u"dwell"_s);
        showAgain(edited.page);
        usual = section(edited.page, "Usual in practice"); // groups may have changed places
        load = fields(edited.page, u"load"_s).at(0);
        QVERIFY(usual->isFolded() && !load->isVisible());
        QVERIFY2(usual->summary().contains(u"1\u202f013\u00a0hPa"_s), qPrintable(usual->summary()));
    }

    void aFoldedSectionSaysWhatIsMissing() {
        Edited<ConditionsPage> edited(example());
        SectionHead *usual = section(edited.page, "Usual in practice");
        usual->click();
        QVERIFY(usual->isFolded());
        QVERIFY2(usual->summary().endsWith(u"usual"_s), qPrintable(usual->summary()));
    }

    /// A group of which the edition misses something stands above the others, until the page is left.
    void whatIsMissingComesFirst() {
        Test test = example1988("ISO 230-2:2006");
        test.date = "2026-03-12";
        Edited<ConditionsPage> edited(documentOf(test));
        const auto top = [&](const QString &key) {
            return fields(edited.page, key).at(0)->mapTo(&edited.page, QPoint()).y();
        };
        QVERIFY(fields(edited.page, u"dwell"_s).at(0)->isRequired());
        QVERIFY(top(u"dwell"_s) < top(u"purpose"_s));
        edited.model.edit("state", [](Document &document) {
            editTest(document, 0, [](Test &changed) {
                auto &conditions = measurement(changed).conditions;
                measurement(changed).cycle = Cycle::standard;
                conditions.dwell = 3;
                conditions.feed = 1000;
                conditions.approachDistance = 5;
                conditions.common.compensation = "none";
                setAgreedPoint(changed, "feed", AgreementState::agreed, "");
                for (AgreedPoint &point : changed.agreedPoints)
                    point.value = 1000;
            });
        });
        QVERIFY(!fields(edited.page, u"dwell"_s).at(0)->isRequired());
        QVERIFY(top(u"dwell"_s) < top(u"purpose"_s)); // nothing moves while the user works
        showAgain(edited.page);
        QCoreApplication::processEvents();
        QVERIFY(top(u"dwell"_s) > top(u"purpose"_s));
    }

    void onlyWhatTheAxisHasIsAsked() {
        Edited<ConditionsPage> edited(example());
        for (const char *key : {"faces", "zone", "continuousDevice", "scaleElement"})
            QVERIFY2(fields(edited.page, QLatin1StringView(key)).empty() ||
                         !fields(edited.page, QLatin1StringView(key)).at(0)->isVisible() ||
                         key == std::string_view("scaleElement"),
                     key);
        choose(edited.enter(u"targetChoice"_s), 2); // faces of the polygon
        QCOMPARE(fields(edited.page, u"faces"_s).size(), 1);
    }

    void theUserFoldsAndUnfolds() {
        Test test = example1988("ISO 230-2:2006");
        test.remarks = "a remark";
        Edited<ConditionsPage> edited(documentOf(test));
        SectionHead *remarks = section(edited.page, "Further statements");
        auto *text = edited.page.findChildren<QPlainTextEdit *>().constLast();
        QVERIFY(remarks->isFolded() && !text->isVisible());
        remarks->setFocus();
        for (const Qt::Key key : {Qt::Key_Space, Qt::Key_Return, Qt::Key_Right}) {
            QTest::keyClick(remarks, key);
            QVERIFY(!remarks->isFolded() && text->isVisible());
            QTest::keyClick(remarks, key == Qt::Key_Right ? Qt::Key_Left : key);
            QVERIFY(remarks->isFolded() && !text->isVisible());
        }
        QTest::mouseClick(remarks, Qt::LeftButton);
        QVERIFY(!remarks->isFolded());
        QTest::keyClick(remarks, Qt::Key_Tab); // into what was folded away
        QVERIFY(edited.page.focusWidget()->isVisible() && edited.page.focusWidget() != remarks);
        edited.enter(u"dwell"_s);
        showAgain(edited.page);
        QVERIFY(!remarks->isFolded()); // as the user left it
        remarks->click();
        QVERIFY(remarks->isFolded());
        QVERIFY(edited.page.focusLabel("Remarks on the test", {})); // as an undone step does
        QVERIFY(!remarks->isFolded());
        QCOMPARE(edited.page.focusWidget(), text);
    }

    void foldingIsHeard() {
        Test test = example1988("ISO 230-2:2006");
        test.remarks = "a remark";
        Edited<ConditionsPage> edited(documentOf(test));
        SectionHead *remarks = section(edited.page, "Further statements");
        QAccessibleInterface *access = QAccessible::queryAccessibleInterface(remarks);
        QVERIFY(access);
        QCOMPARE(access->role(), QAccessible::Button);
        QCOMPARE(access->text(QAccessible::Name), u"Further statements"_s);
        QCOMPARE(access->text(QAccessible::Description), remarks->summary());
        QVERIFY(access->state().expandable && access->state().collapsed && !access->state().expanded);
        access->actionInterface()->doAction(QAccessibleActionInterface::pressAction());
        QVERIFY(!remarks->isFolded());
        QVERIFY(access->state().expandable && !access->state().collapsed && access->state().expanded);
        QCOMPARE(access->text(QAccessible::Description), u"Fold the section away"_s);
    }

    void whatIsRefusedIsNotFoldedAway() {
        Test test = example1988("ISO 230-2:2006");
        test.declaredAccordance.by = "the laboratory";
        Edited<ConditionsPage> edited(documentOf(test));
        SectionHead *declarations = section(edited.page, "Further statements");
        QVERIFY(declarations->isFolded());
        declarations->click();
        Field *date = nullptr;
        for (Field *field : edited.page.findChildren<Field *>()) {
            if (field->edit()->accessibleName() == u"Declared on"_s)
                date = field;
        }
        QVERIFY(date);
        date->edit()->setFocus();
        QTest::keyClicks(date->edit(), u"soon"_s);
        QVERIFY(date->isRefused());
        edited.enter(u"dwell"_s);
        declarations->click(); // folded, then unfolded: no wish of the user is left
        edited.page.focusLabel("Declared on", {});
        edited.enter(u"dwell"_s);
        showAgain(edited.page);
        QVERIFY(!declarations->isFolded() && date->isVisible());
    }

    /// The same twelve columns in every row.
    void fieldsStandInTwelveColumns() {
        for (const int width : {560, 752}) {
            Edited<ConditionsPage> edited(example());
            edited.page.resize(width, 900);
            QCoreApplication::processEvents();
            auto *page = edited.page.findChild<QWidget *>(u"conditionsFields"_s);
            QVERIFY(page);
            const bool beside = page->width() - 32 - 96 >= 520; // the names of the groups
            const double left = 16 + (beside ? 96 : 0);
            const double column = (page->width() - 16 - left + 8) / 12.0;
            for (const Field *field : edited.page.findChildren<Field *>()) {
                if (!field->isVisible())
                    continue;
                for (const double edge : {field->mapTo(page, QPoint()).x() - left,
                                          field->mapTo(page, QPoint(field->width(), 0)).x() - left + 8}) {
                    const double off = std::abs(edge / column - std::round(edge / column)) * column;
                    QVERIFY2(
                        off <= 2,
                        qPrintable(
                            u"%1: %2 of %3"_s.arg(field->edit()->accessibleName()).arg(edge).arg(column)));
                }
            }
        }
    }

    /// The word "no" belongs to the statement.
    void answersOfNoAreWhole() {
        for (const Language::Id language : {Language::Id::french, Language::Id::english}) {
            setWindowLanguage(language);
            Test test = example1988("ISO 230-2:2006");
            Conditions &common = measurement(test).conditions.common;
            common.complete = common.stabilised = common.shielded = common.unloaded = common.levelled = false;
            Edited<ConditionsPage> edited(documentOf(test));
            edited.page.setLanguage(windowLanguage());
            edited.page.resize(684, 900); // at 1366 pixels
            QCoreApplication::processEvents();
            for (const Field *field : edited.page.findChildren<Field *>()) {
                const auto *box = qobject_cast<const QCheckBox *>(field->edit());
                if (!box || !box->isVisible())
                    continue;
                QStyleOptionButton option;
                option.initFrom(box);
                const QRect place = box->style()->subElementRect(QStyle::SE_CheckBoxContents, &option, box);
                QVERIFY2(box->fontMetrics().horizontalAdvance(box->text()) <= place.width(),
                         qPrintable(box->text()));
            }
        }
        setWindowLanguage(Language::Id::english);
    }

    void aYearIsNotNegative() {
        Edited<MachinePage> edited(example());
        for (Field *field : edited.page.findChildren<Field *>()) {
            if (field->edit()->accessibleName() != u"Year of construction"_s)
                continue;
            field->edit()->setFocus();
            QTest::keyClicks(field->edit(), u"-5"_s);
            QVERIFY(field->isRefused());
        }
        QVERIFY(!edited.model.document()->machine.year);
    }

    void declarationsAreTemplates() {
        Test test = example1988("ISO 230-2:2006");
        measurement(test).conditions.common.soak = "12 h";
        measurement(test).conditions.common.complete = true;
        Edited<ConditionsPage> edited(documentOf(test));
        auto *templates = edited.page.findChild<TemplateButton *>();
        QVERIFY(templates);
        const Template content = templates->current(u"hall 2"_s);
        edited.type(u"soak"_s, u"1 h"_s);
        edited.type(u"dwell"_s, u"3"_s);
        QVERIFY(templates->apply(content));
        QCOMPARE(edited.conditions().common.soak, std::string("12 h"));
        QCOMPARE(edited.conditions().common.complete, std::optional(true));
        QCOMPARE(edited.conditions().dwell, std::optional(3.0)); // is of this test
        QVERIFY(!templates->apply({"limits", LimitSet()}));
    }

    void withoutTests() {
        Selection selection;
        DocumentModel model;
        ConditionsPage conditions(model, selection);
        AgreedPointsPage points(model, selection);
        LimitsPage limits(model, selection);
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
