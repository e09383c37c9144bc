// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/print/figures/recordedtexts.h"
#include "figures/circlefigure.h"
#include "print/figures/drawkinds.h"
#include "print/figures/exportfigure.h"
#include "print/figures/style.h"
#include "ui/circles.h"

#include <QImage>
#include <QPainter>
#include <QTest>
#include <QXmlStreamReader>
#include <cmath>
#include <numbers>
#include <random>

using namespace palmer;
using namespace palmer::testdata;
using namespace Qt::StringLiterals;

Q_DECLARE_METATYPE(palmer::Medium)

namespace {

CircleFigure figureOf(const Test &test, const CircleFigureOptions &options = {},
                      Language::Id language = Language::Id::english) {
    return circleFigure(test, evaluatedCircular(test), Language(language), options);
}

struct Drawn {
    QImage image;
    FigureTransform transform;
};

/// On paper ten pixels a mm, on a screen as many as points say.
Drawn drawn(const CircleFigure &figure, Medium medium) {
    const bool paper = medium == Medium::paper;
    const double scale = paper ? 10 / pointsPerMillimetre : 1;
    const QSizeF size = paper ? printedSize(figure) * pointsPerMillimetre : figure.size * 96 / 25.4;
    Drawn result{QImage((size * scale).toSize(), QImage::Format_RGB32), {}};
    result.image.fill(Qt::white);
    QPainter painter(&result.image);
    painter.scale(scale, scale);
    result.transform = drawFigure(painter, {{0, 0}, size}, figure, medium);
    return result;
}

/// Width of a run of pixels darker than the middle of white and `ink`, along a ray from the centre, mm.
double widthOfLine(const QImage &image, QPointF centre, double angle, double radius, int threshold) {
    int dark = 0;
    for (double r = radius - 2; r <= radius + 2; r += 0.01) {
        const QPointF at = centre + QPointF(std::cos(angle), -std::sin(angle)) * r * 10; // ten pixels a mm
        dark += qGray(image.pixel(at.toPoint())) < threshold;
    }
    return dark * 0.01;
}

} // namespace

/// How the figure of a circular test is painted: where, and that it can be read.
class DrawCircleFigure : public QObject {
    Q_OBJECT

private slots:
    void deviationsAreMagnifiedAboutTheNominalCircle() {
        // 10 µm outwards in the first quadrant only
        const Test test = circularTest({pathOf(Sense::counterclockwise, 3600, [](double angle) {
            return angle > 0.3 && angle < 1.2 ? 10.0 : 0.0;
        })});
        CircleFigureOptions options{.limits = false};
        options.subject = CircleSubject::radialDeviation;
        Test about = test;
        circular(about).centring = Centring::instrument; // as read: the centre does not move
        CircleFigure figure = figureOf(about, options);
        QCOMPARE(figure.magnification, 1000.0);
        figure.envelope.reset(); // Fmin and Fmax lie on the path
        const Drawn result = drawn(figure, Medium::paper);
        const QPointF centre = result.transform.map(0, 0) * 10 / pointsPerMillimetre;
        // light line 34 + 10 mm from the centre in the quadrant, none there outside it; 0.24 mm wide
        QVERIFY(std::abs(widthOfLine(result.image, centre, 0.9, 44, 160) - 0.24) < 0.1);
        QVERIFY(widthOfLine(result.image, centre, 2.8, 46, 160) < 0.05);
        // equal scales: the transform is the same both ways
        const QTransform &t = result.transform.toPainter;
        QVERIFY(std::abs(t.m11() + t.m22()) < 1e-12 && t.m12() == 0);
        QVERIFY(std::abs(t.m11() - pointsPerMillimetre) < 1e-9);
    }

