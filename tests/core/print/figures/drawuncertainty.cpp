// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/testfigures.h"

#include "core/kernel/uncertainty/uncertaintydata.h"
#include "core/print/figures/recordedtexts.h"
#include "kernel/simulation/simulate.h"
#include "print/figures/drawkinds.h"

#include <QImage>
#include <QPainter>
#include <QTest>

using namespace palmer;
using namespace palmer::testdata;
using namespace Qt::StringLiterals;

namespace {

Test x1() {
    Test test = example1988("ISO 230-2:2006");
    stateX1(measurement(test));
    measurement(test).uncertainty.length = 500;
    return test;
}

TestEvaluation simulated(const Test &test) {
    static const Machine machine;
    Surroundings surroundings;
    surroundings.machine = &machine;
    SimulationOptions options;
    options.trials = 20000;
    surroundings.simulation = std::make_shared<const Simulation>(
        simulate(test, surroundings, *findEdition(test.edition), options).value());
    return evaluateTest(test, surroundings);
}

/// The machines of a type: values with U, limits and two lines.
BarFigure dots(int machines) {
    BarFigure figure;
    figure.x = {{}, u"A"_s, {}, u"µm"_s, false, 4, 14, 2, {}};
    for (int i = 4; i <= 14; i += 2)
        figure.x.ticks.push_back({static_cast<double>(i), QString::number(i)});
    figure.dots = DotLegend{u"value ± U"_s, u"agreed limit"_s};
    for (int i = 0; i < machines; ++i) {
        const QString number = QString::number(i + 1);
        figure.bars.push_back({u"machine"_s + number,
                               u"Machine "_s + number,
                               {},
                               6 + 3.0 * i / machines,
                               u"6.5 ± 1.6"_s,
                               {},
                               false,
                               1.6,
                               12.0});
    }
    figure.lines = {{13, u"Limite de tolérance, log-normale 13,0 µm"_s, true},
                    {12.5, u"Limite de tolérance, normale 12,5 µm"_s, false}};
    return figure;
}

Figure figureOf(const QString &kind, Language::Id id) {
    const Language language(id);
    if (kind.startsWith(u"dots"))
        return dots(kind == u"dots"_s ? 8 : 90);
    if (kind == u"drift"_s) {
        DriftMeasurement measurement;
        measurement.axis.name = "X";
        measurement.times = {0, 600, 1200, 1800};
        measurement.deviations = {0, 0.0024, -0.0008, 0.001};
        Test test;
        test.measurement = measurement;
        return driftFigure(test, evaluateTest(test, {}), language);
    }
    const Test test = x1();
    if (kind == u"bars"_s)
        return budgetFigure(test, evaluated(test), language);
    const TestEvaluation evaluation = simulated(test);
    return *histogramFigure(test, evaluation, *parameter(evaluation, "A"), language);
}

constexpr QRgb background = 0xffffffff;

/// Columns of a picture that show something on a white ground.
int inkedColumns(const QImage &image) {
    int count = 0;
    for (int x = 0; x < image.width(); ++x) {
        for (int y = 0; y < image.height(); ++y) {
            if (image.pixel(x, y) != background) {
                ++count;
                break;
            }
        }
    }
    return count;
}

QImage blank() {
    QImage image(200, 20, QImage::Format_RGB32);
    image.fill(Qt::white);
    return image;
}

} // namespace

/// Bars, histograms and drift curves as they are drawn.
class DrawUncertainty : public QObject {
    Q_OBJECT

private slots:
    void textsStayInsideAndApart_data() {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<Language::Id>("language");
        for (const char *kind : {"bars", "dots", "dots of many machines", "histogram", "drift"}) {
            QTest::addRow("%s in English", kind) << QString::fromLatin1(kind) << Language::Id::english;
            QTest::addRow("%s in French", kind) << QString::fromLatin1(kind) << Language::Id::french;
        }
    }

    void textsStayInsideAndApart() {
        QFETCH(QString, kind);
        QFETCH(Language::Id, language);
        const Figure figure = figureOf(kind, language);
        const QSizeF size = paperSize(figure) * pointsPerMillimetre;
        TextRecorder recorder(size.toSize());
        QPainter painter(&recorder);
        drawFigure(painter, QRectF(QPointF(), size), figure, Medium::paper);
        painter.end();
        QVERIFY(recorder.texts.size() > 8);
        const QRectF area = QRectF(QPointF(), size).adjusted(-1, -1, 1, 1);
        for (const RecordedText &text : recorder.texts)
            QVERIFY2(area.contains(text.box), qPrintable(text.text));
        for (std::size_t i = 0; i < recorder.texts.size(); ++i) {
            for (std::size_t k = i + 1; k < recorder.texts.size(); ++k) {
                const QRectF common =
                    recorder.texts[i].box.adjusted(0.5, 0.5, -0.5, -0.5).intersected(recorder.texts[k].box);
                QVERIFY2(common.isEmpty(),
                         qPrintable(recorder.texts[i].text + u" and "_s + recorder.texts[k].text));
            }
        }
    }

    void aBarIsAsLongAsItsPart_data() {
        QTest::addColumn<double>("part");
        QTest::addColumn<int>("columns");
        QTest::newRow("nothing") << 0.0 << 0;
        QTest::newRow("a quarter") << 0.25 << 50;
        QTest::newRow("the whole scale") << 1.0 << 200;
        QTest::newRow("never beyond the scale") << 1.5 << 200;
    }

    void aBarIsAsLongAsItsPart() {
        QFETCH(double, part);
        QFETCH(int, columns);
        QImage image = blank();
        QPainter painter(&image);
        drawBar(painter, QRectF(0, 5, 200, 10), part, false, Medium::paper);
        painter.end();
        QCOMPARE(inkedColumns(image), columns);
    }

    void theInkOfAHistogramIsItsCounts() {
        HistogramFigure figure;
        figure.x.from = 0;
        figure.x.to = 20;
        figure.from = 0;
        figure.width = 1;
        figure.counts = {0, 0, 0, 0, 0, 1, 2, 4, 2, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
        figure.coverage = {6, 9};
        figure.evaluated = 18;
        QImage image = blank();
        QPainter painter(&image);
        drawHistogramBars(painter, QRectF(0, 0, 200, 20), figure, Medium::paper, 2);
        painter.end();
        QCOMPARE(inkedColumns(image), 50 + 2);      // five intervals of ten columns, and the line at 18
        QVERIFY(image.pixel(75, 1) != background);  // the highest reaches the top
        QVERIFY(image.pixel(55, 10) == background); // a quarter of it does not
        QVERIFY(image.pixel(55, 18) != image.pixel(75, 18)); // outside of the interval paler
    }

    void screensShowTheSame() {
        const Figure figure = figureOf(u"histogram"_s, Language::Id::english);
        for (const Medium medium : {Medium::screenLight, Medium::screenDark}) {
            QImage image(400, 220, QImage::Format_RGB32);
            QPainter painter(&image);
            const FigureTransform drawn = drawFigure(painter, QRectF(0, 0, 400, 220), figure, medium);
            painter.end();
            const auto &shown = std::get<HistogramFigure>(figure);
            QVERIFY(drawn.plotArea.contains(drawn.map(shown.mean, 0).x(), drawn.plotArea.center().y()));
            QCOMPARE(image.pixelColor(1, 1), figureColor(FigureRole::background, medium));
        }
    }
};

QTEST_MAIN(DrawUncertainty)
#include "drawuncertainty.moc"
