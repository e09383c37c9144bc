// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/figures/drawfigure.h"

#include "core/kernel/evaluation/positioningdata.h"
#include "core/print/figures/recordedtexts.h"
#include "figures/testfigures.h"
#include "figures/ticks.h"
#include "print/fonts.h"

#include <QFontInfo>
#include <QImage>
#include <QPainter>
#include <QTest>
#include <cmath>

using namespace palmer;
using namespace palmer::testdata;
using namespace Qt::StringLiterals;

Q_DECLARE_METATYPE(palmer::Medium)

namespace {

/// A figure with nothing but its axes, 0 … 10 each way.
CurveFigure emptyFigure() {
    CurveFigure figure;
    const Language language(Language::Id::english);
    setRange(figure.x, 0, 10, 5, TickSteps::lengths, language);
    setRange(figure.y, 0, 10, 5, TickSteps::values, language);
    for (int i = 0; i <= 10; ++i)
        figure.positions.push_back(i);
    return figure;
}

Curve line(CurveRole role, std::vector<std::pair<double, double>> points) {
    Curve curve{role, {}};
    int target = 0;
    for (const auto &[x, y] : points)
        curve.points.push_back({x, y, ++target});
    return curve;
}

struct Drawn {
    QImage image;
    FigureTransform transform;
};

Drawn drawn(const CurveFigure &figure, Medium medium, QSize size, QRectF rect) {
    Drawn result{QImage(size, QImage::Format_RGB32), {}};
    result.image.fill(medium == Medium::screenDark ? Qt::black : Qt::white);
    QPainter painter(&result.image);
    result.transform = drawFigure(painter, rect, figure, medium);
    return result;
}

/// How much of a colour a pixel holds against the background, 0 … 1: the share of a line that covers it.
double share(const QImage &image, QPoint place, const QColor &colour, const QColor &ground) {
    const QColor found = image.pixelColor(place);
    double dot = 0;
    double square = 0;
    for (const auto channel : {&QColor::red, &QColor::green, &QColor::blue}) {
        const double full = (colour.*channel)() - (ground.*channel)();
        dot += full * ((found.*channel)() - (ground.*channel)());
        square += full * full;
    }
    return dot / square;
}

/// Centre of a line that crosses the column of pixels, searched around y.
double centreOfLine(const QImage &image, int column, double y, const QColor &colour, const QColor &ground) {
    double weight = 0;
    double moment = 0;
    for (int row = int(y) - 4; row <= int(y) + 4; ++row) {
        const double here = share(image, {column, row}, colour, ground);
        weight += here;
        moment += here * (row + 0.5);
    }
    return weight > 0.5 ? moment / weight : -1;
}

/// A test with m targets, ups and downs of some micrometres; the same for the same m.
Test testOf(std::size_t m, std::size_t runs) {
    std::vector<double> targets;
    std::vector<std::vector<double>> rows[2];
    for (std::size_t i = 0; i < m; ++i)
        targets.push_back(1234.5 * static_cast<double>(i) /
                          static_cast<double>(std::max<std::size_t>(m, 2) - 1));
    for (std::size_t d = 0; d < 2; ++d) {
        for (std::size_t j = 0; j < runs; ++j) {
            rows[d].emplace_back();
            for (std::size_t i = 0; i < m; ++i) {
                rows[d].back().push_back(8 * std::sin(7.0 * static_cast<double>(i) / static_cast<double>(m)) +
                                         static_cast<double>(d) +
                                         0.4 * static_cast<double>((i * 7 + j * 3) % 5));
            }
        }
    }
    return positioningTest("ISO 230-2:2006", std::move(targets), rows[0], rows[1]);
}

} // namespace

/// How a figure is painted: where, and that it can be read.
class DrawFigure : public QObject {
    Q_OBJECT

private slots:
    void fontIsTheShippedOne();
    void measuresOfThePage();
    void transformMapsThereAndBack();
    void curvesLieWhereTheAxesSay_data();
    void curvesLieWhereTheAxesSay();
    void curveEndsAtItsTargets();
    void zoomedCurvesStayInThePlot();
    void bandsFillWhatTheyBound_data();
    void bandsFillWhatTheyBound();
    void screenIsFilled();
    void textsDoNotOverlap_data();
    void textsDoNotOverlap();
    void tooSmallDrawsNothing();
    void namesOfLinesAreWithinTheFigure();
};

void DrawFigure::fontIsTheShippedOne() {
    loadFonts();
    for (const bool bold : {false, true}) {
        for (const bool italic : {false, true}) {
            const QFontInfo info(paperFont(8, bold, italic));
            QCOMPARE(info.family(), paperFamily());
            QCOMPARE(info.bold(), bold);
            QCOMPARE(info.italic(), italic);
        }
    }
}

