// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/readings/readingspage.h"

#include "ui/examples.h"
#include "ui/readings/readingsmodel.h"
#include "ui/readings/targetcard.h"
#include "ui/readings/targetstripview.h"
#include "ui/theme.h"

#include <QAbstractItemModelTester>
#include <QLabel>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <QToolButton>

using namespace palmer;
using namespace palmer::ui;
using namespace palmer::testdata;
using namespace Qt::StringLiterals;

namespace {

QString row(const QAbstractItemModel &model, int row) {
    QStringList cells;
    for (int column = 0; column < model.columnCount(); ++column)
        cells << model.index(row, column).data().toString();
    return cells.join(u' ');
}

} // namespace

/// The table of readings and the card of a target, as widgets.
class ReadingsTest : public QObject {
    Q_OBJECT

private slots:
    void modelIsConsistent() {
        ReadingsModel model;
        QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model.show(evaluatedDocument(example1988("ISO 230-2:1988")), 0);
        model.setGrouping(ReadingGrouping::byDirection);
        model.setUnit(ReadingUnit::positions);
        model.setLanguage(Language(Language::Id::french));
        model.show(evaluatedDocument(Test{}), 0);
        QCOMPARE(model.rowCount(), 0);
        model.show({}, 0);
        QCOMPARE(model.columnCount(), 0);
    }

    void modelShowsReadingsAndStatistics() {
        ReadingsModel model;
        model.show(evaluatedDocument(testdata::exactHand("ISO 230-2:2006")), 0);
        QCOMPARE(model.rowCount(), 5);
        QCOMPARE(row(model, 4), u"5 400 1.0 −8.0 1.0 −8.0 2.0 −6.0 3.0 −4.0 3.0 −4.0 "
                                u"2.00 −6.00 8.00 1.00 2.00 14.00"_s);
        QCOMPARE(model.head(2).group, model.head(3).group);
        QVERIFY(model.head(3).group != model.head(4).group);
        model.setGrouping(ReadingGrouping::byDirection);
        QCOMPARE(row(model, 4).section(u' ', 2, 11), u"1.0 1.0 2.0 3.0 3.0 −8.0 −8.0 −6.0 −4.0 −4.0"_s);
        QCOMPARE(model.head(2).group, model.head(6).group);
    }

    void hoverInTheTableTellsTheWindow() {
        Selection selection;
        DocumentModel model;
        ReadingsPage page(model, selection);
        page.show(evaluatedDocument(example1988("ISO 230-2:1988")), 0);
        page.resize(900, 500);
        page.setVisible(true);
        QVERIFY(QTest::qWaitForWindowExposed(&page));
        auto *view = page.findChild<QTableView *>(u"readings"_s);
        const QModelIndex cell = view->model()->index(1, 3); // run 1 ↓, target 2
        QTest::mouseMove(view->viewport(), view->visualRect(cell).center());
        QTRY_COMPARE(selection.hovered(), (ReadingPlace{1, 1}));
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(view->viewport(), &leave);
        QCOMPARE(selection.hovered(), std::optional<ReadingPlace>());
    }

    void hoverInTheFigureFramesTheCell() {
        Selection selection;
        DocumentModel model;
        ReadingsPage page(model, selection);
        page.show(evaluatedDocument(example1988("ISO 230-2:1988")), 0);
        page.resize(900, 500);
        page.setVisible(true);
        QVERIFY(QTest::qWaitForWindowExposed(&page));
        auto *view = page.findChild<QTableView *>(u"readings"_s);
        const QRect cell = view->visualRect(view->model()->index(1, 3));
        const auto picture = [&] { return view->viewport()->grab(cell).toImage(); };
        const QImage before = picture();
        selection.setHovered(ReadingPlace{1, 1});
        QVERIFY(picture() != before);
        selection.setHovered({});
        QCOMPARE(picture(), before);
    }

