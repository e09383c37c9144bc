// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/circlefigure.h"
#include "figures/ticks.h"
#include "print/figures/drawfigure.h"
#include "print/figures/style.h"
#include "ui/circles.h"

#include <QImage>
#include <QPainter>
#include <QTest>
#include <cmath>
#include <numbers>

using namespace palmer;
using namespace palmer::testdata;

namespace {

constexpr double dotsPerMillimetre = 300 / 25.4;

enum class Copier { threshold, dithered };

/// What a copier with two tones makes of a page: darker than the middle is black, or the error of each dot is
/// passed on to its neighbours (Floyd and Steinberg).
QImage copied(const QImage &page, Copier copier) {
    QImage result(page.size(), QImage::Format_Grayscale8);
    std::vector<double> row(static_cast<std::size_t>(page.width()) + 2);
    std::vector<double> next(row.size());
    for (int y = 0; y < page.height(); ++y) {
        for (int x = 0; x < page.width(); ++x) {
            const auto at = static_cast<std::size_t>(x) + 1;
            const double grey = qGray(page.pixel(x, y)) + (copier == Copier::dithered ? row[at] : 0);
            const int tone = grey < 127.5 ? 0 : 255;
            result.scanLine(y)[x] = static_cast<uchar>(tone);
            const double error = grey - tone;
            row[at + 1] += error * 7 / 16;
            next[at - 1] += error * 3 / 16;
            next[at] += error * 5 / 16;
            next[at + 1] += error * 1 / 16;
        }
        row.swap(next);
        std::ranges::fill(next, 0);
    }
    return result;
}

struct Copy {
    QImage image;
    FigureTransform transform;

    /// Share of black among the dots of a square about a place, mm wide.
    [[nodiscard]] double ink(QPointF place, double width) const {
        const QPointF middle = place * dotsPerMillimetre / pointsPerMillimetre;
        const int half = std::max(0, qRound(width * dotsPerMillimetre / 2 - 0.5));
        int black = 0;
        int all = 0;
        for (int y = -half; y <= half; ++y) {
            for (int x = -half; x <= half; ++x) {
                const QPoint at = middle.toPoint() + QPoint(x, y);
                if (!image.valid(at))
                    continue;
                ++all;
                black += qGray(image.pixel(at)) < 128;
            }
        }
        return static_cast<double>(black) / std::max(1, all);
    }
};

Copy copyOf(const Figure &figure, Copier copier) {
    const QSizeF size = paperSize(figure) * pointsPerMillimetre;
    const double scale = dotsPerMillimetre / pointsPerMillimetre;
    QImage page((size * scale).toSize(), QImage::Format_RGB32);
    page.fill(Qt::white);
    QPainter painter(&page);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(scale, scale);
    const FigureTransform transform = drawFigure(painter, {{0, 0}, size}, figure, Medium::paper);
    painter.end();
    return {copied(page, copier), transform};
}

/// Two level curves with nothing near them.
CurveFigure levels() {
    CurveFigure figure;
    const Language language(Language::Id::english);
    setRange(figure.x, 0, 10, 5, TickSteps::lengths, language);
    setRange(figure.y, 0, 10, 10, TickSteps::values, language);
    for (int i = 0; i <= 10; ++i)
        figure.positions.push_back(i);
    for (const auto &[role, y] : {std::pair{CurveRole::up, 2.5}, std::pair{CurveRole::down, 7.5}}) {
        Curve curve{role, {}};
        for (int i = 0; i <= 2; ++i)
            curve.points.push_back({1 + 4.0 * i, y, i + 1});
        figure.curves.push_back(std::move(curve));
    }
    return figure;
}

} // namespace

/// Reports are copied, faxed and scanned with two tones: what colour tells is told by form as well.
class Photocopy : public QObject {
    Q_OBJECT

private slots:
    void directions_data() { addCopiers(); }
    void directions();
    void senses_data() { addCopiers(); }
    void senses();

private:
    static void addCopiers() {
        QTest::addColumn<int>("copier");
        QTest::newRow("threshold") << int(Copier::threshold);
        QTest::newRow("dithered") << int(Copier::dithered);
    }
};

