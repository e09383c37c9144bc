// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/diagnosis/diagnosispage.h"

#include "core/madecircles.h"
#include "document/edits.h"
#include "ui/diagnosis/feedsview.h"
#include "ui/figures/linechart.h"
#include "ui/rowtable.h"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

using namespace palmer;
using namespace palmer::ui;
using namespace palmer::testdata;

namespace {

/// The page with a file behind it.
struct Shown {
    explicit Shown(const std::vector<CircularSynthesis> &asked,
                   Language::Id language = Language::Id::english) {
        QObject::connect(&page, &DiagnosisPage::pathsWanted, &page,
                         [this](const SyntheticPaths &wanted) { paths = wanted; });
        page.resize(620, 640);
        page.setLanguage(Language(language));
        evaluated = evaluate(madeCircles(asked));
        page.show(evaluated, 0);
    }
    /// Brings it into view and waits for its diagnosis.
    void open() {
        page.QWidget::show();
        page.activateWindow();
        finish();
    }
    void finish() const { QTRY_VERIFY(!page.isBusy()); }

    template <class Widget>
    [[nodiscard]] Widget *find(const char *name) const {
        auto *found = page.findChild<Widget *>(QLatin1StringView(name));
        if (!found)
            qFatal("no %s", name);
        return found;
    }
    [[nodiscard]] RowTable &table() const { return *find<RowTable>("diagnosisTable"); }
    [[nodiscard]] QString cell(int row, int column) const { return table().item(row, column)->text(); }
    [[nodiscard]] int rowOf(const QString &name) const {
        for (int row = 0; row < table().rowCount(); ++row) {
            if (cell(row, 1) == name)
                return row;
        }
        return -1;
    }
    [[nodiscard]] QCheckBox *box(int row) const {
        return table().cellWidget(row, 0)->findChild<QCheckBox *>();
    }
    [[nodiscard]] LineChart &chart() const { return *find<LineChart>("diagnosisChart"); }

    DiagnosisPage page;
    EvaluatedDocument evaluated;
    SyntheticPaths paths;
};

} // namespace

/// What a circle says about the machine, in the window.
class DiagnosisPageTest : public QObject {
    Q_OBJECT

private slots:
    void computesNothingOutOfView() {
        Shown shown({mixedCircle()});
        QVERIFY(!shown.page.isBusy());
        shown.open();
        QVERIFY(shown.table().rowCount() > 0);
    }

    void ranksSources() {
        Shown shown({mixedCircle()});
        shown.open();
        QCOMPARE(shown.cell(0, 1), QString("Scale mismatch X–Y"));
        QVERIFY(std::abs(shown.cell(0, 2).toDouble() - 60) < 0.5);
        QCOMPARE(shown.cell(0, 4), QString("µm/m"));
        QCOMPARE(shown.cell(0, 6), QString("9.0"));
        QCOMPARE(shown.table().item(0, 5)->data(RowTable::barRole).toDouble(), 1.0);
        QCOMPARE(shown.find<QLabel>("diagnosisSummary")->text().left(19), QString("12 of 12 parameters"));
        // The first is in view: what it is and what to look at.
        QVERIFY(shown.find<QLabel>("sourceTitle")->text().startsWith("Scale mismatch X–Y: "));
        QVERIFY(shown.find<QLabel>("sourceText")->text().startsWith("X travels farther than Y"));
        shown.table().setCurrentCell(shown.rowOf("Backlash X"), 1);
        QVERIFY(shown.find<QLabel>("sourceText")->text().startsWith("X loses motion at each reversal."));
    }

    /// In words that are not cut off, also where there are feeds to choose.
    void isHeadedAsInterpretation() {
        Shown shown({mixedCircle()});
        shown.open();
        const auto *nature = shown.find<QLabel>("diagnosisNature");
        QVERIFY(nature->isVisible());
        QCOMPARE(nature->text(), QString("Interpretation, not a result of ISO 230-4"));
        QVERIFY(nature->width() >= nature->sizeHint().width());
    }

    /// As wide as the page of a window of 1 280 and of 1 000 pixels: nothing is cut off at the right.
    void nothingIsWiderThanThePage() {
        for (const Language::Id language : {Language::Id::english, Language::Id::french}) {
            Shown shown({mixedCircle()}, language);
            shown.open();
            for (const int width : {582, 470}) {
                shown.page.resize(width, 640);
                QCoreApplication::sendPostedEvents();
                QCoreApplication::processEvents();
                const auto *area = shown.page.findChild<QScrollArea *>();
                QVERIFY2(area->widget()->width() <= area->viewport()->width(),
                         qPrintable(QStringLiteral("%1 of %2")
                                        .arg(area->widget()->minimumSizeHint().width())
                                        .arg(width)));
            }
        }
    }