    /// Of a figure that gives way on a page: the magnification it states stays that of the paper, and the key
    /// keeps its size, for its letters do.
    void smallerFiguresKeepTheirMagnification() {
        Test test = circularTest({pathOf(Sense::counterclockwise, 3600, [](double angle) {
            return angle > 0.3 && angle < 1.2 ? 10.0 : 0.0;
        })});
        circular(test).centring = Centring::instrument;
        CircleFigureOptions options{.limits = false};
        options.subject = CircleSubject::radialDeviation;
        CircleFigure figure = figureOf(test, options);
        figure.envelope.reset();
        QCOMPARE(figure.magnification, 1000.0); // 10 µm are 10 mm
        const double whole = printedSize(figure).height();
        QVERIFY(leastHeight(figure) < whole - 35);
        QImage wholeKey;
        for (const double height : {whole, whole - 5, whole - 20, whole - 35}) {
            const QSizeF size(printedSize(figure).width(), height);
            QImage image((size * 10).toSize(), QImage::Format_RGB32); // ten pixels a mm
            image.fill(Qt::white);
            QPainter painter(&image);
            painter.scale(10 / pointsPerMillimetre, 10 / pointsPerMillimetre);
            const FigureTransform transform =
                drawFigure(painter, {{0, 0}, size * pointsPerMillimetre}, figure, Medium::paper);
            painter.end();
            const QPointF centre = transform.map(0, 0) * 10 / pointsPerMillimetre;
            const auto outermost = [&](double angle) { // black or coloured, from the edge inwards, mm
                for (double radius = 50; radius > 0; radius -= 0.01) {
                    const QPoint at =
                        (centre + QPointF(std::cos(angle), -std::sin(angle)) * radius * 10).toPoint();
                    if (image.rect().contains(at) && qGray(image.pixel(at)) < 160)
                        return radius;
                }
                return 0.0;
            };
            const double magnified = outermost(0.9) - outermost(2.8);
            QVERIFY2(std::abs(magnified - 10) < 0.3, // half a line and a pixel at either end
                     qPrintable(u"%1 mm at a height of %2 mm"_s.arg(magnified).arg(height)));
            const int rows = static_cast<int>(figure.keyHeight * 10) - 5;
            const QImage key = image.copy(0, image.height() - rows, image.width(), rows);
            if (wholeKey.isNull())
                wholeKey = key;
            QCOMPARE(key.size(), wholeKey.size());
            int different = 0;
            for (int y = 0; y < key.height(); ++y) {
                for (int x = 0; x < key.width(); ++x)
                    different += std::abs(qGray(key.pixel(x, y)) - qGray(wholeKey.pixel(x, y))) > 128;
            }
            QVERIFY2(different < 20, qPrintable(u"%1 pixels of the key differ"_s.arg(different)));
        }
    }

    void sensesDifferInBlackAndWhite() {
        const auto outside = [](double) { return 5.0; };
        double width[2] = {};
        for (const Sense sense : {Sense::counterclockwise, Sense::clockwise}) {
            Test test = circularTest({pathOf(sense, 720, outside)});
            circular(test).centring = Centring::instrument;
            CircleFigureOptions options{.limits = false};
            options.subject = CircleSubject::radialDeviation;
            CircleFigure figure = figureOf(test, options);
            figure.envelope.reset(); // it lies on the path
            const Drawn result = drawn(figure, Medium::paper);
            const QPointF centre = result.transform.map(0, 0) * 10 / pointsPerMillimetre;
            const double radius = figure.radius(5);
            width[sense == Sense::clockwise] = widthOfLine(
                result.image.convertToFormat(QImage::Format_Grayscale8), centre, 0.6, radius, 200);
        }
        QVERIFY(width[0] > 0.1);
        QVERIFY(width[1] > 1.3 * width[0]);
    }

    void darkFiguresAreDark() {
        const CircleFigure figure = figureOf(decidedPair(), {.size = {130, 90}});
        const Drawn result = drawn(figure, Medium::screenDark);
        QCOMPARE(result.image.pixelColor(1, result.image.height() / 2),
                 figureColor(FigureRole::background, Medium::screenDark));
    }

