// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figures/circlecanvas.h"

#include "print/figures/drawkinds.h"
#include "print/figures/metrics.h"
#include "report/explanations/explanation.h"
#include "ui/circles.h"
#include "ui/figures/circlefigureview.h"
#include "ui/figures/figureview.h"

#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QMimeData>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

using namespace palmer;
using namespace palmer::ui;
using namespace palmer::testdata;
using namespace Qt::StringLiterals;

namespace {

void wheel(QWidget *widget, QPointF at) {
    QWheelEvent event(at, widget->mapToGlobal(at), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(widget, &event);
}

/// A figure view with a circular test.
struct Shown {
    explicit Shown(const Test &test = decidedPair())
        : view(selection) {
        view.show(evaluatedCircles(test), 0);
        view.resize(520, 420);
        view.setVisible(true);
        view.grab(); // lays it out
        circles = view.findChild<CircleFigureView *>();
        canvas = circles->canvas();
    }

    Selection selection;
    FigureView view;
    CircleFigureView *circles;
    CircleCanvas *canvas;
};

} // namespace

/// The circle figure in the window: reading points, zoom, what is shown.
class CircleCanvasTest : public QObject {
    Q_OBJECT

private slots:
    void pointerFindsPoints() {
        Shown shown;
        const ReadingPlace place{0, 321};
        const auto at = shown.canvas->placeOf(place);
        QVERIFY(at);
        QTest::mouseMove(shown.canvas, at->toPoint());
        QTRY_VERIFY(shown.selection.hovered().has_value());
        QCOMPARE(shown.selection.hovered()->run, std::size_t{0});
        // the pointer stands on whole pixels: a neighbour of 0.2° may be nearer
        QVERIFY(std::abs(double(shown.selection.hovered()->target) - 321) <= 3);
        QTest::mouseMove(shown.canvas, QPoint(3, 3));
        QTRY_COMPARE(shown.selection.hovered(), std::optional<ReadingPlace>());
    }

    void readOutSaysAngleDeviationAndTime() {
        Shown shown;
        const QString text = shown.canvas->readOut({0, 100});
        const Arc arc = std::get<CircularMeasurement>(decidedPair().measurement).arcs[0];
        // about the centre of G(b), 18 µm off: the angle differs from the one measured by some 0.01°
        const QRegularExpressionMatch angle = QRegularExpression(u"^XY  (\\d+\\.\\d\\d)°"_s).match(text);
        QVERIFY2(angle.hasMatch(), qPrintable(text));
        QVERIFY(std::abs(angle.captured(1).toDouble() - arc.angles[100]) < 0.02);
        QVERIFY2(text.contains(u"µm"_s), qPrintable(text));
        QVERIFY2(text.endsWith(u"3.14\u00a0s"_s), qPrintable(text)); // 100 · 31.4 ms
        QVERIFY(shown.canvas->readOut({7, 0}).isEmpty());
        Test untimed = decidedPair();
        circular(untimed).arcs[0].sampleInterval.reset();
        Shown other(untimed);
        QVERIFY(!other.canvas->readOut({0, 100}).contains(u" s"_s));
    }

    void hoverRingsThePoint() {
        Shown shown;
        const QImage before = shown.canvas->grab().toImage();
        shown.selection.setHovered(ReadingPlace{1, 700});
        const QImage ringed = shown.canvas->grab().toImage();
        const auto at = shown.canvas->placeOf(ReadingPlace{1, 700});
        QVERIFY(at);
        const QRect around(at->toPoint() - QPoint(8, 8), QSize(16, 16));
        QVERIFY(ringed.copy(around) != before.copy(around));
        shown.selection.setHovered({});
        QCOMPARE(shown.canvas->grab().toImage(), before);
    }