    void numbersOfTheStripStandApart() {
        Selection selection;
        TargetStripView view(selection);
        TargetStrip strip;
        strip.lanes.resize(1);
        for (int i = 1; i < 10; ++i)
            strip.axis.ticks.push_back({i / 10.0, u"−0.33698"_s});
        view.setStrip(strip, 0);
        view.resize(300, 140);
        const QImage image = view.grab().toImage();
        const int widest =
            QFontMetrics(themeFont(palmer::ui::TextSize::tiny)).horizontalAdvance(u"−0.33698"_s);
        const auto isEmpty = [&image](int x) {
            for (int y = image.height() - 16; y < image.height(); ++y) {
                if (image.pixel(x, y) != image.pixel(0, image.height() - 1))
                    return false;
            }
            return true;
        };
        int first = 0; // column of a number
        int last = -1;
        for (int x = 0; x < image.width(); ++x) {
            if (isEmpty(x))
                continue;
            if (last < 0 || x - last > 5)
                first = x;
            last = x;
            QVERIFY2(last - first <= widest, qPrintable(QString::number(x)));
        }
        QVERIFY(last > 0);
    }

    /// A strip of 20 000 readings leaves out dots, but shows every place where readings lie.
    void aStripOfManyReadingsShowsWhereTheyAre() {
        Selection selection;
        TargetStripView view(selection);
        view.resize(432, 140); // the axis begins at 24 and is 400 wide
        TargetStrip strip;
        strip.axis.from = 0;
        strip.axis.to = 100;
        strip.lanes.resize(1);
        constexpr std::size_t many = 20'000;
        for (std::size_t k = 0; k < many; ++k)
            strip.lanes[0].readings.push_back({10 + 0.01 * static_cast<double>(k * 7919 % 5000), k, false});
        strip.lanes[0].readings[many / 2].value = 90;
        view.setStrip(strip, 0);
        const QImage image = view.grab().toImage();
        const auto isDrawn = [&image](double value) {
            const int x = 24 + static_cast<int>(4 * value);
            for (int y = 4; y < image.height() - 24; ++y) {
                if (image.pixelColor(x, y) == token(Token::up, QPalette()))
                    return true;
            }
            return false;
        };
        for (int value = 10; value < 60; ++value)
            QVERIFY2(isDrawn(value), qPrintable(QString::number(value)));
        for (int value = 65; value < 100; value += 5)
            QCOMPARE(isDrawn(value), value == 90);
    }

    void currentCellIsTheReadingOfTheWindow() {
        Selection selection;
        DocumentModel model;
        ReadingsPage page(model, selection);
        page.show(evaluatedDocument(example1988("ISO 230-2:1988")), 0);
        auto *view = page.findChild<QTableView *>(u"readings"_s);
        view->setCurrentIndex(view->model()->index(4, 2));
        QCOMPARE(selection.reading(), (ReadingPlace{0, 4}));
        QCOMPARE(selection.target(), std::size_t{4});
        selection.setReading(ReadingPlace{3, 7});
        QCOMPARE(view->currentIndex(), view->model()->index(7, 5)); // run 2 ↓
    }

    void selectionTellsMeanAndRange() {
        Selection selection;
        DocumentModel model;
        ReadingsPage page(model, selection);
        page.show(evaluatedDocument(testdata::exactHand("ISO 230-2:2006")), 0);
        QSignalSpy spy(&page, &ReadingsPage::summaryChanged);
        auto *view = page.findChild<QTableView *>(u"readings"_s);
        view->selectionModel()->select(
            QItemSelection(view->model()->index(1, 2), view->model()->index(1, 11)),
            QItemSelectionModel::ClearAndSelect);
        QVERIFY(!spy.isEmpty());
        QCOMPARE(spy.last().at(0).toString(), u"10 readings: mean 3.50\u00a0µm, range 4.0\u00a0µm"_s);
    }