void DrawFigure::measuresOfThePage() {
    const CurveFigure figure =
        deviationFigure(example1988("ISO 230-2:2006"), evaluated(example1988("ISO 230-2:2006")),
                        Language(Language::Id::french));
    QCOMPARE(paperSize(figure), QSizeF(175, 86));
    const QRectF rect(QPointF(0, 0), paperSize(figure) * pointsPerMillimetre);
    const QRectF plot = drawn(figure, Medium::paper, {500, 250}, rect).transform.plotArea;
    // Report form: plot x 13.5 … 149, y 1.2 … 69.5 mm.
    const auto is = [](double points, double millimetres) {
        return std::abs(points / pointsPerMillimetre - millimetres) < 1e-9;
    };
    QVERIFY(is(plot.left(), 13.5));
    QVERIFY(is(plot.right(), 149));
    QVERIFY(is(plot.top(), 1.2));
    QVERIFY(is(plot.bottom(), 69.5));
}

void DrawFigure::transformMapsThereAndBack() {
    for (const Medium medium : {Medium::paper, Medium::screenLight}) {
        CurveFigure figure = emptyFigure();
        setRange(figure.x, -3, 1200, 5, TickSteps::lengths, Language(Language::Id::english));
        setRange(figure.y, -0.02, 0.5, 5, TickSteps::values, Language(Language::Id::english));
        const FigureTransform transform = drawn(figure, medium, {900, 600}, {120, 40, 600, 400}).transform;
        const auto near = [](QPointF a, QPointF b) { return (a - b).manhattanLength() < 1e-9; };
        QVERIFY(near(transform.map(-3, -0.02), transform.plotArea.bottomLeft()));
        QVERIFY(near(transform.map(1200, 0.5), transform.plotArea.topRight()));
        QVERIFY(near(transform.toData(transform.map(600, 0.1)), {600, 0.1}));
        QVERIFY(QRectF(120, 40, 600, 400).contains(transform.plotArea));
    }
}

void DrawFigure::curvesLieWhereTheAxesSay_data() {
    QTest::addColumn<Medium>("medium");
    QTest::addColumn<QRectF>("rect");
    QTest::newRow("on the page") << Medium::paper << QRectF(0, 0, 496, 244);
    QTest::newRow("on the page, elsewhere") << Medium::paper << QRectF(130, 77, 496, 244);
    QTest::newRow("on a screen") << Medium::screenLight << QRectF(0, 0, 496, 270);
    QTest::newRow("on a wide screen") << Medium::screenLight << QRectF(10, 20, 1000, 600);
    QTest::newRow("on a dark screen") << Medium::screenDark << QRectF(0, 0, 700, 300);
}

void DrawFigure::curvesLieWhereTheAxesSay() {
    QFETCH(Medium, medium);
    QFETCH(QRectF, rect);
    const QColor colour = figureColor(FigureRole::up, medium);
    const QColor ground =
        medium == Medium::paper ? QColor(Qt::white) : figureColor(FigureRole::background, medium);
    // Levels between the lines of the grid, one near each end of the axis.
    for (const double level : {0.7, 3.1, 5.0, 9.3}) {
        CurveFigure figure = emptyFigure();
        figure.curves.push_back(line(CurveRole::up, {{1.3, level}, {8.6, level}}));
        const Drawn result = drawn(figure, medium, {1100, 700}, rect);
        for (const double x : {3.1, 4.9, 6.9}) {
            const QPointF expected = result.transform.map(x, level);
            const double found = centreOfLine(result.image, int(expected.x()), expected.y(), colour, ground);
            // The raster engine rounds the edges of a line to sixteenths of a pixel, each by itself.
            QVERIFY2(std::abs(found - expected.y()) < 0.1,
                     qPrintable(u"%1: %2 instead of %3"_s.arg(level).arg(found).arg(expected.y())));
        }
    }
}

void DrawFigure::curveEndsAtItsTargets() {
    CurveFigure figure = emptyFigure();
    // Two pieces: nothing may be drawn across the gap.
    figure.curves.push_back(line(CurveRole::up, {{1, 5}, {3, 5}}));
    figure.curves.push_back(line(CurveRole::up, {{7, 5}, {9, 5}}));
    figure.curves.push_back(line(CurveRole::mean, {{5, 7}}));
    const Drawn result = drawn(figure, Medium::paper, {500, 250}, {0, 0, 496, 244});
    const QColor colour = figureColor(FigureRole::up, Medium::paper);
    const auto shows = [&](double x) {
        return share(result.image, result.transform.map(x, 5).toPoint(), colour, Qt::white) > 0.3;
    };
    QVERIFY(shows(2) && shows(8));
    QVERIFY(!shows(0.4) && !shows(4) && !shows(5) && !shows(6) && !shows(9.6));
}

