// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/circles/circlespage.h"

#include "ui/circles.h"
#include "ui/circles/arccurvesview.h"
#include "ui/circles/arcdialog.h"
#include "ui/model/documentmodel.h"
#include "ui/theme.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QTableView>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <QUndoStack>

using namespace palmer;
using namespace palmer::ui;
using namespace palmer::testdata;
using namespace Qt::StringLiterals;

namespace {

/// The page with a document behind it: what is edited is evaluated and shown again.
struct Shown {
    explicit Shown(const Test &test = decidedPair(), Language::Id language = Language::Id::english)
        : page(model, selection) {
        Document document;
        document.tests.push_back(std::make_shared<const Test>(test));
        page.resize(620, 640);
        page.setLanguage(Language(language));
        QObject::connect(&model, &DocumentModel::changed, &page, [this] { present(); });
        model.setDocument(std::move(document), {});
        page.setVisible(true);
        page.grab(); // lays it out
    }
    void present() {
        evaluated = evaluate(model.document());
        page.show(evaluated, 0);
    }

    [[nodiscard]] const CircularMeasurement &circles() const {
        return std::get<CircularMeasurement>(model.document()->tests[0]->measurement);
    }
    template <class Widget>
    [[nodiscard]] Widget *find(const char *name) const {
        auto *found = page.findChild<Widget *>(QLatin1StringView(name));
        if (!found)
            qFatal("no %s", name);
        return found;
    }
    [[nodiscard]] QString cell(const char *table, int row, int column) const {
        return find<QTableView>(table)->model()->index(row, column).data().toString();
    }
    [[nodiscard]] QString head(const char *table, int column) const {
        return find<QTableView>(table)
            ->model()
            ->headerData(column, Qt::Horizontal, Qt::DisplayRole)
            .toString();
    }
    void choose(const char *name, int index) const {
        auto *box = find<QComboBox>(name);
        box->setCurrentIndex(index);
        emit box->activated(index);
    }
    void type(const char *name, const QString &text) const {
        auto *box = find<QLineEdit>(name);
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, text);
        QTest::keyClick(box, Qt::Key_Return);
    }

    DocumentModel model;
    Selection selection;
    EvaluatedDocument evaluated;
    CirclesPage page;
};

} // namespace

/// Readings of circular tests in the window.
class CirclesPageTest : public QObject {
    Q_OBJECT

private slots:
    void whatAnArcLeavesOutIsStated() {
        Shown shown;
        shown.type("cutOff", u"run-in"_s);
        QCOMPARE(shown.circles().arcs[0].cutOff, std::string("run-in"));
        QVERIFY(shown.circles().arcs[1].cutOff.empty());
        QCOMPARE(shown.model.undoStack()->count(), 1);
        shown.find<QTableView>("arcs")->setCurrentIndex(shown.find<QTableView>("arcs")->model()->index(1, 0));
        QVERIFY(shown.find<QLineEdit>("cutOff")->text().isEmpty());
        shown.type("cutOff", u"overshoot"_s);
        QCOMPARE(shown.circles().arcs[0].cutOff, std::string("run-in"));
        QCOMPARE(shown.circles().arcs[1].cutOff, std::string("overshoot"));
    }

    void arcsSayWhatTheyAre() {
        const Shown shown;
        QCOMPARE(shown.find<QTableView>("arcs")->model()->rowCount(), 2);
        QCOMPARE(shown.cell("arcs", 0, ArcsModel::sense), u"anticlockwise, XY"_s);
        QCOMPARE(shown.cell("arcs", 1, ArcsModel::sense), u"clockwise, YX"_s);
        QCOMPARE(shown.cell("arcs", 0, ArcsModel::points), u"1\u202f800"_s);
        QCOMPARE(shown.cell("arcs", 0, ArcsModel::from), u"0.1°"_s);
        QCOMPARE(shown.cell("arcs", 0, ArcsModel::to), u"359.9°"_s);
        QCOMPARE(shown.cell("arcs", 1, ArcsModel::from), u"359.9°"_s); // as it was run through
        QCOMPARE(shown.cell("arcs", 0, ArcsModel::cut), u"0.0°"_s);
        const auto *circle = std::get<CircularResults>(shown.evaluated.tests[0]->results)
                                 .circle(CircleOf::counterclockwise, ReferenceCircle::leastSquares);
        QCOMPARE(shown.cell("arcs", 0, ArcsModel::radius),
                 QString::number(1000 * (circle->radius - 150), 'f', 2));
    }