    void manyPointsAreMadeBesideTheWindow() {
        Shown shown;
        const QString before = shown.canvas->readOut({0, 100});
        QVERIFY(!before.isEmpty());
        Test many = longPair(120'000); // each way
        many.title = "many";
        const EvaluatedDocument evaluated = evaluatedCircles(many);
        CircleCanvasContent content;
        shown.canvas->show(evaluated, 0, content, Language(Language::Id::english));
        QVERIFY(shown.canvas->isMaking());
        QCOMPARE(shown.canvas->readOut({0, 100}), before); // until then that of before
        content.options.contacts = true;                   // asked for meanwhile
        shown.canvas->show(evaluated, 0, content, Language(Language::Id::english));
        QTRY_VERIFY(!shown.canvas->isMaking());
        QVERIFY(shown.canvas->readOut({0, 100}) != before);
        QVERIFY(!shown.canvas->paperFigure()->contacts.empty());
        shown.canvas->show(evaluated, 0, content, Language(Language::Id::french)); // the same paths
        QVERIFY(!shown.canvas->isMaking());
        shown.canvas->clear();
        shown.canvas->show(evaluated, 0, content, Language(Language::Id::english));
        QVERIFY(shown.canvas->isMaking());
        shown.canvas->clear(); // nothing of it is heard any more
        QTest::qWait(100);
        QVERIFY(!shown.canvas->paperFigure());
    }

    void theSentenceOfManyPointsFollows() {
        Shown shown;
        const QString before = shown.canvas->accessibleDescription();
        QVERIFY(!before.isEmpty());
        shown.view.show(evaluatedCircles(longPair(120'000)), 0);
        QTRY_VERIFY(!shown.canvas->isMaking());
        QVERIFY(shown.canvas->accessibleDescription() != before);
    }

    void whatIsUnderThePointerStaysThere() {
        Shown shown;
        const auto at = shown.canvas->placeOf(ReadingPlace{0, 400});
        QVERIFY(at);
        for (int k = 0; k < 12; ++k)
            wheel(shown.canvas, *at);
        QVERIFY(shown.canvas->view().zoom > 10);
        const auto after = shown.canvas->placeOf(ReadingPlace{0, 400});
        QVERIFY(after);
        QVERIFY((*after - *at).manhattanLength() < 0.5);
    }

    void buttonsZoomAllSurfacesAlike() {
        Shown shown;
        shown.view.findChild<QComboBox *>(u"circleChoice"_s)->setCurrentIndex(1); // side by side
        emit shown.view.findChild<QComboBox *>(u"circleChoice"_s)->activated(1);
        const auto zooms = [&] {
            QList<double> all;
            for (const CircleCanvas *canvas : shown.circles->findChildren<CircleCanvas *>())
                if (canvas->isVisible())
                    all << canvas->view().zoom;
            return all;
        };
        QVERIFY(zooms().size() > 1);
        shown.view.findChild<QToolButton *>(u"zoomIn"_s)->click();
        for (const double zoom : zooms())
            QVERIFY(zoom > 1.2);
        shown.view.findChild<QToolButton *>(u"zoomOut"_s)->click();
        for (const double zoom : zooms())
            QVERIFY(std::abs(zoom - 1) < 1e-9);
        shown.view.findChild<QToolButton *>(u"zoomIn"_s)->click();
        shown.view.findChild<QToolButton *>(u"fitFigure"_s)->click();
        for (const double zoom : zooms())
            QCOMPARE(zoom, 1.0);
    }

    /// In a low window the senses stand beside the circles, where the sentence of the centre is.
    void theSentenceOfTheCentreLeavesTheSensesAlone() {
        Shown shown;
        const CircleFigure figure = *shown.canvas->paperFigure();
        CircleFigure without = figure;
        without.arrows.clear();
        int beside = 0;
        for (int height = 120; height < 420; height += 20) {
            const QRect area(0, 0, 360, height);
            const auto drawn = [&area](const CircleFigure &one) {
                QImage image(area.size(), QImage::Format_RGB32);
                image.fill(Qt::white);
                QPainter painter(&image);
                drawFigure(painter, area, one, Medium::screenLight);
                return image;
            };
            QImage image(area.size(), QImage::Format_RGB32);
            QPainter painter(&image);
            const QRectF inPoints(QPointF(0, 0), QSizeF(area.size()) * pointsPerPixel);
            const int left = static_cast<int>(leftOfSenses(painter, inPoints, figure, Medium::screenLight) /
                                              pointsPerPixel);
            if (left >= area.width())
                continue;
            ++beside;
            const QRect corner(0, 0, left, height / 2);
            QVERIFY2(drawn(figure).copy(corner) == drawn(without).copy(corner),
                     qPrintable(QString::number(height)));
        }
        QVERIFY(beside > 0);
        const auto widthOf = [&shown](int height) {
            shown.canvas->resize(345, height); // narrower than the view would be
            shown.canvas->grab();
            return shown.canvas->centreBox().width();
        };
        const int low = widthOf(140);
        QVERIFY2(low < widthOf(600), qPrintable(QString::number(low)));
    }

    void togglesAreNamedWhereThereIsLittleRoom() {
        Selection selection;
        QWidget place; // in which it may be narrower than its layout would have it
        CircleFigureView view(selection, &place);
        view.show(evaluatedCircles(decidedPair()), 0);
        place.resize(700, 450);
        place.show();
        for (const auto &[width, name] : {std::pair(280, u"YX"_s), std::pair(620, u"clockwise"_s)}) {
            view.resize(width, 420);
            view.grab();
            for (const char *toggle : {"showClockwise", "showCounterclockwise"}) {
                const auto *button = view.findChild<QToolButton *>(QLatin1StringView(toggle));
                QTRY_VERIFY2(button->width() >= button->sizeHint().width(), toggle); // else it ends in "…"
            }
            QCOMPARE(view.findChild<QToolButton *>(u"showClockwise"_s)->text(), name);
        }
    }

    void keysZoomAndMove() {
        Shown shown;
        QTest::keyClick(shown.canvas, Qt::Key_Plus);
        QVERIFY(shown.canvas->view().zoom > 1.2);
        const double x = shown.canvas->view().x;
        QTest::keyClick(shown.canvas, Qt::Key_Right);
        QVERIFY(shown.canvas->view().x > x);
        for (int k = 0; k < 100; ++k)
            QTest::keyClick(shown.canvas, Qt::Key_Right); // not beyond the figure
        QVERIFY(shown.canvas->view().x < 100);
        for (int k = 0; k < 20; ++k)
            QTest::keyClick(shown.canvas, Qt::Key_Minus);
        QCOMPARE(shown.canvas->view(), CircleView());
        for (int k = 0; k < 100; ++k)
            QTest::keyClick(shown.canvas, Qt::Key_Plus);
        QVERIFY(shown.canvas->view().zoom <= 500);
        QTest::keyClick(shown.canvas, Qt::Key_0);
        QCOMPARE(shown.canvas->view(), CircleView());
    }

    /// Of a picture that was panned over nothing is left: the next is, to the pixel, that of who begins
    /// there.
    void aPannedPictureIsAFreshOne() {
        const Test dense = longPair(6000);
        Shown panned(dense);
        for (const CircleView &view :
             {CircleView{0, 0, 1.2}, CircleView{3, -2, 1.2}, CircleView{-8, 7.5, 1.2}, CircleView{40, 1, 3},
              CircleView{42.25, 1, 3}, CircleView{1, 1, 3}, CircleView{2, -1, 3}, CircleView{45, 0, 30},
              CircleView{44.9, 0.1, 30}, CircleView{}, CircleView{1, 0, 1.2}}) {
            panned.canvas->setView(view);
            const QImage picture = panned.canvas->grab().toImage();
            Shown fresh(dense);
            fresh.canvas->setView(view);
            QCOMPARE(fresh.canvas->view(), panned.canvas->view());
            QVERIFY(fresh.canvas->grab().toImage() == picture);
        }
    }

    void dragMovesTheFigure() {
        Shown shown;
        shown.canvas->setView({10, 10, 5});
        shown.canvas->grab();
        QTest::mousePress(shown.canvas, Qt::LeftButton, {}, {200, 200});
        QMouseEvent move(QEvent::MouseMove, QPointF(230, 200), shown.canvas->mapToGlobal(QPointF(230, 200)),
                         Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(shown.canvas, &move);
        QVERIFY(shown.canvas->view().x < 10);
        QCOMPARE(shown.canvas->view().y, 10.0);
    }

    void eachPathCanBeHidden() {
        Shown shown;
        const auto colours = [&] {
            const QImage image = shown.canvas->grab().toImage();
            std::pair<int, int> found; // blue, orange
            for (int y = 0; y < image.height(); ++y) {
                for (int x = 0; x < image.width(); ++x) {
                    const QColor pixel = image.pixelColor(x, y);
                    found.first += pixel.blue() - pixel.red() > 60;
                    found.second += pixel.red() - pixel.blue() > 60;
                }
            }
            return found;
        };
        const auto both = colours();
        QVERIFY(both.first > 500 && both.second > 150);
        shown.view.findChild<QToolButton *>(u"showCounterclockwise"_s)->click();
        QVERIFY(colours().first < both.first / 20);
        QVERIFY(colours().second > 150);
        QVERIFY(shown.canvas->readOut({0, 5}).isEmpty());
        shown.view.findChild<QToolButton *>(u"showCounterclockwise"_s)->click();
        shown.view.findChild<QToolButton *>(u"showClockwise"_s)->click();
        QVERIFY(colours().second < both.second / 20);
        QCOMPARE(shown.circles->paperFigure()->traces.size(), std::size_t{1});
    }

    void theFiguresOfTheStandardCanBeChosen() {
        Shown shown;
        auto *choice = shown.view.findChild<QComboBox *>(u"circleChoice"_s);
        QStringList names;
        for (int i = 0; i < choice->count(); ++i)
            names << choice->itemText(i);
        QCOMPARE(names, QStringList({u"Combined"_s, u"G(b) and G side by side"_s, u"G XY"_s, u"G YX"_s,
                                     u"F XY"_s, u"F YX"_s}));
        const auto choose = [&](int index) {
            choice->setCurrentIndex(index);
            emit choice->activated(index);
        };
        choose(3);
        QCOMPARE(shown.circles->paperFigure()->envelope->id, u"G_YX"_s);
        choose(4);
        QCOMPARE(shown.circles->paperFigure()->envelope->id, u"Fmax_XY"_s);
        choose(1);
        int visible = 0;
        for (const CircleCanvas *canvas : shown.view.findChildren<CircleCanvas *>())
            visible += canvas->isVisible();
        QCOMPARE(visible, 3);
        choose(0);
        QCOMPARE(shown.circles->paperFigure()->envelope->id, u"G(b)_XY"_s);
    }

    void repetitionsHaveTheirToggle() {
        Test test = decidedPair();
        circular(test).arcs.push_back(circular(test).arcs[0]);
        Shown shown(test);
        auto *toggle = shown.view.findChild<QToolButton *>(u"showRepetitions"_s);
        QVERIFY(toggle->isVisible());
        QCOMPARE(shown.circles->paperFigure()->traces.size(), std::size_t{2});
        toggle->click();
        QCOMPARE(shown.circles->paperFigure()->traces.size(), std::size_t{3});
        Shown without;
        QVERIFY(!without.view.findChild<QToolButton *>(u"showRepetitions"_s)->isVisible());
    }

    void anExplanationMarksItsPoints() {
        Shown shown;
        const QImage before = shown.canvas->grab().toImage();
        shown.selection.setParameter(u"G_YX"_s); // its own points, also in the figure of both senses
        const QImage marked = shown.canvas->grab().toImage();
        const auto explained =
            explanation(evaluatedCircles(decidedPair()), 0, "G_YX", Language(Language::Id::english));
        QCOMPARE(explained->points.size(), std::size_t{4});
        const Arc arc = std::get<CircularMeasurement>(decidedPair().measurement).arcs[1];
        for (const RulingPoint &point : explained->points) {
            QCOMPARE(point.path, u"YX"_s);
            const auto nearest = std::ranges::min_element(arc.angles, {}, [&](double angle) {
                return std::abs(std::remainder(angle - point.angle, 360.0));
            });
            const auto at = shown.canvas->placeOf(
                ReadingPlace{1, static_cast<std::size_t>(nearest - arc.angles.begin())});
            QVERIFY(at);
            const QRect around(at->toPoint() - QPoint(9, 9), QSize(18, 18));
            QVERIFY(marked.copy(around) != before.copy(around));
        }
        shown.selection.setParameter({});
        QCOMPARE(shown.canvas->grab().toImage(), before);
    }

    void zoomStaysWhileTheTestChanges() {
        Test test = decidedPair();
        Shown shown(test);
        shown.canvas->setView({10, 10, 5});
        circular(test).arcs[0].radialDeviations[5] += 0.0005;
        shown.view.show(evaluatedCircles(test), 0);
        QCOMPARE(shown.canvas->view().zoom, 5.0);
        shown.view.fit();
        QCOMPARE(shown.canvas->view(), CircleView());
    }

    void copiesAndSavesForPaper() {
        Shown shown;
        shown.view.findChild<QToolButton *>(u"copyFigure"_s)->click();
        const QMimeData *copied = QGuiApplication::clipboard()->mimeData();
        QVERIFY(copied->data(u"image/svg+xml"_s).contains("<svg"));
        QVERIFY(copied->data(u"application/pdf"_s).startsWith("%PDF"));
        QVERIFY(copied->hasImage());
        QTemporaryDir folder;
        for (const QString &name : {u"a.pdf"_s, u"a.svg"_s, u"a.png"_s}) {
            QVERIFY(shown.view.saveTo(folder.filePath(name)));
            QVERIFY(QFileInfo(folder.filePath(name)).size() > 10000);
        }
    }

    void anotherKindOfTestHasItsOwnFigure() {
        Shown shown;
        QVERIFY(shown.circles->isVisible());
        shown.view.show({}, 0);
        QVERIFY(!shown.circles->isVisible());
        QVERIFY(!shown.circles->paperFigure());
        shown.view.grab();
    }
};

QTEST_MAIN(CircleCanvasTest)
#include "circlecanvas.moc"
