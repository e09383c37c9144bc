// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figures/figureview.h"

#include "figures/testfigures.h"
#include "figures/thinning.h"
#include "ui/examples.h"
#include "ui/figures/figurecanvas.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMimeData>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QUrl>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

using namespace palmer;
using namespace palmer::ui;
using namespace palmer::testdata;
using namespace Qt::StringLiterals;

namespace {

/// False: it goes on to what the widget stands in.
bool wheel(QWidget *widget, int delta) {
    const QPointF at(widget->rect().center());
    QWheelEvent event(at, widget->mapToGlobal(at), {}, {0, delta}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(widget, &event);
    return event.isAccepted();
}

/// 300 targets, 100 runs each way: more than a screen resolves.
Test denseTest() {
    std::vector<double> targets(300);
    std::iota(targets.begin(), targets.end(), 0.0);
    std::vector<std::vector<double>> up;
    std::vector<std::vector<double>> down;
    for (int run = 0; run < 100; ++run) {
        up.emplace_back();
        down.emplace_back();
        for (std::size_t i = 0; i < targets.size(); ++i) {
            up.back().push_back(std::sin(0.1 * double(i)) + 0.01 * ((run * 37) % 100));
            down.back().push_back(2 + std::cos(0.1 * double(i)) + 0.01 * ((run * 53) % 100));
        }
    }
    return positioningTest("ISO 230-2:2006", targets, up, down);
}

double span(const FigureView &view) {
    return view.figure()->x.to - view.figure()->x.from;
}

} // namespace

/// The figure in the window: reading values, zoom, copies.
class FigureViewTest : public QObject {
    Q_OBJECT

private slots:
    void pointerFindsReadings() {
        Selection selection;
        FigureView view(selection);
        view.show(evaluatedDocument(example1988("ISO 230-2:2006")), 0);
        view.resize(560, 380);
        view.setVisible(true);
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        auto *canvas = view.findChild<FigureCanvas *>();
        const ReadingPlace place{1, 1}; // run 1 ↓, target 2
        const auto at = canvas->placeOf(place);
        QVERIFY(at);
        QTest::mouseMove(canvas, at->toPoint());
        QTRY_VERIFY(selection.hovered().has_value());
        QCOMPARE(selection.hovered()->target, place.target);
        // Two readings of 5.4 µm stand at one place: either may be found.
        QVERIFY(selection.hovered()->run == 1 || selection.hovered()->run == 7);
        QTest::mouseMove(canvas, QPoint(2, 2));
        QTRY_COMPARE(selection.hovered(), std::optional<ReadingPlace>());
    }

    /// Runs in no regular order, every reading another: the higher, the higher up; marks drawn or not.
    void everyReadingStandsWhereItsValueIs() {
        Test test = positioningTest("ISO 230-2:2006", {0, 100, 200}, {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}},
                                    {{-1, -2, -3}, {-4, -5, -6}, {-7, -8, -9}});
        auto &runs = std::get<PositioningMeasurement>(test.measurement).runs;
        std::ranges::sort(runs, {}, [](const Run &run) { // ↑ ↑ ↓ ↑ ↓ ↓
            constexpr std::array order{0, 1, 3, 2, 4, 5};
            const double first = std::abs(*run.deviations[0]) * 1e3; // 1, 4 or 7
            const bool up = run.approach == Direction::positive;
            return order[std::size_t(std::lround(first) / 3 + (up ? 0 : 3))];
        });
        Selection selection;
        FigureView view(selection);
        view.show(evaluatedDocument(test), 0);
        view.resize(560, 380);
        for (const bool marks : {true, false}) {
            view.findChild<QToolButton *>(u"readingMarks"_s)->setChecked(marks);
            view.grab(); // lays it out
            auto *canvas = view.findChild<FigureCanvas *>();
            const FigureAxis y = view.figure()->y;
            const double top = canvas->placeOf({0, 0})->y();
            const double value = *runs[0].deviations[0];
            const double other = *runs[5].deviations[2];
            const double slope = (canvas->placeOf({5, 2})->y() - top) / (other - value);
            QVERIFY(slope < 0 && y.to > y.from);
            for (std::size_t run = 0; run < runs.size(); ++run) {
                for (std::size_t target = 0; target < 3; ++target) {
                    const auto at = canvas->placeOf({run, target});
                    QVERIFY(at);
                    const double expected = top + slope * (*runs[run].deviations[target] - value);
                    QVERIFY2(std::abs(at->y() - expected) < 1e-6,
                             qPrintable(u"run %1, target %2"_s.arg(run).arg(target)));
                }
            }
        }
    }

