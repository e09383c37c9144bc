// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/comparison/comparisonpage.h"
#include "ui/figures/figurecard.h"
#include "ui/rowtable.h"
#include "ui/window/shownwindow.h"

#include <QComboBox>
#include <QLineEdit>
#include <QScopeGuard>
#include <QTest>
#include <QToolButton>

using namespace palmer;
using namespace palmer::ui;

namespace {

/// The example whose second test states the first, with the tab of the second in view.
struct Compared {
    ShownWindow shown{examplePath("x-axis-as-found-as-left")};
    ComparisonPage *page = nullptr;
    RowTable *parameters = nullptr;

    Compared() {
        shown.window->workplace().showTest(1);
        shown.window->workplace().showPage(Page::comparison);
        page = shown.find<ComparisonPage>("comparisonPage");
        parameters = shown.find<RowTable>("comparedParameters");
    }
    [[nodiscard]] QString cell(int row, int column) const {
        const QTableWidgetItem *item = parameters->item(row, column);
        return item ? item->text() : QString();
    }
    [[nodiscard]] const std::optional<ComparedWith> &stated() const {
        return shown.window->model().document()->tests[1]->comparedWith;
    }
};

} // namespace

class ComparisonPageTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { prepareApplication(); }
    void init() { setWindowLanguage(Language::Id::english); }

    void showsWhatTheTestStates() {
        const Compared c;
        QTRY_COMPARE(c.cell(0, 0), QString("A"));
        QCOMPARE(c.cell(0, 7), QString("changed, better"));
        QVERIFY(c.shown.find<QLabel>("comparisonWord")->text() == "Changed, better");
        QVERIFY(c.shown.find<LineView>("differenceFigure")->figure().has_value());
        QCOMPARE(c.shown.find<RowTable>("comparedConditions")->rowCount(), 5);
        c.shown.window->workplace().showPage(Page::readings);
        QVERIFY(!c.shown.find<QWidget>("comparisonSide")->isVisible());
        QVERIFY(c.shown.find<QWidget>("figureCanvas")->isVisible());
    }

    /// The least range of the figure is 0.2 µm, whatever the unit: in mm a difference is no flat line.
    void theFigureFillsItsRangeInEveryUnit() {
        const Compared c;
        const auto &figure = c.shown.find<LineView>("differenceFigure")->figure();
        const auto span = [&] {
            const auto *curves = figure ? std::get_if<CurveFigure>(&*figure) : nullptr;
            return curves ? curves->y.to - curves->y.from : 0.;
        };
        QTRY_VERIFY(span() > 0);
        const double inMicrometres = span();
        setWindowUnits({LengthDisplay::millimetres, AngleDisplay::arcSeconds});
        const auto restored = qScopeGuard([] { setWindowUnits({}); });
        QTRY_VERIFY(span() < inMicrometres / 2);
        QVERIFY2(span() < 1.5 * inMicrometres / 1000, qPrintable(QString::number(span())));
    }

    /// In full as a hint: there is no room for the terms of the standard.
    void namesAreShort() {
        const Compared c;
        QTRY_COMPARE(c.cell(0, 1), QString("accuracy"));
        QCOMPARE(c.cell(1, 1), QString("unidirectional"));
        QCOMPARE(c.parameters->item(0, 1)->toolTip(),
                 QString("bi-directional accuracy of positioning of an axis"));
    }

    void theOtherDirectionHasTheOtherSign() {
        const Compared c;
        QTRY_COMPARE(c.cell(0, 0), QString("A"));
        const QString forwards = c.cell(0, 4);
        QVERIFY(forwards.startsWith(QChar(u'\u2212')));
        c.shown.find<QToolButton>("beforeLessAfter")->click();
        QTRY_COMPARE(c.cell(0, 4), forwards.mid(1));
        QCOMPARE(c.cell(0, 7), QString("changed, worse"));
    }

    void whatIsChosenIsStatedAndUndone() {
        const Compared c;
        QTRY_COMPARE(c.cell(0, 0), QString("A"));
        auto *tolerance = c.shown.find<QLineEdit>("changeTolerance");
        tolerance->setText("20");
        emit tolerance->editingFinished();
        QVERIFY(c.stated() && c.stated()->tolerance == std::optional(0.02));
        QTRY_COMPARE(c.cell(0, 7), QString("unchanged within t"));
        auto *other = c.shown.find<QComboBox>("comparedWith");
        other->setCurrentIndex(0);
        emit other->activated(0);
        QVERIFY(!c.stated());
        QTRY_VERIFY(!c.parameters->isVisible());
        c.shown.window->model().undoStack()->undo();
        QVERIFY(c.stated().has_value());
    }

    /// It stays beside its reason, and what was stated before is kept.
    void aToleranceThatIsNoneIsRefused() {
        const Compared c;
        QTRY_COMPARE(c.cell(0, 0), QString("A"));
        auto *tolerance = c.shown.find<QLineEdit>("changeTolerance");
        const auto *reason = c.shown.find<QLabel>("toleranceRefusal");
        tolerance->setText("2.5");
        emit tolerance->editingFinished();
        for (const QString text : {"abc", "0", "-3"}) {
            tolerance->clear();
            QTest::keyClicks(tolerance, text);
            emit tolerance->editingFinished();
            QCOMPARE(tolerance->text(), text);
            QVERIFY2(!reason->text().isEmpty(), qPrintable(text));
            QVERIFY(c.stated() && c.stated()->tolerance == std::optional(0.0025));
            QVERIFY(c.shown.window->workplace().refusedTexts().contains(text));
        }
        tolerance->clear();
        emit tolerance->editingFinished();
        QVERIFY(reason->text().isEmpty() && c.stated() && !c.stated()->tolerance);
    }

    /// The picture of the difference makes room for them.
    void namesAndStatementsAreWhole() {
        const Compared c;
        QTRY_COMPARE(c.cell(0, 0), QString("A"));
        const QFontMetrics metrics(c.parameters->font());
        for (const int width : {1024, 1280, 1366}) {
            c.shown.window->resize(width, 768);
            QTest::qWait(20); // layouts
            QVERIFY(c.parameters->columnViewportPosition(7) + c.parameters->columnWidth(7) <=
                    c.parameters->viewport()->width());
            for (int row = 0; row < c.parameters->rowCount() && width > 1024; ++row)
                QVERIFY2(metrics.horizontalAdvance(c.cell(row, 1)) < c.parameters->columnWidth(1),
                         qPrintable(QString("%1 at %2").arg(c.cell(row, 1)).arg(width)));
        }
        QVERIFY(!c.parameters->isColumnHidden(6)); // where there is room
    }

    /// Shown once more, as after a change of the language, it offers what it offered.
    /// In a low window it scrolls and loses no line.
    void theMethodIsWhole() {
        const Compared c;
        QTRY_COMPARE(c.cell(0, 0), QString("A"));
        const auto *method = c.shown.find<QLabel>("differenceMethod");
        for (const int height : {640, 744, 900}) {
            c.shown.window->resize(1280, height);
            QCoreApplication::processEvents();
            QVERIFY(method->isVisible());
            QVERIFY2(
                method->height() >= method->heightForWidth(method->width()),
                qPrintable(
                    QString("%1 of %2").arg(method->height()).arg(method->heightForWidth(method->width()))));
        }
    }

    void shownAgainItOffersTheSame() {
        const Compared c;
        QTRY_COMPARE(c.cell(0, 0), QString("A"));
        c.page->show(c.shown.window->evaluator().current(), 1);
        auto *other = c.shown.find<QComboBox>("comparedWith");
        for (const int row : {0, 1}) {
            other->setCurrentIndex(row);
            emit other->activated(row);
            QCOMPARE(c.stated().has_value(), row == 1);
        }
        QCOMPARE(c.stated()->test, std::string("found"));
    }

    /// What is seen is never the comparison of another test.
    void anotherTestDoesNotShowTheComparisonOfTheLast() {
        const Compared c;
        QTRY_COMPARE(c.cell(0, 0), QString("A"));
        c.page->show(c.shown.window->evaluator().current(), 0); // states none
        QVERIFY(!c.parameters->isVisible());
        c.page->show(c.shown.window->evaluator().current(), 1);
        QVERIFY(!c.parameters->isVisible());
        QVERIFY(c.shown.find<QLabel>("comparisonReason")->text().contains("being compared"));
        QTRY_VERIFY(c.parameters->isVisible());
    }

    void aTestOfAnotherFileIsNotStated() {
        const Compared c;
        QVERIFY(c.page->addFile(examplePath("x-axis-as-found-as-left")));
        QTRY_VERIFY(c.shown.find<QLabel>("comparisonNote")->text().contains("another file"));
        QCOMPARE(c.stated()->test, std::string("found"));
        QVERIFY(!c.stated()->tolerance);
    }
};

QTEST_MAIN(ComparisonPageTest)
#include "comparisonpage.moc"