    void readsFrench() {
        Shown shown({mixedCircle()}, Language::Id::french);
        shown.open();
        QCOMPARE(shown.cell(0, 1), QString("Différence d’échelle X–Y"));
        QVERIFY(shown.cell(0, 2).contains(','));
        QCOMPARE(shown.cell(0, 6), QString("9,0"));
    }

    void tracesWhatIsTicked() {
        Shown shown({mixedCircle()});
        shown.open();
        const QStringList first = shown.page.tracedNames();
        QVERIFY(first.contains("Scale mismatch X–Y"));
        QVERIFY(shown.paths.paths);
        QVERIFY(shown.paths.of == shown.evaluated.tests[0]);
        const std::vector<Points> before = *shown.paths.paths;
        for (int row = 0; row < shown.table().rowCount(); ++row)
            shown.box(row)->setChecked(false);
        shown.finish();
        QVERIFY(!shown.paths.paths);
        QVERIFY(shown.page.tracedNames().isEmpty());
        shown.box(shown.rowOf("Backlash X"))->click();
        shown.finish();
        QVERIFY(shown.paths.paths);
        QVERIFY(*shown.paths.paths != before);
        QCOMPARE(shown.page.tracedNames(), QStringList("Backlash X"));
        // A step of 4 µm where X reverses, none elsewhere.
        const Points &path = shown.paths.paths->front();
        double largest = 0;
        for (std::size_t i = 1; i < path.size(); ++i)
            largest = std::max(largest, std::abs(std::hypot(path.x[i], path.y[i]) -
                                                 std::hypot(path.x[i - 1], path.y[i - 1])));
        QVERIFY(std::abs(largest - 0.004) < 2e-4);
    }

    /// Before any source; of commanded angles the start can be corrected.
    void aTurnedPathIsNamedFirst_data() {
        QTest::addColumn<bool>("commanded");
        QTest::newRow("commanded") << true;
        QTest::newRow("polar") << false;
    }
    void aTurnedPathIsNamedFirst() {
        QFETCH(bool, commanded);
        Shown shown({mixedCircle()});
        shown.open();
        QVERIFY(!shown.find<QLabel>("diagnosisWarnings")->isVisible());
        QVERIFY(!shown.find<QPushButton>("correctStartAngle")->isVisible());
        Document document = *shown.evaluated.document;
        editMeasurement<CircularMeasurement>(document, 0, [&](CircularMeasurement &circle) {
            turnAngles(circle, 2);
            for (Arc &arc : circle.arcs)
                arc.angleReference = commanded ? AngleReference::commanded : AngleReference::polar;
        });
        shown.evaluated = evaluate(std::make_shared<const Document>(document));
        shown.page.show(shown.evaluated, 0);
        shown.finish();
        const auto *warnings = shown.find<QLabel>("diagnosisWarnings");
        QVERIFY(warnings->isVisible() && warnings->y() < shown.table().y());
        QVERIFY2(warnings->text().contains("off the axes"), qPrintable(warnings->text()));
        auto *correct = shown.find<QPushButton>("correctStartAngle");
        QCOMPARE(correct->isVisible(), commanded);
        QSignalSpy corrected(&shown.page, &DiagnosisPage::startAngleCorrected);
        correct->click();
        QCOMPARE(corrected.size(), 1);
        QVERIFY(std::abs(corrected[0][0].toDouble() - 2) < 0.5); // readings are 1° apart
    }

    void whatFitsNoNoiseHasNoInterval() {
        CircularSynthesis asked = mixedCircle();
        asked.vibration = {2e-3, 1};
        Shown shown({asked});
        shown.open();
        QVERIFY(shown.find<QLabel>("diagnosisWarnings")->text().contains("a wave of "));
        for (int row = 0; row < shown.table().rowCount(); ++row)
            QCOMPARE(shown.cell(row, 3), QString("–"));
        QVERIFY(!shown.find<QLabel>("sourceTitle")->text().contains("±"));
    }

    void theSpaceBarTicks() {
        Shown shown({mixedCircle()});
        shown.open();
        const int row = shown.rowOf("Squareness X–Y");
        shown.table().setCurrentCell(row, 1);
        const bool before = shown.box(row)->isChecked();
        QTest::keyClick(&shown.table(), Qt::Key_Space);
        QCOMPARE(shown.box(row)->isChecked(), !before);
        QCOMPARE(shown.page.tracedNames().contains("Squareness X–Y"), !before);
    }