/// ↑ is a whole line with full marks, ↓ a broken one with open marks.
void Photocopy::directions() {
    QFETCH(const int, copier);
    const Copy copy = copyOf(levels(), Copier(copier));
    const auto onCurve = [&](double y) {
        std::vector<double> shares;
        for (double x = 1.5; x < 4.5; x += 0.002)
            shares.push_back(copy.ink(copy.transform.map(x, y), 0.3));
        return shares;
    };
    const auto part = [](const std::vector<double> &shares, auto holds) {
        return static_cast<double>(std::ranges::count_if(shares, holds)) / static_cast<double>(shares.size());
    };
    const auto isInk = [](double share) { return share >= 0.3; };
    const auto isPaper = [](double share) { return share <= 0.05; };
    const std::vector<double> up = onCurve(2.5);
    const std::vector<double> down = onCurve(7.5);
    QVERIFY2(part(up, isInk) > 0.99, qPrintable(QString::number(part(up, isInk)))); // no gap anywhere
    QVERIFY2(part(down, isInk) > 0.5, qPrintable(QString::number(part(down, isInk))));
    QVERIFY2(part(down, isPaper) > 0.15, qPrintable(QString::number(part(down, isPaper)))); // its gaps
    // The mark of the middle target: full or with a light middle.
    QVERIFY(copy.ink(copy.transform.map(5, 2.5), 0.7) > 0.6);
    QVERIFY(copy.ink(copy.transform.map(5, 7.5), 0.7) < 0.5);
    // Both marks are there: ink beside the line, in a ring about the target.
    for (const double y : {2.5, 7.5})
        QVERIFY(copy.ink(copy.transform.map(5, y), 2) > 0.1);
}

/// Clockwise is the wider line, as in figure 4 of ISO 230-4; the other is there all around.
void Photocopy::senses() {
    QFETCH(const int, copier);
    double widths[2] = {};
    for (const Sense sense : {Sense::counterclockwise, Sense::clockwise}) {
        Test test = circularTest({pathOf(sense, 720, [](double) { return 5.0; })});
        circular(test).centring = Centring::instrument; // as read: beside the nominal circle
        CircleFigureOptions options{.limits = false};
        options.subject = CircleSubject::radialDeviation;
        CircleFigure figure =
            circleFigure(test, evaluatedCircular(test), Language(Language::Id::english), options);
        figure.envelope.reset(); // it lies on the path
        const Copy copy = copyOf(figure, Copier(copier));
        double black = 0;
        int rays = 0;
        const double radius = figure.radius(5);
        for (int degrees = 0; degrees < 360; degrees += 2) {
            if (degrees % 30 < 6 || degrees % 30 > 24)
                continue; // spokes, axes, starting point
            ++rays;
            const double angle = degrees * std::numbers::pi / 180;
            const QPointF ray(std::cos(angle), std::sin(angle));
            double across = 0;
            constexpr double step = 0.02;
            for (double r = radius - 0.6; r <= radius + 0.6; r += step)
                across += copy.ink(copy.transform.map(r * ray.x(), r * ray.y()), 0) * step;
            black += across;
            // There at every place: some ink within a millimetre along the path.
            QVERIFY2(copy.ink(copy.transform.map(radius * ray.x(), radius * ray.y()), 1) > 0.1,
                     qPrintable(QStringLiteral("no path at %1°").arg(degrees)));
        }
        widths[sense == Sense::clockwise] = black / rays; // mm of ink across the path
    }
    QVERIFY2(widths[0] > 0.15, qPrintable(QString::number(widths[0])));
    QVERIFY2(widths[1] > 1.3 * widths[0],
             qPrintable(QStringLiteral("%1 against %2").arg(widths[0]).arg(widths[1])));
}

QTEST_MAIN(Photocopy)
#include "photocopy.moc"