void DrawFigure::zoomedCurvesStayInThePlot() {
    CurveFigure figure = emptyFigure();
    figure.curves.push_back(line(CurveRole::up, {{-20, -30}, {4, 5}, {40, 60}}));
    figure.bands.push_back({CurveRole::up, {{-20, -60, 0}, {4, 3, 7}, {40, 0, 90}}});
    figure.readings.push_back({CurveRole::up, 14, 5, 1, 1});
    figure.dimensions.push_back({u"A"_s, u"A"_s, -30, 60, -20, 40, DimensionPlace::gutter});
    const Drawn result = drawn(figure, Medium::paper, {500, 250}, {0, 0, 496, 244});
    const QRectF plot = result.transform.plotArea.adjusted(-2, -2, 2, 2);
    const QColor colour = figureColor(FigureRole::up, Medium::paper);
    int inside = 0;
    for (int row = 0; row < result.image.height(); ++row) {
        for (int column = 0; column < result.image.width(); ++column) {
            const QColor pixel = result.image.pixelColor(column, row);
            if (pixel.blue() - pixel.red() < 10) // grey, black, white
                continue;
            if (plot.contains(column + 0.5, row + 0.5))
                ++inside;
            else
                QFAIL(qPrintable(u"blue at %1, %2"_s.arg(column).arg(row)));
        }
    }
    QVERIFY(inside > 1000);
    QCOMPARE(result.image.pixelColor(result.transform.map(4, 5).toPoint()), colour);
}

void DrawFigure::bandsFillWhatTheyBound_data() {
    QTest::addColumn<int>("targets");
    QTest::addColumn<Medium>("medium");
    QTest::addRow("far apart") << 15 << Medium::screenLight;
    QTest::addRow("closer than the eye tells") << 400 << Medium::screenLight;
    QTest::addRow("as close, dark") << 400 << Medium::screenDark;
    QTest::addRow("as close, on paper") << 400 << Medium::paper;
}

/// Bands with gaps whose limits rise, fall and cross: every pixel two rows and a column away from a limit has
/// the colour of the bands it lies in.
void DrawFigure::bandsFillWhatTheyBound() {
    QFETCH(int, targets);
    QFETCH(Medium, medium);
    CurveFigure figure = emptyFigure();
    figure.x.ticks.clear();
    figure.y.ticks.clear();
    figure.positions.clear();
    for (int i = 0; i < targets; ++i)
        figure.positions.push_back(10.0 * i / (targets - 1));
    const auto limits = [](CurveRole role, double x) { // slow enough for straight lines between the targets
        return role == CurveRole::up ? Interval{2 + 0.2 * x, 6 - 0.1 * x}
                                     : Interval{4 - 0.3 * x, 5 + 0.4 * x};
    };
    const auto gap = [](CurveRole role) { return role == CurveRole::up ? Interval{3, 4} : Interval{3.5, 6}; };
    for (const CurveRole role : {CurveRole::up, CurveRole::down}) {
        bool open = false;
        for (const double x : figure.positions) {
            const bool none = x > gap(role).from && x < gap(role).to;
            if (!none && !open)
                figure.bands.push_back({role, {}});
            open = !none;
            if (open)
                figure.bands.back().points.push_back({x, limits(role, x).from, limits(role, x).to});
        }
    }
    const Drawn result = drawn(figure, medium, {900, 500}, QRectF(0, 0, 900, 500));
    const QRectF plot = result.transform.plotArea;
    const double pixel = result.transform.toData({1, 0}).x() - result.transform.toData({0, 0}).x();
    int seen[2][2]{};
    for (int column = int(plot.left()) + 3; column < int(plot.right()) - 3; ++column) {
        for (int row = int(plot.top()) + 3; row < int(plot.bottom()) - 3; ++row) {
            const QPointF at = result.transform.toData({column + 0.5, row + 0.5});
            bool in[2]{};
            bool near = false;
            for (const Band &band : figure.bands) {
                const double first = band.points.front().x;
                const double last = band.points.back().x;
                const Interval here = limits(band.role, at.x());
                near |= std::abs(at.x() - first) < 2 * pixel || std::abs(at.x() - last) < 2 * pixel;
                for (const double limit : {here.from, here.to})
                    near |= std::abs(result.transform.map(at.x(), limit).y() - (row + 0.5)) < 2.5;
                in[band.role == CurveRole::up ? 0 : 1] |=
                    at.x() > first && at.x() < last && at.y() > here.from && at.y() < here.to;
            }
            if (near)
                continue;
            ++seen[in[0] ? 1 : 0][in[1] ? 1 : 0];
            const QColor expected = in[0] || in[1] ? bandColor(in[0], in[1], medium)
                                                   : figureColor(FigureRole::background, medium);
            if (result.image.pixelColor(column, row) != expected)
                QFAIL(qPrintable(QStringLiteral("%1 at %2, %3")
                                     .arg(result.image.pixelColor(column, row).name())
                                     .arg(at.x())
                                     .arg(at.y())));
        }
    }
    for (const auto &row : seen)
        QVERIFY(row[0] > 1000 && row[1] > 1000);
}