    void textsDoNotOverlap_data() {
        QTest::addColumn<double>("scale");  // of the deviations
        QTest::addColumn<double>("offset"); // µm, outwards
        QTest::addColumn<Medium>("medium");
        QTest::addColumn<QSizeF>("size");
        for (const double scale : {0.01, 0.4, 1.0, 30.0, 1000.0}) {
            for (const double offset : {-40.0, 0.0, 40.0}) {
                const auto row = [&](const char *where) -> QTestData & {
                    return QTest::addRow("deviations times %g, %g µm off, %s", scale, offset, where);
                };
                row("page") << scale << offset << Medium::paper << QSizeF(112, 105);
                row("small on a page") << scale << offset << Medium::paper << QSizeF(84, 80);
                row("window") << scale << offset << Medium::screenLight << QSizeF(125, 80);
                row("smallest window") << scale << offset << Medium::screenDark << QSizeF(95, 45);
                row("maximised") << scale << offset << Medium::screenLight << QSizeF(420, 230);
            }
        }
    }

    void textsDoNotOverlap() {
        QFETCH(const double, scale);
        QFETCH(const double, offset);
        QFETCH(const Medium, medium);
        QFETCH(const QSizeF, size);
        Test test = ballbarPair();
        for (Arc &arc : circular(test).arcs) {
            for (double &deviation : arc.radialDeviations)
                deviation = deviation * scale + offset / 1000;
        }
        const auto entered = [](double limit) { return std::round(limit * 1e6) / 1e6; };
        test.limits["G(b)"].value = entered(0.0255 * scale);
        test.limits["G"].value = entered(0.022 * scale);
        test.limits["F"].value = entered(0.018 * scale + std::abs(offset) / 1000);
        const TestEvaluation evaluation = evaluatedCircular(test);
        for (const Language::Id id : {Language::Id::english, Language::Id::french}) {
            for (CircleFigureOptions options : separateCircleFigures(test, evaluation)) {
                options.size = size;
                options.contacts = medium != Medium::paper;
                const CircleFigure figure = circleFigure(test, evaluation, Language(id), options);
                const QSizeF area = medium == Medium::paper ? printedSize(figure) * pointsPerMillimetre
                                                            : figure.size * 96 / 25.4;
                TextRecorder recorder(area.toSize());
                QPainter painter(&recorder);
                drawFigure(painter, {QPointF(0, 0), area}, figure, medium);
                painter.end();
                const QRectF page(QPointF(0, 0), area);
                QVERIFY(recorder.texts.size() >= 5);
                for (std::size_t i = 0; i < recorder.texts.size(); ++i) {
                    const RecordedText &a = recorder.texts[i];
                    QVERIFY2(page.contains(a.box), qPrintable(a.text));
                    for (std::size_t j = 0; j < i; ++j) {
                        const RecordedText &b = recorder.texts[j];
                        QVERIFY2(!a.box.adjusted(0.1, 0.1, -0.1, -0.1)
                                      .intersects(b.box.adjusted(0.1, 0.1, -0.1, -0.1)),
                                 qPrintable(u"%1 on %2"_s.arg(a.text, b.text)));
                    }
                }
            }
        }
    }

    void keyIsWhole() {
        for (const Language::Id id : {Language::Id::english, Language::Id::french}) {
            const CircleFigure figure = figureOf(decidedPair(), {}, id);
            TextRecorder recorder((printedSize(figure) * pointsPerMillimetre).toSize());
            QPainter painter(&recorder);
            drawFigure(painter, {{0, 0}, printedSize(figure) * pointsPerMillimetre}, figure, Medium::paper);
            painter.end();
            QStringList texts;
            for (const RecordedText &text : recorder.texts)
                texts << text.text;
            for (const CircleLegendEntry &entry : figure.legend)
                QVERIFY2(texts.contains(entry.text), qPrintable(entry.text));
            QVERIFY(texts.contains(figure.envelope->label));
            QVERIFY(texts.contains(figure.envelope->limitLabel));
            for (const QString &text : {figure.ratio, figure.divisionLabel, u"X"_s, u"Y"_s, u"XY"_s, u"YX"_s})
                QVERIFY2(texts.contains(text), qPrintable(text));
        }
    }