    void hoverInTheTableRingsTheReading() {
        Selection selection;
        FigureView view(selection);
        view.show(evaluatedDocument(example1988("ISO 230-2:2006")), 0);
        view.resize(560, 380);
        view.setVisible(true);
        auto *canvas = view.findChild<FigureCanvas *>();
        const QImage before = canvas->grab().toImage();
        selection.setHovered(ReadingPlace{0, 4});
        const QImage ringed = canvas->grab().toImage();
        QVERIFY(ringed != before);
        const auto at = canvas->placeOf({0, 4});
        QVERIFY(at);
        const QRect around(at->toPoint() - QPoint(8, 8), QSize(16, 16));
        QVERIFY(ringed.copy(around) != before.copy(around));
        selection.setHovered({});
        QCOMPARE(canvas->grab().toImage(), before);
    }

    void anExplanationMarksItsTargets() {
        Selection selection;
        FigureView view(selection);
        view.show(evaluatedDocument(example1988("ISO 230-2:2006")), 0);
        view.resize(560, 380);
        auto *canvas = view.findChild<FigureCanvas *>();
        const QImage before = canvas->grab().toImage();
        selection.setParameter(u"R"_s);
        const QImage marked = canvas->grab().toImage();
        QVERIFY(marked != before);
        const double ratio = canvas->devicePixelRatioF();
        const auto last = canvas->placeOf({0, 10});
        const QRect band((QPointF(last->x(), 30) * ratio).toPoint(), QSize(3, 3));
        QVERIFY(marked.copy(band) != before.copy(band)); // target 11 rules
        const QRect elsewhere(QPoint(canvas->placeOf({0, 1})->toPoint().x() - 4, 30), QSize(2, 2));
        QCOMPARE(marked.copy(elsewhere), before.copy(elsewhere));
    }

    void theWheelZoomsAndNeverScrollsWhatTheFigureStandsIn() {
        Selection selection;
        FigureView view(selection);
        view.show(evaluatedDocument(example1988("ISO 230-2:2006")), 0);
        view.resize(560, 380);
        auto *canvas = view.findChild<FigureCanvas *>();
        const double whole = span(view);
        QVERIFY(!canvas->hasFocus());
        QVERIFY(wheel(canvas, 120));
        QVERIFY(span(view) < whole * 0.9);
        QVERIFY(wheel(canvas, -120));
        QVERIFY(wheel(canvas, -120)); // the whole is shown already
        QCOMPARE(span(view), whole);
        QVERIFY(wheel(canvas, 0));
        QCOMPARE(span(view), whole);
    }

    void buttonsZoom() {
        Selection selection;
        FigureView view(selection);
        view.show(evaluatedDocument(example1988("ISO 230-2:2006")), 0);
        view.resize(560, 380);
        view.setVisible(true);
        const double whole = span(view);
        const double middleOfAll = view.figure()->x.from + view.figure()->x.to;
        const auto click = [&](const QString &name) {
            auto *button = view.findChild<QToolButton *>(name);
            QVERIFY(button->isVisible() && !button->accessibleName().isEmpty());
            QVERIFY(button->toolTip().startsWith(button->accessibleName()));
            button->click();
        };
        click(u"zoomIn"_s);
        const double once = span(view);
        QVERIFY(once < whole);
        // About the middle: as much is gone at either end.
        const auto middle = [&] { return view.figure()->x.from + view.figure()->x.to; };
        QVERIFY(std::abs(middle() - middleOfAll) < 1e-6 * whole);
        click(u"zoomIn"_s);
        QVERIFY(span(view) < once);
        click(u"zoomOut"_s);
        QVERIFY(std::abs(span(view) - once) < 1e-9 * whole);
        click(u"fitFigure"_s);
        QCOMPARE(span(view), whole);
        click(u"zoomOut"_s); // never beyond the whole
        QCOMPARE(span(view), whole);
    }