    void nothingIsTracedOutOfView() {
        Shown shown({mixedCircle()});
        shown.open();
        QVERIFY(shown.paths.paths);
        shown.page.hide();
        QVERIFY(!shown.paths.paths);
        shown.page.QWidget::show();
        shown.finish();
        QVERIFY(shown.paths.paths);
    }

    void theSwitchOfTraces() {
        Shown shown({mixedCircle()});
        shown.open();
        shown.find<QToolButton>("traceSources")->click();
        shown.finish();
        QVERIFY(!shown.paths.paths);
        shown.find<QToolButton>("traceSources")->click();
        shown.finish();
        QVERIFY(shown.paths.paths);
    }

    void whatIsNotToldIsGreyWithItsReason() {
        CircularSynthesis asked = mixedCircle();
        asked.senses = {Sense::clockwise};
        Shown shown({asked});
        shown.open();
        int notTold = 0;
        for (int row = 0; row < shown.table().rowCount(); ++row) {
            const QString reason = shown.table().item(row, 1)->toolTip();
            if (!reason.startsWith("These arcs do not tell it from: "))
                continue;
            ++notTold;
            QVERIFY(!shown.box(row)->isEnabled());
            QCOMPARE(shown.cell(row, 2), QString("–"));
            QCOMPARE(shown.box(row)->toolTip(), reason);
        }
        QVERIFY(notTold >= 2);
        QVERIFY(shown.find<QLabel>("diagnosisRemarks")->text().contains("One sense only"));
    }

    void ticksStayWhenTheTestIsEvaluatedAnew() {
        Shown shown({mixedCircle()});
        shown.open();
        for (int row = 0; row < shown.table().rowCount(); ++row)
            shown.box(row)->setChecked(row == shown.rowOf("Backlash X"));
        shown.finish();
        CircularSynthesis asked = mixedCircle();
        asked.noise.seed = 9;
        shown.evaluated = evaluate(madeCircles({asked}));
        shown.page.show(shown.evaluated, 0);
        shown.finish();
        QCOMPARE(shown.page.tracedNames(), QStringList("Backlash X"));
        QVERIFY(shown.paths.of == shown.evaluated.tests[0]);
    }

    void restAndSpectrum() {
        CircularSynthesis asked = mixedCircle();
        asked.vibration = {1e-3, 100 * asked.feed / 60 / (2 * std::acos(-1.0) * asked.radius)};
        Shown shown({asked});
        shown.open();
        QCOMPARE(shown.chart().figure().title, QString("Rest"));
        shown.find<QToolButton>("showSpectrum")->click();
        QCOMPARE(shown.chart().figure().title, QString("Spectrum of the rest"));
        QVERIFY(shown.find<QLabel>("chartNote")->text().startsWith("one wave a turn is 0.0177"));
        shown.chart().grab(); // lays it out
        const FigureLine &line = shown.chart().figure().lines[0];
        const auto highest =
            std::ranges::max_element(line.points, {}, [](const QPointF &p) { return p.y(); });
        const QRectF plot = shown.chart().chart()->plotArea();
        const QRectF range = shown.chart().range();
        const QPointF at(plot.left() + (highest->x() - range.left()) / range.width() * plot.width(),
                         plot.bottom() - (highest->y() - range.top()) / range.height() * plot.height());
        QVERIFY2(shown.chart().readOutAt(at).startsWith("n = 100.0  1.77"),
                 qPrintable(shown.chart().readOutAt(at)));
    }

    void severalFeedsHaveAView() {
        Shown shown(threeFeeds());
        shown.open();
        QVERIFY(!shown.find<QToolButton>("diagnosisOfFeeds")->isHidden());
        QCOMPARE(shown.rowOf("Common lag X–Y"), -1);
        shown.find<QToolButton>("diagnosisOfFeeds")->click();
        const int lag = shown.rowOf("Common lag X–Y");
        QVERIFY(lag >= 0);
        QVERIFY(std::abs(shown.cell(lag, 2).toDouble() - 20) < 0.5); // ms
        QVERIFY(!shown.find<FeedsView>("feedsView")->isHidden());
        QCOMPARE(shown.find<FeedsView>("feedsView")->figure().legend.size(), std::size_t(3));
        shown.table().setCurrentCell(shown.rowOf("Servo mismatch X–Y"), 1);
        QCOMPARE(shown.chart().figure().title, QString("Servo mismatch X–Y"));
        QCOMPARE(shown.chart().figure().lines[0].points.size(), std::size_t(3));
        shown.table().setCurrentCell(lag, 1); // shows in the radius of each
        QCOMPARE(shown.chart().figure().title, QString("Radius, mean scale"));
    }