    void zoomedDeepItIsDrawnQuicklyAndInPlace() {
        const Test test = decidedPair();
        const TestEvaluation evaluation = evaluatedCircular(test);
        const Language language(Language::Id::english);
        const auto profiles = pathProfiles(test, evaluation);
        const CircleFigure whole = circleFigure(test, evaluation, profiles, language, {.size = {130, 90}});
        // a point of the first path in the middle, 400 times
        const TracePoint &point = whole.traces[0].points[250];
        const double angle = point.angle * std::numbers::pi / 180;
        const double radius = whole.radius(point.deviation);
        const CircleView view{radius * std::cos(angle), radius * std::sin(angle), 400};
        const CircleFigure zoomed = withView(whole, profiles, view, language);
        const Drawn result = drawn(zoomed, Medium::screenLight);
        const QPoint middle = QRectF(result.image.rect()).center().toPoint();
        const QColor found = result.image.pixelColor(middle);
        QVERIFY(found.blue() - found.red() > 60); // the path
        QVERIFY((result.transform.map(view.x, view.y) - QPointF(middle)).manhattanLength() < 2);
    }

    void svgHasItsSizeAndTexts() {
        const CircleFigure figure = figureOf(decidedPair(), {}, Language::Id::french);
        QXmlStreamReader reader(figureAsSvg(figure, figure.title, Language(Language::Id::french)));
        QStringList texts;
        while (!reader.atEnd()) {
            reader.readNext();
            if (!reader.isStartElement())
                continue;
            if (reader.name() == "svg"_L1)
                QCOMPARE(reader.attributes().value("width"_L1), u"112mm"_s);
            QVERIFY(reader.name() != "image"_L1);
            if (reader.name() == "text"_L1)
                texts += reader.readElementText().trimmed();
        }
        QVERIFY2(!reader.hasError(), qPrintable(reader.errorString()));
        for (const QString &expected : {u"1\u202f000:1"_s, u"−10"_s, u"zone minimale, G(b)"_s, u"YX"_s})
            QVERIFY2(texts.contains(expected), qPrintable(expected));
    }

    /// The goal for 10⁶ points a path: below 1 MB, vectors only.
    void pdfOfAMillionPointsIsSmall() {
        const Test test = longPair(1000000);
        const QByteArray pdf = figureAsPdf(figureOf(test), u"Figure"_s);
        QVERIFY(!pdf.contains("/Subtype /Image"));
        QVERIFY2(pdf.size() < 1000000, qPrintable(QString::number(pdf.size())));
        QVERIFY(pdf.size() > 50000); // the paths are in it
    }