    void repetitionsAreNamed() {
        Test test = decidedPair();
        circular(test).arcs.push_back(circular(test).arcs[1]);
        const Shown shown(test);
        QCOMPARE(shown.cell("arcs", 1, ArcsModel::use), u"evaluated"_s);
        QCOMPARE(shown.cell("arcs", 2, ArcsModel::use), u"repetition"_s);
        QCOMPARE(shown.cell("arcs", 2, ArcsModel::radius), u"–"_s);
    }

    void pointsInThreeUnits() {
        const Shown shown;
        const Arc &arc = shown.circles().arcs[0];
        auto *points = shown.find<QTableView>("points");
        QCOMPARE(points->model()->rowCount(), 1800);
        QCOMPARE(points->model()->columnCount(), 5);
        QCOMPARE(shown.cell("points", 9, 0), u"10"_s);
        QCOMPARE(shown.cell("points", 9, 1).toDouble(), arc.angles[9]);
        const auto number = [&](int column) {
            return shown.cell("points", 9, column).replace(QChar(0x2212), u'-').toDouble();
        };
        QVERIFY(std::abs(number(2) - 1000 * arc.radialDeviations[9]) <= 0.0005); // three decimals
        shown.find<QToolButton>("showLengths")->click();
        QVERIFY(std::abs(number(2) - (150 + arc.radialDeviations[9])) <= 0.000005);
        shown.find<QToolButton>("showCoordinates")->click();
        QCOMPARE(points->model()->columnCount(), 7);
        const Point unit = direction(arc.angles[9]);
        QVERIFY(std::abs(number(2) - (150 + arc.radialDeviations[9]) * unit.x) <= 0.000005);
        QVERIFY(std::abs(number(3) - (150 + arc.radialDeviations[9]) * unit.y) <= 0.000005);
        QVERIFY(shown.head("points", 2).startsWith(u"X mm"_s));
    }

    void aShorterArcEndsEarlier() {
        Test test = decidedPair();
        auto &arc = circular(test).arcs[1];
        arc.angles.resize(100);
        arc.radialDeviations.resize(100);
        const Shown shown(test);
        QVERIFY(!shown.cell("points", 99, 4).isEmpty());
        QVERIFY(shown.cell("points", 100, 4).isEmpty());
        QVERIFY(!shown.cell("points", 100, 2).isEmpty());
    }

    void aMillionPointsOpenAtOnce() {
        PointsModel model;
        Document document;
        document.tests.push_back(std::make_shared<const Test>(longPair(1000000)));
        EvaluatedDocument evaluated;
        evaluated.document = std::make_shared<const Document>(std::move(document));
        evaluated.tests.push_back(std::make_shared<const TestEvaluation>());
        model.show(evaluated, 0, Language(Language::Id::french));
        QCOMPARE(model.rowCount(), 1000000);
        QCOMPARE(model.index(999999, 0).data().toString(), u"1\u202f000\u202f000"_s);
        QVERIFY(!model.index(999999, 4).data().toString().isEmpty());
    }

    void rangeByNumberIsOneStep() {
        Shown shown;
        QCOMPARE(shown.find<QLineEdit>("evaluatedFrom")->text(), u"0.1"_s);
        shown.type("evaluatedFrom", u"20"_s);
        QCOMPARE(shown.circles().arcs[0].evaluated, (Interval{20, 359.9}));
        QCOMPARE(shown.cell("arcs", 0, ArcsModel::from), u"20.0°"_s);
        QCOMPARE(shown.cell("arcs", 0, ArcsModel::cut), u"19.9°"_s);
        QCOMPARE(shown.model.undoStack()->count(), 1);
        shown.find<QTableView>("arcs")->selectRow(1); // the fields are those of the current arc
        QCOMPARE(shown.find<QLineEdit>("evaluatedFrom")->text(), u"0.1"_s);
        shown.model.undoStack()->undo();
        QVERIFY(!shown.circles().arcs[0].evaluated);
    }