    void keysZoomAndMove() {
        Selection selection;
        FigureView view(selection);
        view.show(evaluatedDocument(example1988("ISO 230-2:2006")), 0);
        view.resize(560, 380);
        auto *canvas = view.findChild<FigureCanvas *>();
        const double whole = span(view);
        canvas->grab();
        QTest::keyClick(canvas, Qt::Key_Plus);
        const double from = view.figure()->x.from;
        QVERIFY(span(view) < whole);
        QTest::keyClick(canvas, Qt::Key_Right);
        QVERIFY(view.figure()->x.from > from);
        for (int k = 0; k < 20; ++k)
            QTest::keyClick(canvas, Qt::Key_Minus);
        QCOMPARE(span(view), whole); // never beyond the whole
        for (int k = 0; k < 100; ++k)
            QTest::keyClick(canvas, Qt::Key_Plus);
        QVERIFY(span(view) >= whole * 0.9e-3);
        QTest::keyClick(canvas, Qt::Key_0);
        QCOMPARE(span(view), whole);
    }

    void zoomStaysWhileReadingsChange() {
        Selection selection;
        FigureView view(selection);
        Test test = example1988("ISO 230-2:2006");
        view.show(evaluatedDocument(test), 0);
        view.resize(560, 380);
        auto *canvas = view.findChild<FigureCanvas *>();
        canvas->grab();
        QTest::keyClick(canvas, Qt::Key_Plus);
        const double zoomed = span(view);
        measurement(test).runs[0].deviations[3] = 0.0008;
        view.show(evaluatedDocument(test), 0);
        QCOMPARE(span(view), zoomed);
    }