    void theOverlayOfFeedsIsLookedInto() {
        Shown shown(threeFeeds());
        shown.open();
        shown.find<QToolButton>("diagnosisOfFeeds")->click();
        auto *view = shown.find<FeedsView>("feedsView");
        view->resize(400, 330);
        view->grab(); // draws it
        const CircleFigure whole = view->figure();
        QVERIFY(view->view() == CircleView{});
        const QPointF at(300, 100);
        const auto wheel = [&](int steps) {
            QWheelEvent event(at, view->mapToGlobal(at), {}, {0, 120 * steps}, Qt::NoButton, Qt::NoModifier,
                              Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(view, &event);
            return event.isAccepted(); // the page never scrolls below it
        };
        QVERIFY(wheel(3));
        QVERIFY2(std::abs(view->view().zoom - std::pow(1.25, 3)) < 1e-9,
                 qPrintable(QString::number(view->view().zoom)));
        QVERIFY(view->view().x != 0 && view->view().y != 0); // about the pointer
        const CircleFigure zoomed = view->figure();
        QVERIFY(!(zoomed == whole)); // other rings and another scale
        QCOMPARE(zoomed.legend.size(), std::size_t(3));
        const CircleView before = view->view();
        QTest::mousePress(view, Qt::LeftButton, {}, {200, 150});
        QMouseEvent move(QEvent::MouseMove, QPointF(190, 150), view->mapToGlobal(QPointF(190, 150)),
                         Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(view, &move);
        QTest::mouseRelease(view, Qt::LeftButton, {}, {190, 150});
        QVERIFY(view->view().x > before.x); // dragged to the left: what is right of it comes into view
        QCOMPARE(view->view().y, before.y);
        QTest::keyClick(view, Qt::Key_0);
        QVERIFY(view->view() == CircleView{});
        QTest::keyClick(view, Qt::Key_Plus);
        QVERIFY(view->view().zoom > 1);
        QTest::mouseDClick(view, Qt::LeftButton, {}, {100, 100});
        QVERIFY(view->view() == CircleView{});
        QVERIFY(wheel(-5)); // no farther than the whole
        QVERIFY(view->view() == CircleView{});
    }

    void oneFeedHasNoSuchView() {
        Shown shown({mixedCircle()});
        shown.open();
        QVERIFY(shown.find<QToolButton>("diagnosisOfFeeds")->isHidden());
    }

    void tooFewPointsAreSaid() {
        CircularSynthesis asked = mixedCircle();
        asked.points = 8;
        Shown shown({asked});
        shown.open();
        QCOMPARE(shown.find<QLabel>("diagnosisEmpty")->text(),
                 QString("The evaluated points are too few for a diagnosis."));
        QVERIFY(shown.find<QLabel>("diagnosisEmpty")->isVisible());
        QVERIFY(!shown.table().isVisible());
        QVERIFY(!shown.paths.paths);
    }

    void theChartZooms() {
        Shown shown({mixedCircle()});
        shown.open();
        LineChart &chart = shown.chart();
        chart.grab();
        const QRectF whole = chart.range();
        QCOMPARE(whole.width(), 360.0);
        chart.setFocus();
        QTest::keyClick(&chart, Qt::Key_Plus);
        QVERIFY(chart.range().width() < whole.width());
        QVERIFY(whole.contains(chart.range()));
        QTest::keyClick(&chart, Qt::Key_0);
        QCOMPARE(chart.range(), whole);
        const QRectF plot = chart.chart()->plotArea();
        const auto at = [&](double x, double y) {
            return (plot.topLeft() + QPointF(plot.width() * x, plot.height() * y)).toPoint();
        };
        QTest::mousePress(chart.viewport(), Qt::LeftButton, {}, at(0.25, 0.25));
        QTest::mouseMove(chart.viewport(), at(0.4, 0.5));
        QMouseEvent move(QEvent::MouseMove, at(0.5, 0.75), chart.viewport()->mapToGlobal(at(0.5, 0.75)),
                         Qt::LeftButton, Qt::LeftButton, {});
        QApplication::sendEvent(chart.viewport(), &move);
        QTest::mouseRelease(chart.viewport(), Qt::LeftButton, {}, at(0.5, 0.75));
        QVERIFY(std::abs(chart.range().left() - 90) < 2); // a pixel
        QVERIFY(std::abs(chart.range().right() - 180) < 2);
        QTest::mouseDClick(chart.viewport(), Qt::LeftButton, {}, at(0.5, 0.5));
        QCOMPARE(chart.range(), whole);
    }
};

QTEST_MAIN(DiagnosisPageTest)
#include "diagnosispage.moc"