    /// Whatever the paths and the limit: its ticks stand on the ends of its line, and its text on no path.
    void theLimitIsWholeAndCanBeRead() {
        std::mt19937 random(1);
        const auto between = [&](double from, double to) {
            return std::uniform_real_distribution<double>(from, to)(random);
        };
        int limits = 0;
        int beside = 0;
        constexpr int figures = 150;
        for (int i = 0; i < figures; ++i) {
            const double size = std::pow(10, between(-0.5, 1.5)); // µm
            std::vector<Arc> arcs;
            for (const Sense sense : {Sense::counterclockwise, Sense::clockwise}) {
                const int lobes = static_cast<int>(between(2, i % 3 == 0 ? 90 : 12));
                const double phase = between(0, 6);
                const double spike = i % 4 == 0 ? size : 0;
                arcs.push_back(pathOf(sense, 720, [=](double angle) {
                    return size * std::sin(lobes * angle + phase) + (std::cos(angle) > 0.99 ? spike : 0);
                }));
            }
            Test test = circularTest(std::move(arcs));
            test.limits["G(b)"].value = size * between(0.5, 6) / 1000;
            const CircleFigure figure = figureOf(test);
            if (!figure.envelope || !figure.envelope->limit)
                continue; // said below the figure
            ++limits;
            const QSizeF area = printedSize(figure) * pointsPerMillimetre;
            TextRecorder recorder(area.toSize());
            QPainter painter(&recorder);
            const FigureTransform transform =
                drawFigure(painter, {QPointF(0, 0), area}, figure, Medium::paper);
            painter.end();
            std::vector<QPolygonF> ofLimit;
            const QPen pen = figurePen(FigureRole::limit, Medium::paper);
            for (const RecordedLine &line : recorder.lines) {
                if (std::abs(line.pen.widthF() - pen.widthF()) < 1e-9 && line.pen.style() == Qt::SolidLine &&
                    line.points.size() == 2 && line.pen.color() == pen.color())
                    ofLimit.push_back(line.points);
            }
            QVERIFY(ofLimit.size() >= 3); // the line, then its ticks; the star of the key is like them
            for (const std::size_t tick : {1, 2}) {
                const QPointF middle = (ofLimit[tick][0] + ofLimit[tick][1]) / 2;
                const double away =
                    std::min(QLineF(middle, ofLimit[0][0]).length(), QLineF(middle, ofLimit[0][1]).length());
                QVERIFY2(away < 0.05, qPrintable(u"figure %1: a tick %2 points away"_s.arg(i).arg(away)));
            }
            const auto label =
                std::ranges::find(recorder.texts, figure.envelope->limitLabel, &RecordedText::text);
            QVERIFY2(label != recorder.texts.end(), qPrintable(u"figure %1 without its limit"_s.arg(i)));
            beside += label->box.width() > 1 && label->outline.boundingRect().height() < 8 ? 1 : 0;
            for (const CircleTrace &trace : figure.traces) {
                for (const TracePoint &point : trace.points) {
                    const double angle = point.angle * std::numbers::pi / 180;
                    const double radius = figure.radius(point.deviation);
                    const QPointF at = transform.map(radius * std::cos(angle), radius * std::sin(angle));
                    QVERIFY2(!label->outline.containsPoint(at, Qt::OddEvenFill),
                             qPrintable(u"figure %1: %2 on a path"_s.arg(i).arg(label->text)));
                }
            }
        }
        QVERIFY(limits > figures / 2);
        QVERIFY(beside > 0); // where there is no room along the line
    }

    /// Of a quarter of a circle, wherever it lies, the frame shows nothing but that quarter.
    void aQuarterFillsItsFrame() {
        for (int from = 0; from < 360; from += 15) {
            Arc arc = pathOf(Sense::counterclockwise, 360, [](double) { return 0.0; });
            arc.angles.clear();
            arc.radialDeviations.clear();
            for (int i = 0; i <= 90; ++i) {
                arc.angles.push_back(from + i);
                arc.radialDeviations.push_back(0.002 * std::sin(i / 7.0));
            }
            CircleFigureOptions options;
            options.fillFrame = true;
            const CircleFigure figure = figureOf(circularTest({arc}), options);
            QVERIFY(figure.sector);
            TextRecorder recorder((printedSize(figure) * pointsPerMillimetre).toSize());
            QPainter painter(&recorder);
            const QRectF area(QPointF(0, 0), printedSize(figure) * pointsPerMillimetre);
            const FigureTransform transform = drawFigure(painter, area, figure, Medium::paper);
            painter.end();
            QRectF taken(transform.map(0, 0), QSizeF(0.01, 0.01)); // with its centre
            for (const TracePoint &point : figure.traces.front().points) {
                const double angle = point.angle * std::numbers::pi / 180;
                const double radius = figure.radius(point.deviation);
                taken |= QRectF(transform.map(radius * std::cos(angle), radius * std::sin(angle)),
                                QSizeF(0.01, 0.01));
            }
            QVERIFY2(area.contains(taken), qPrintable(QString::number(from)));
            // Of the drawing 112 × 105 mm; a whole circle of it would show the quarter 34 mm wide.
            const double fill = std::max(taken.width() / (112 * pointsPerMillimetre),
                                         taken.height() / (105 * pointsPerMillimetre));
            QVERIFY2(fill > 0.55, qPrintable(u"from %1°: %2"_s.arg(from).arg(fill)));
        }
    }

    void tooSmallDrawsNothingBad() {
        const CircleFigure figure = figureOf(decidedPair(), {.size = {5, 3}});
        const Drawn result = drawn(figure, Medium::screenLight);
        QVERIFY(!result.image.isNull());
    }
};

QTEST_MAIN(DrawCircleFigure)
#include "drawcirclefigure.moc"