    void anEmptyRangeIsNotTaken() {
        Shown shown;
        const QRect before = shown.find<QTableView>("points")->geometry();
        shown.type("evaluatedTo", u"-5"_s);
        shown.page.grab(); // lays it out
        QVERIFY(shown.find<QLabel>("circlesReason")->isVisible());
        QCOMPARE(shown.find<QTableView>("points")->geometry(), before); // nothing moves
        QVERIFY(!shown.circles().arcs[0].evaluated);
        QCOMPARE(shown.find<QLineEdit>("evaluatedTo")->text(), u"-5"_s); // stays, and it is said why
        QVERIFY(shown.find<QLabel>("circlesReason")
                    ->text()
                    .startsWith(u"⚠ Not above the lower end of the range"_s));
        QCOMPARE(shown.page.refusedTexts(), QStringList{u"-5"_s});
        shown.type("evaluatedTo", u"300"_s);
        QCOMPARE(shown.circles().arcs[0].evaluated, (Interval{0.1, 300}));
        QVERIFY(!shown.find<QLabel>("circlesReason")->isVisible());
        shown.model.undoStack()->undo();
        QCOMPARE(shown.model.undoStack()->index(), 0);
    }

    /// On the way to "400" there were ranges of an arc for which none was stated.
    void aRefusedRangeStatesNothing() {
        Shown shown;
        shown.page.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&shown.page));
        shown.type("evaluatedFrom", u"400"_s);
        QCOMPARE(shown.page.refusedTexts(), QStringList{u"400"_s});
        QVERIFY(!shown.circles().arcs[0].evaluated);
    }

    void aRangeMovesBeyondItself() {
        Shown shown;
        shown.type("evaluatedTo", u"90"_s);
        shown.type("evaluatedFrom", u"100"_s); // not below 90: waits for the other end
        QCOMPARE(shown.find<QLineEdit>("evaluatedFrom")->text(), u"100"_s);
        QVERIFY(!shown.page.refusedTexts().isEmpty());
        shown.type("evaluatedTo", u"180"_s);
        QCOMPARE(shown.circles().arcs[0].evaluated, (Interval{100, 180}));
        QVERIFY(shown.page.refusedTexts().isEmpty());
    }

    void handlesSetTheRange() {
        Shown shown;
        auto *curves = shown.find<ArcCurvesView>("arcCurves");
        const int y = curves->height() / 2;
        const auto at = [&](double angle) { return QPointF(curves->xOf(angle), y); };
        const auto send = [&](QEvent::Type type, QPointF place) {
            const bool move = type == QEvent::MouseMove;
            QMouseEvent event(type, place, curves->mapToGlobal(place), move ? Qt::NoButton : Qt::LeftButton,
                              type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton,
                              Qt::NoModifier);
            QCoreApplication::sendEvent(curves, &event);
        };
        send(QEvent::MouseButtonPress, at(0.1));
        send(QEvent::MouseMove, at(30));
        QVERIFY(!shown.circles().arcs[0].evaluated); // nothing until it is let go
        send(QEvent::MouseMove, at(45));
        send(QEvent::MouseButtonRelease, at(45));
        QVERIFY(shown.circles().arcs[0].evaluated.has_value());
        QVERIFY(std::abs(shown.circles().arcs[0].evaluated->from - 45) < 1); // a pixel is 0.8°
        QCOMPARE(shown.model.undoStack()->count(), 1);
        shown.find<QPushButton>("wholeArc")->click();
        QVERIFY(!shown.circles().arcs[0].evaluated);
        QVERIFY(!shown.find<QPushButton>("wholeArc")->isEnabled());
        // a press beside the handles moves nothing
        send(QEvent::MouseButtonPress, at(180));
        send(QEvent::MouseMove, at(200));
        send(QEvent::MouseButtonRelease, at(200));
        QVERIFY(!shown.circles().arcs[0].evaluated);
    }

    /// What is left out is dimmed, and the handles reach up: neither runs through the title.
    void theTitleOfTheCurveIsAboveIt() {
        Shown shown;
        auto *curves = shown.find<ArcCurvesView>("arcCurves");
        const auto title = [curves] {
            return curves
                ->grab(QRect(0, 0, curves->width(), QFontMetrics(themeFont(TextSize::tiny)).height() + 3))
                .toImage();
        };
        const QImage before = title();
        emit curves->rangeWanted(0, Interval{120, 350});
        QVERIFY(shown.circles().arcs[0].evaluated.has_value());
        QCOMPARE(title(), before);
    }

    void senseAndOrderCanBeChanged() {
        Shown shown;
        shown.find<QPushButton>("reverseSense")->click();
        QCOMPARE(shown.circles().arcs[0].sense, Sense::clockwise);
        QCOMPARE(shown.cell("arcs", 1, ArcsModel::use), u"repetition"_s); // the second of its sense now
        shown.model.undoStack()->undo();
        QCOMPARE(shown.circles().arcs[0].sense, Sense::counterclockwise);
        QVERIFY(!shown.find<QToolButton>("moveArcUp")->isEnabled());
        shown.find<QToolButton>("moveArcDown")->click();
        QCOMPARE(shown.circles().arcs[0].sense, Sense::clockwise);
        QCOMPARE(shown.find<QTableView>("arcs")->currentIndex().row(), 1); // the arc stays the current one
        QVERIFY(!shown.find<QToolButton>("moveArcDown")->isEnabled());
    }

    void parametersCanBeChanged() {
        Shown shown;
        shown.choose("plane", 1);
        QCOMPARE(shown.circles().plane.first + shown.circles().plane.second, std::string("YZ"));
        QCOMPARE(shown.cell("arcs", 0, ArcsModel::sense), u"anticlockwise, YZ"_s);
        shown.type("nominalRadius", u"149.9995"_s);
        QCOMPARE(shown.circles().nominalRadius, 149.9995);
        QCOMPARE(shown.find<QLineEdit>("contouringFeed")->text(), u"1\u202f000"_s);
        shown.type("contouringFeed", u"500"_s);
        QCOMPARE(shown.circles().feed, std::optional(500.0));
        shown.type("contouringFeed", u"0"_s);
        QCOMPARE(shown.page.refusedTexts(), QStringList{u"0"_s});
        auto *feed = shown.find<QLineEdit>("contouringFeed");
        feed->selectAll();
        QTest::keyClick(feed, Qt::Key_Backspace);
        QVERIFY(!shown.circles().feed);
        QCOMPARE(feed->placeholderText(), u"–"_s);
        shown.choose("signalSource", 1);
        QCOMPARE(shown.circles().source, SignalSource::feedback);
        shown.choose("referenceCircle", 1);
        QCOMPARE(shown.circles().referenceCircle, ReferenceCircle::leastSquares);
        shown.choose("centring", 1);
        QCOMPARE(shown.circles().centring, Centring::instrument);
        shown.choose("angleReference", 1);
        for (const Arc &arc : shown.circles().arcs)
            QCOMPARE(arc.angleReference, AngleReference::commanded);
        while (shown.model.undoStack()->canUndo())
            shown.model.undoStack()->undo();
        QCOMPARE(shown.circles(), std::get<CircularMeasurement>(decidedPair().measurement));
    }

    void frenchNumbersAreReadAndWritten() {
        Shown shown(decidedPair(), Language::Id::french);
        shown.type("nominalRadius", u"149,5"_s);
        QCOMPARE(shown.circles().nominalRadius, 149.5);
        QCOMPARE(shown.find<QLineEdit>("nominalRadius")->text(), u"149,5"_s);
        QCOMPARE(shown.cell("arcs", 0, ArcsModel::from), u"0,1°"_s);
    }

    void aPlaneOfOtherAxesIsOffered() {
        Test test = decidedPair();
        circular(test).plane = {"U", "V"};
        const Shown shown(test);
        QCOMPARE(shown.find<QComboBox>("plane")->currentText(), u"U → V"_s);
    }

    void pointsFollowTheFigure() {
        Shown shown;
        shown.selection.setReading(ReadingPlace{1, 1234});
        auto *points = shown.find<QTableView>("points");
        QCOMPARE(points->currentIndex().row(), 1234);
        QCOMPARE(points->currentIndex().column(), 4);
        points->setCurrentIndex(points->model()->index(5, 2));
        QCOMPARE(shown.selection.reading(), std::optional(ReadingPlace{0, 5}));
    }

    void theCurveTellsThePointUnderThePointer() {
        Shown shown;
        auto *curves = shown.find<ArcCurvesView>("arcCurves");
        bool found = false;
        for (int y = 0; y < curves->height() && !found; ++y) {
            QTest::mouseMove(curves, QPoint(int(curves->xOf(130)), y));
            QCoreApplication::processEvents();
            found = shown.selection.hovered().has_value();
        }
        QVERIFY(found);
        const auto place = *shown.selection.hovered();
        QVERIFY(std::abs(shown.circles().arcs[place.run].angles[place.target] - 130) < 10);
    }

    void arcsArePastedAsTables_data() {
        QTest::addColumn<char>("mark");
        QTest::addColumn<int>("language");
        QTest::newRow("point, English") << '.' << int(Language::Id::english);
        QTest::newRow("comma, French") << ',' << int(Language::Id::french);
    }

    void arcsArePastedAsTables() {
        QFETCH(char, mark);
        QFETCH(int, language);
        Test test = circularTest({});
        Shown shown(test, static_cast<Language::Id>(language));
        QVERIFY(shown.find<QLabel>("noArcs")->isVisible());
        const Document before = *shown.model.document();
        QString text = "angle °\tdeviation µm\n";
        for (int i = 0; i <= 72; ++i)
            text +=
                QString("%1\t%2\n").arg(5 * i).arg(QString::number(0.1 * (i % 7), 'f', 1).replace('.', mark));
        QGuiApplication::clipboard()->setText(text);
        bool asked = false;
        QTimer::singleShot(0, &shown.page, [&] {
            auto *dialog = qobject_cast<ArcDialog *>(QApplication::activeModalWidget());
            QVERIFY(dialog);
            QCOMPARE(dialog->findChild<QPlainTextEdit *>("arcTable")->toPlainText(), text.trimmed() + '\n');
            QCOMPARE(dialog->arcs().size(), std::size_t{1});
            QVERIFY(dialog->findChild<QPushButton *>("addArcs")->text().contains("73"));
            // The other way round, by the user's word.
            dialog->findChild<QComboBox *>("arcSense")->setCurrentIndex(2);
            QCOMPARE(dialog->arcs().front().sense, Sense::clockwise);
            dialog->findChild<QComboBox *>("arcSense")->setCurrentIndex(0);
            asked = true;
            QTest::keyClick(dialog, Qt::Key_Return);
        });
        shown.find<QAction>("pasteArc")->trigger();
        QVERIFY(asked);
        QCOMPARE(shown.circles().arcs.size(), std::size_t{1});
        QCOMPARE(shown.circles().arcs[0].angles.at(18), 90.0);
        QCOMPARE(shown.circles().arcs[0].radialDeviations.at(3), 0.0003);
        QVERIFY(!shown.find<QLabel>("noArcs")->isVisible());
        QCOMPARE(shown.find<QTableView>("points")->model()->rowCount(), 73);
        QCOMPARE(shown.model.undoStack()->count(), 1); // one paste, one step
        shown.model.undoStack()->undo();
        QVERIFY(*shown.model.document() == before);
    }

    /// Angle and deviation without a heading: nothing comes in before the guesses are confirmed.
    void whatIsGuessedOfAnArcIsConfirmedFirst() {
        CircularMeasurement circle;
        circle.nominalRadius = 150;
        QString text;
        for (int angle = 0; angle <= 360; angle += 5)
            text += QString("%1\t%2\n")
                        .arg(angle)
                        .arg(QString::number(
                                 3 * std::cos(angle * 0.0174533) + 1.5 * std::cos(angle * 0.0349066), 'f', 2)
                                 .replace('.', ','));
        ArcDialog dialog(circle, Language(Language::Id::english), text);
        dialog.show();
        auto *add = dialog.findChild<QPushButton *>("addArcs");
        const auto confirm = [&](const char *id) {
            QPushButton *found = nullptr;
            for (auto *button : dialog.findChildren<QPushButton *>(QString("confirm.") + id))
                found = button->isVisibleTo(&dialog) ? button : found;
            return found;
        };
        const auto settle = [] { QTest::qWait(10); };
        settle();
        QVERIFY(!add->isEnabled());
        QVERIFY(dialog.findChild<QLabel *>("arcProblem")->text().contains("to answer"));
        QVERIFY(dialog.findChild<QLabel *>("arcPaths")
                    ->text()
                    .startsWith("read as angle and radial deviation, in µm"));
        QVERIFY(std::abs(dialog.arcs().at(0).radialDeviations.at(0) - 0.0045) < 1e-12);
        // Read as coordinates, as the user says: deviations of metres are asked about.
        auto *content = dialog.findChild<QComboBox *>("arcContent");
        content->setCurrentIndex(content->findData("xy"));
        settle();
        QVERIFY(confirm("large"));
        QVERIFY(!add->isEnabled());
        content->setCurrentIndex(0);
        settle();
        QVERIFY(!confirm("large"));
        QVERIFY(confirm("layout") && confirm("unit"));
        confirm("layout")->click();
        settle();
        QCOMPARE(content->currentData().toString(), QString("angleDeviation"));
        QVERIFY(!add->isEnabled());
        dialog.findChild<QPushButton *>("confirmAll")->click();
        settle();
        QStringList open;
        for (const auto *row : dialog.findChildren<QWidget *>(QRegularExpression("^question\\.")))
            open << (row->isVisibleTo(&dialog) ? row->objectName() : QString());
        open.removeAll(QString());
        QVERIFY2(add->isEnabled(),
                 qPrintable(open.join(' ') + dialog.findChild<QLabel *>("arcProblem")->text()));
        QCOMPARE(dialog.findChild<QComboBox *>("arcUnit")->currentText(), QString("µm"));
        // Points without a number are left out only where that is said.
        dialog.findChild<QPlainTextEdit *>("arcTable")->setPlainText(text + "365\tn/a\n370\t-\n");
        dialog.findChild<QPushButton *>("confirmAll")->click();
        settle();
        QVERIFY(!add->isEnabled());
        auto *leave = dialog.findChild<QPushButton *>("answer.unread.leave");
        QVERIFY(leave);
        leave->click();
        settle();
        QVERIFY(add->isEnabled());
        // Deviations alone: their unit is a guess, too.
        ArcDialog alone(circle, Language(Language::Id::english), "1.5\n2.5\n3.5\n");
        QVERIFY(!alone.findChild<QPushButton *>("addArcs")->isEnabled());
        alone.findChild<QComboBox *>("arcUnit")->setCurrentIndex(1);
        QVERIFY(!alone.findChild<QPushButton *>("addArcs")->isEnabled()); // deviations of 3.5 mm
        alone.findChild<QPushButton *>("confirm.large")->click();
        QVERIFY(!alone.findChild<QPushButton *>("addArcs")->isEnabled()); // nothing says the sense
        alone.findChild<QComboBox *>("arcSense")->setCurrentIndex(2);
        QVERIFY(alone.findChild<QPushButton *>("addArcs")->isEnabled());
        QCOMPARE(alone.arcs().at(0).angles, (std::vector<double>{0, -180, -360}));
        alone.findChild<QComboBox *>("arcUnit")->setCurrentIndex(2);
        QVERIFY(alone.findChild<QPushButton *>("addArcs")->isEnabled());
    }

    void whatIsNoTableOfPointsCannotBeAdded() {
        CircularMeasurement circle;
        circle.nominalRadius = 100;
        ArcDialog dialog(circle, Language(Language::Id::english), "Dear colleague,\nthe circle is round.\n");
        QVERIFY(!dialog.findChild<QPushButton *>("addArcs")->isEnabled());
        QVERIFY(!dialog.findChild<QLabel *>("arcProblem")->text().isEmpty());
        QVERIFY(dialog.arcs().empty());
        QVERIFY(!ArcDialog::looksLikePoints("Dear colleague,\nthe circle is round.\n"));
        QVERIFY(ArcDialog::looksLikePoints("angle\tdr\n0\t1,5\n1\t−1,4\n2\t1e-3\n"));
        // Deviations alone: start and extent are asked for then, and only then.
        dialog.findChild<QPlainTextEdit *>("arcTable")->setPlainText("1.5\n2.5\n3.5\n");
        QVERIFY(dialog.findChild<QLineEdit *>("arcStart")->isEnabled());
        dialog.findChild<QLineEdit *>("arcStart")->setText("90");
        dialog.findChild<QLineEdit *>("arcExtent")->setText("180");
        QCOMPARE(dialog.arcs().at(0).angles, (std::vector<double>{90, 180, 270}));
        dialog.findChild<QLineEdit *>("arcExtent")->setText("none");
        QVERIFY(dialog.arcs().empty());
        QVERIFY(!dialog.findChild<QPushButton *>("addArcs")->isEnabled());
    }

    void pointsAreCorrectedInTheirCells() {
        Shown shown;
        const Document before = *shown.model.document();
        QAbstractItemModel &points = *shown.find<QTableView>("points")->model();
        QVERIFY(points.setData(points.index(2, 2), u"-2,5"_s, Qt::EditRole));
        QCOMPARE(shown.circles().arcs[0].radialDeviations[2], -0.0025);
        QVERIFY(points.setData(points.index(2, 1), u"0.25"_s, Qt::EditRole));
        QCOMPARE(shown.circles().arcs[0].angles[2], 0.25);
        points.setData(points.index(3, 2), u"4..5"_s, Qt::EditRole);
        points.setData(points.index(3, 2), QString(), Qt::EditRole);
        QCOMPARE(shown.model.undoStack()->count(), 2); // what is no number changes nothing
        // The same text as is shown is no change; a length is a distance from the centre.
        QVERIFY(!points.setData(points.index(5, 2), points.index(5, 2).data(Qt::EditRole), Qt::EditRole));
        shown.find<QToolButton>("showLengths")->click();
        QVERIFY(points.setData(points.index(4, 4), u"150.0031"_s, Qt::EditRole));
        QCOMPARE(shown.circles().arcs[1].radialDeviations[4], 0.0031);
        shown.find<QToolButton>("showCoordinates")->click();
        QVERIFY(!(points.flags(points.index(4, 2)) & Qt::ItemIsEditable));
        while (shown.model.undoStack()->canUndo())
            shown.model.undoStack()->undo();
        QVERIFY(*shown.model.document() == before);
    }

    void anArcIsDeletedAndComesBack() {
        Shown shown;
        const Document before = *shown.model.document();
        shown.find<QTableView>("arcs")->setCurrentIndex(shown.find<QTableView>("arcs")->model()->index(1, 0));
        const Sense kept = shown.circles().arcs[0].sense;
        shown.find<QToolButton>("deleteArcButton")->click();
        QCOMPARE(shown.circles().arcs.size(), std::size_t{1});
        QCOMPARE(shown.circles().arcs[0].sense, kept);
        shown.find<QToolButton>("deleteArcButton")->click();
        QVERIFY(shown.circles().arcs.empty());
        QVERIFY(!shown.find<QToolButton>("deleteArcButton")->isEnabled());
        while (shown.model.undoStack()->canUndo())
            shown.model.undoStack()->undo();
        QVERIFY(*shown.model.document() == before);
    }

    void withoutArcsItIsStillThere() {
        const Shown shown(circularTest({}));
        QCOMPARE(shown.find<QTableView>("arcs")->model()->rowCount(), 0);
        QVERIFY(!shown.find<QPushButton>("reverseSense")->isEnabled());
        QVERIFY(!shown.find<QLineEdit>("evaluatedFrom")->isEnabled());
        QVERIFY(!shown.find<QComboBox>("angleReference")->isEnabled());
        QCOMPARE(shown.find<QComboBox>("angleReference")->placeholderText(), u"–"_s); // no arc, no angle
        const Shown empty(circularTest({Arc()}));
        QCOMPARE(empty.cell("arcs", 0, ArcsModel::points), u"0"_s);
    }
};

QTEST_MAIN(CirclesPageTest)
#include "circlespage.moc"