void DrawFigure::screenIsFilled() {
    const Drawn dark = drawn(emptyFigure(), Medium::screenDark, {500, 300}, {0, 0, 500, 300});
    QCOMPARE(dark.image.pixelColor(499, 0), figureColor(FigureRole::background, Medium::screenDark));
}

void DrawFigure::textsDoNotOverlap_data() {
    QTest::addColumn<std::size_t>("targets");
    QTest::addColumn<double>("scale"); // of the deviations
    QTest::addColumn<Medium>("medium");
    QTest::addColumn<QSizeF>("size");
    for (const std::size_t m : {1, 2, 3, 11, 100, 400}) {
        for (const double scale : {0.002, 1.0, 4000.0}) {
            const auto row = [&](const char *where) -> QTestData & {
                return QTest::addRow("%d targets, scale %g, %s", int(m), scale, where);
            };
            row("page") << m << scale << Medium::paper << QSizeF(175, 86) * pointsPerMillimetre;
            row("window") << m << scale << Medium::screenLight << QSizeF(496, 260);
            row("smallest window") << m << scale << Medium::screenDark << QSizeF(420, 200);
            row("maximised") << m << scale << Medium::screenLight << QSizeF(1500, 800);
        }
    }
}

void DrawFigure::textsDoNotOverlap() {
    QFETCH(std::size_t, targets);
    QFETCH(double, scale);
    QFETCH(Medium, medium);
    QFETCH(QSizeF, size);
    Test test = testOf(targets, 4);
    for (Run &run : measurement(test).runs) {
        for (auto &deviation : run.deviations)
            deviation = *deviation * scale;
    }
    const TestEvaluation evaluation = evaluated(test);
    for (const Language::Id id : {Language::Id::english, Language::Id::french}) {
        const CurveFigure figure = deviationFigure(test, evaluation, Language(id), {.dimensions = false});
        TextRecorder recorder(size.toSize());
        QPainter painter(&recorder);
        drawFigure(painter, {QPointF(0, 0), size}, figure, medium);
        painter.end();
        QVERIFY(recorder.texts.size() >=
                figure.legend.size() + 6); // at least two numbers an axis and its title
        const QRectF page(QPointF(0, 0), size);
        for (std::size_t i = 0; i < recorder.texts.size(); ++i) {
            const RecordedText &a = recorder.texts[i];
            QVERIFY2(page.contains(a.box), qPrintable(a.text));
            for (std::size_t j = 0; j < i; ++j) {
                const RecordedText &b = recorder.texts[j];
                // Pieces of one line touch each other.
                QVERIFY2(
                    !a.box.adjusted(0.1, 0.1, -0.1, -0.1).intersects(b.box.adjusted(0.1, 0.1, -0.1, -0.1)),
                    qPrintable(u"%1 on %2"_s.arg(a.text, b.text)));
            }
        }
    }
}

void DrawFigure::tooSmallDrawsNothing() {
    const CurveFigure figure = emptyFigure();
    const Drawn result = drawn(figure, Medium::screenLight, {40, 30}, {0, 0, 40, 30});
    QVERIFY(result.transform.plotArea.isEmpty());
}

/// The name at the end of a line is within the figure, however long it is.
void DrawFigure::namesOfLinesAreWithinTheFigure() {
    const Language language(Language::Id::english);
    for (const QString &name : {u"spindle"_s, u"column, 300 mm above the table, facing the door"_s}) {
        LineFigure figure;
        setRange(figure.x, 0, 10, 5, TickSteps::values, language);
        setRange(figure.y, 0, 10, 5, TickSteps::values, language);
        figure.lines.push_back({LineRole::machine, name, {}, {{0, 0}, {10, 10}}});
        const QSizeF size(496, 113); // 175 mm × 40 mm in points
        TextRecorder recorder(size.toSize());
        QPainter painter(&recorder);
        drawFigure(painter, {QPointF(0, 0), size}, figure, Medium::paper);
        painter.end();
        int found = 0;
        for (const RecordedText &text : recorder.texts) {
            if (!text.text.startsWith(name.left(5)))
                continue;
            ++found;
            QVERIFY(text.box.right() <= size.width());
            QCOMPARE(text.text.endsWith(u'…'), name.size() > 20);
        }
        QCOMPARE(found, 1);
    }
}

QTEST_MAIN(DrawFigure)
#include "drawfigure.moc"