    void switchesChangeTheDisplayOnly() {
        Selection selection;
        DocumentModel model;
        ReadingsPage page(model, selection);
        const EvaluatedDocument evaluated = evaluatedDocument(example1988("ISO 230-2:1988"));
        const Test before = *evaluated.document->tests[0];
        page.show(evaluated, 0);
        auto *view = page.findChild<QTableView *>(u"readings"_s);
        page.findChild<QToolButton *>(u"showPositions"_s)->click();
        QCOMPARE(view->model()->index(1, 3).data().toString(), u"150.7154"_s);
        page.findChild<QToolButton *>(u"showDeviations"_s)->click();
        page.findChild<QToolButton *>(u"groupByDirection"_s)->click();
        QCOMPARE(view->model()->index(1, 3).data().toString(), u"0.7"_s); // run 2 ↑
        QCOMPARE(*evaluated.document->tests[0], before);
    }

    void numberAndTargetStayWhenScrolled() {
        Selection selection;
        DocumentModel model;
        ReadingsPage page(model, selection);
        page.show(evaluatedDocument(largeTest()), 0);
        page.resize(600, 500);
        page.setVisible(true);
        QVERIFY(QTest::qWaitForWindowExposed(&page));
        auto *view = page.findChild<QTableView *>(u"readings"_s);
        auto *frozen = page.findChild<QTableView *>(u"frozenReadings"_s);
        view->horizontalScrollBar()->setValue(view->horizontalScrollBar()->maximum());
        view->verticalScrollBar()->setValue(1300);
        QCOMPARE(frozen->verticalScrollBar()->value(), view->verticalScrollBar()->value());
        QVERIFY(frozen->isVisible());
        QCOMPARE(frozen->columnViewportPosition(0), 0);
        QVERIFY(frozen->width() >= 104);
        // Moving into a column that lies below the frozen ones brings it out.
        view->setCurrentIndex(view->model()->index(50, 2));
        QVERIFY(view->columnViewportPosition(2) >= frozen->width());
    }

    void cardShowsTheTarget() {
        Selection selection;
        TargetCard card(selection);
        card.show(evaluatedDocument(example1988("ISO 230-2:1988")), 0);
        auto *title = card.findChild<QLabel *>(u"targetTitle"_s);
        QCOMPARE(title->text(), u"Target 1"_s);
        QVERIFY(!card.findChild<QToolButton *>(u"previousTarget"_s)->isEnabled());
        card.findChild<QToolButton *>(u"nextTarget"_s)->click();
        QCOMPARE(selection.target(), std::size_t{1});
        QCOMPARE(title->text(), u"Target 2"_s);
        auto *statistics = card.findChild<QWidget *>(u"targetStatistics"_s);
        const QString content = statistics->accessibleDescription();
        QVERIFY2(content.contains(u"↑ 0.92, ↓ 5.40"_s) && content.contains(u"−4.48"_s), qPrintable(content));
        selection.setTarget(10);
        QVERIFY(!card.findChild<QToolButton *>(u"nextTarget"_s)->isEnabled());
    }

    /// In mm and degrees numbers have many digits: neighbours keep apart.
    void numbersOfTheCardKeepApart() {
        Selection selection;
        TargetCard card(selection);
        card.setLanguage(
            Language(Language::Id::english).withUnits({LengthDisplay::millimetres, AngleDisplay::degrees}));
        card.show(evaluatedDocument(example1988("ISO 230-2:1988")), 0);
        const auto *statistics = card.findChild<QWidget *>(u"targetStatistics"_s);
        QVERIFY(statistics->accessibleDescription().contains(u"0.00"_s));
        constexpr int symbol = 36;
        constexpr int between = 8;
        const int number = statistics->fontMetrics().horizontalAdvance(u"−0.00448"_s);
        QVERIFY(statistics->minimumSizeHint().width() >= symbol + 3 * (number + between));
        QVERIFY(statistics->sizeHint().width() >= statistics->minimumSizeHint().width());
    }

    void cardWithoutTest() {
        Selection selection;
        TargetCard card(selection);
        card.show({}, 0);
        card.show(evaluatedDocument(Test{}), 0);
        QVERIFY(!card.findChild<QToolButton *>(u"nextTarget"_s)->isEnabled());
    }
};

QTEST_MAIN(ReadingsTest)
#include "readings.moc"