    void aLargeFigureIsMadeBesideTheWindow() {
        Selection selection;
        FigureView view(selection);
        view.resize(560, 380);
        const EvaluatedDocument large = evaluatedDocument(denseTest());
        view.show(large, 0);
        QVERIFY(!view.figure()); // not yet
        QTRY_VERIFY(view.figure());
        const CurveFigure whole =
            deviationFigure(*large.document->tests[0], *large.tests[0], Language(Language::Id::english));
        QCOMPARE(whole.readings.size(), std::size_t{60'000});
        QCOMPARE(*view.figure(), thinned(whole));
        // Zoomed: at once what is drawn already, then all that belongs there.
        auto *canvas = view.findChild<FigureCanvas *>();
        QVERIFY(wheel(canvas, 240));
        const CurveFigure zoomed = *view.figure();
        QVERIFY(span(view) < whole.x.to - whole.x.from);
        const CurveFigure there =
            thinned(withRanges(whole, {zoomed.x.from, zoomed.x.to}, {zoomed.y.from, zoomed.y.to},
                               Language(Language::Id::english)));
        QTRY_COMPARE(*view.figure(), there);
        // The pointer finds every reading, drawn or not.
        view.fit();
        QTRY_VERIFY(view.figure() && span(view) == whole.x.to - whole.x.from);
        view.grab(); // lays it out
        for (const std::size_t target : {std::size_t{0}, std::size_t{150}, std::size_t{299}})
            QVERIFY(canvas->placeOf({17, target}));
    }

    void ofTwoTestsTheLatterIsShown() {
        Selection selection;
        FigureView view(selection);
        view.resize(560, 380);
        view.show(evaluatedDocument(denseTest()), 0);
        view.show(evaluatedDocument(example1988("ISO 230-2:2006")), 0); // before the other is there
        QVERIFY(view.figure());
        QCOMPARE(view.figure()->positions.size(), std::size_t{11});
        QTest::qWait(500);
        QCOMPARE(view.figure()->positions.size(), std::size_t{11});
        selection.setParameter(u"R"_s);
        view.grab();
    }

    void copyHoldsVectorsAndAPicture() {
        Selection selection;
        FigureView view(selection);
        view.show(evaluatedDocument(example1988("ISO 230-2:2006")), 0);
        QSignalSpy said(&view, &FigureView::said);
        view.findChild<QToolButton *>(u"copyFigure"_s)->click();
        QCOMPARE(said.size(), 1);
        QVERIFY(!said[0][0].toString().isEmpty());
        const QMimeData *copied = QGuiApplication::clipboard()->mimeData();
        QVERIFY(copied->data(u"image/svg+xml"_s).contains("<svg"));
        QVERIFY(copied->data(u"application/pdf"_s).startsWith("%PDF"));
        QVERIFY(copied->hasImage());
        QCOMPARE(qvariant_cast<QImage>(copied->imageData()).pixelColor(1, 1), QColor(Qt::white));
    }

    /// For programs as they like, for a folder as a file.
    void isDraggedOut() {
        Selection selection;
        FigureView view(selection);
        QVERIFY(!view.dragged());
        view.show(evaluatedDocument(example1988("ISO 230-2:2006")), 0);
        const std::unique_ptr<QMimeData> dragged(view.dragged());
        QVERIFY(dragged->data(u"image/svg+xml"_s).contains("<svg"));
        QVERIFY(dragged->data(u"application/pdf"_s).startsWith("%PDF"));
        QVERIFY(dragged->hasImage());
        QCOMPARE(dragged->urls().size(), 1);
        QFile file(dragged->urls().constFirst().toLocalFile());
        QVERIFY(file.fileName().endsWith(u".svg"_s) && file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), dragged->data(u"image/svg+xml"_s));
    }

    void savesByTheSuffix() {
        Selection selection;
        FigureView view(selection);
        view.show(evaluatedDocument(example1988("ISO 230-2:2006")), 0);
        QTemporaryDir folder;
        const auto begin = [&](const QString &name) {
            QFile file(folder.filePath(name));
            return file.open(QIODevice::ReadOnly) ? file.read(5) : QByteArray();
        };
        QVERIFY(view.saveTo(folder.filePath(u"a.pdf"_s)) && view.saveTo(folder.filePath(u"a.svg"_s)) &&
                view.saveTo(folder.filePath(u"a.png"_s)));
        QCOMPARE(begin(u"a.pdf"_s), QByteArray("%PDF-"));
        QCOMPARE(begin(u"a.svg"_s), QByteArray("<?xml"));
        QCOMPARE(begin(u"a.png"_s).mid(1, 3), QByteArray("PNG"));
        QVERIFY(!view.saveTo(folder.filePath(u"missing/a.pdf"_s)));
    }

    void ofASingleRunTheCurveIsRead() {
        Selection selection;
        FigureView view(selection);
        view.show(
            evaluatedDocument(positioningTest("ISO 230-2:2006", {0, 100, 200}, {{1, 2, 3}}, {{2, 3, 4}})), 0);
        view.resize(560, 380);
        auto *canvas = view.findChild<FigureCanvas *>();
        view.grab(); // lays it out
        QVERIFY(canvas->placeOf({1, 2}));
    }

    void withoutTestThereIsNoFigure() {
        Selection selection;
        FigureView view(selection);
        view.show({}, 0);
        view.grab();
        QVERIFY(!view.figure());
        for (const QString &name : {u"copyFigure"_s, u"zoomIn"_s, u"zoomOut"_s, u"fitFigure"_s})
            QVERIFY(!view.findChild<QToolButton *>(name)->isEnabled());
        QVERIFY(!view.saveTo(u"x.pdf"_s));
    }

    void buttonsAskForMoreRoom() {
        Selection selection;
        FigureView view(selection);
        view.show(evaluatedDocument(example1988("ISO 230-2:2006")), 0);
        QSignalSpy detach(&view, &FigureView::detachWanted);
        QSignalSpy maximise(&view, &FigureView::maximiseWanted);
        view.findChild<QToolButton *>(u"detachFigure"_s)->click();
        view.findChild<QToolButton *>(u"maximiseFigure"_s)->click();
        QCOMPARE(detach.size(), 1);
        QCOMPARE(maximise.size(), 1);
    }
};

QTEST_MAIN(FigureViewTest)
#include "figureview.moc"
