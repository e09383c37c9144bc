// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/figures/drawkinds.h"

#include "figures/thinning.h"
#include "print/figures/bandoverlap.h"
#include "print/figures/clip.h"
#include "print/figures/plotframe.h"

#include <QMarginsF>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

namespace palmer {

namespace {

// Dimensions on the printed page (report), in points.
constexpr double gutterWidth = 26 * mm;
constexpr double narrowGutter = 8 * mm; ///< for a single dimension
constexpr double gutterStart = 2.4 * mm;
constexpr double gutterStep = 6.1 * mm;
constexpr double besideTarget = 3.3 * mm;
constexpr double besideStep = 3.6 * mm;
constexpr double leaderGap = 1.3 * mm;       ///< from the ruling point
constexpr double leaderOvershoot = 0.9 * mm; ///< past the dimension
constexpr double curveArrowLength = 0.95 * mm;
constexpr double curveArrowWidth = 0.76 * mm;
constexpr double curveGuardWidth = 1.56 * mm;
constexpr double curveLimitTick = 3.1 * mm;
constexpr double limitStroke = 0.32 * mm;
constexpr double triangleWidth = 1.9 * mm;
constexpr double diamondWidth = 2.0 * mm;
constexpr double dotRadius = 0.36 * mm;
constexpr double squareWidth = 0.56 * mm;
constexpr double readingShift = 1.15 * mm;
constexpr double whiskerCap = 0.8 * mm;   ///< half
constexpr double sizeOfShapes = 0.6;      ///< fraction of the full size; readings below it are drawn as dots
constexpr std::size_t fewReadings = 2000; ///< up to this many are separate objects in a file
constexpr double markerGap = 0.7 * mm;    ///< between markers of a curve
constexpr double pixel = 0.75;            ///< of a screen
constexpr double densePitch = 4 * pixel;  ///< targets closer than this are drawn without corners
constexpr double numberGap = 1.6 * mm;    ///< between axis numbers
constexpr double readingsSampleWidth = 2.8 * mm;
constexpr double letterHeight = figureTextSize + 2; ///< of a letter or number of a dimension

/// Room around the plot, points.
constexpr QMarginsF paperMargins{13.5 * mm, 1.2 * mm, gutterWidth, 16.5 * mm};
constexpr QMarginsF screenMargins{35, 6, 9, 31};
/// Screens narrower than this (points) show no dimensions next to the plot.
constexpr double widthForDimensions = 480;

class CurveFigurePainter {
public:
    CurveFigurePainter(QPainter &painter, const QRectF &area, const CurveFigure &figure, Medium medium)
        : p(painter)
        , m_figure(figure)
        , m_medium(medium)
        , m_area(area)
        , m_measures(medium == Medium::paper ? curveOnPaper : curveOnScreen)
        , m_frame(frameIn(area))
        , m_plot(m_frame.plot()) {}

    FigureTransform draw() {
        if (!m_frame.begin())
            return {};
        drawBands();
        drawGrid();
        drawReadings();
        m_frame.inside([&] { drawCurves(); });
        drawWhiskers();
        drawMarkers();
        if (m_dimensions)
            drawDimensions();
        drawAxes();
        drawLegend();
        return m_frame.transform(shiftOfReadings());
    }

private:
    /// Decides whether there is room for dimensions.
    [[nodiscard]] PlotFrame frameIn(const QRectF &area) {
        const QMarginsF &margins = m_medium == Medium::paper ? paperMargins : screenMargins;
        // A single dimension, as in a drift test, needs little room.
        const bool single = m_medium != Medium::paper && m_figure.dimensions.size() == 1 &&
                            m_figure.dimensions[0].place == DimensionPlace::gutter;
        m_dimensions = m_medium == Medium::paper || single ||
                       (area.width() >= widthForDimensions && !m_figure.dimensions.empty());
        const double left =
            std::max(margins.left(), widthOfNumbers(m_figure.y, m_measures, titleCentre + figureTextSize));
        const double right = single ? narrowGutter : m_dimensions ? gutterWidth : margins.right();
        const QRectF plot(area.left() + left, area.top() + margins.top(), area.width() - left - right,
                          area.height() - margins.top() - margins.bottom());
        return {p,
                area,
                plot,
                withFittingTicks(m_figure.x, plot.width(), true),
                withFittingTicks(m_figure.y, plot.height(), false),
                m_medium,
                m_measures};
    }

    [[nodiscard]] double x(double value) const { return m_frame.x(value); }
    [[nodiscard]] double y(double value) const { return m_frame.y(value); }
    [[nodiscard]] bool shows(double valueX, double valueY) const { return m_frame.shows({valueX, valueY}); }
    [[nodiscard]] QPen pen(FigureRole role) const { return m_frame.pen(role); }
    [[nodiscard]] QColor colour(FigureRole role) const { return m_frame.colour(role); }

    /// Smallest distance between neighbouring targets.
    [[nodiscard]] double pitch() const {
        double least = m_plot.width();
        for (std::size_t i = 1; i < m_figure.positions.size(); ++i)
            least = std::min(least, x(m_figure.positions[i]) - x(m_figure.positions[i - 1]));
        return least;
    }
    [[nodiscard]] bool isDense() const { return m_medium != Medium::paper && pitch() < densePitch; }
    /// Between dense targets the marks move closer.
    [[nodiscard]] double shiftOfReadings() const { return std::min(readingShift, 0.3 * pitch()); }

    /// Keeps the ticks whose labels fit: all, or every second, fifth, tenth … counted from zero.
    [[nodiscard]] static FigureAxis withFittingTicks(FigureAxis axis, double length, bool horizontal) {
        double need = 1.5 * figureTextSize;
        if (horizontal) {
            need = 0;
            for (const Tick &tick : axis.ticks)
                need = std::max(need, textWidth(tick.label));
            need += numberGap;
        }
        const double distance = length * axis.step / (axis.to - axis.from);
        long long stride = 1;
        for (int k = 0; static_cast<double>(stride) * distance < need && k < 12; ++k)
            stride = k % 3 == 0 ? stride * 2 : k % 3 == 1 ? stride / 2 * 5 : stride * 2;
        std::erase_if(axis.ticks,
                      [&](const Tick &tick) { return std::llround(tick.value / axis.step) % stride != 0; });
        return axis;
    }

    void drawBand(const std::vector<BandPoint> &band, const QColor &fill) {
        p.setBrush(fill);
        p.drawPolygon(m_frame.outline(band));
    }

    void drawBands() {
        m_frame.inside([&] {
            p.setPen(Qt::NoPen);
            if (isDense())
                return drawBandColumns();
            for (const Band &band : m_figure.bands)
                drawBand(band.points,
                         bandColor(band.role == CurveRole::up, band.role == CurveRole::down, m_medium));
            drawOverlaps();
        });
    }

    /// On a screen with hundreds of targets the outlines of the bands would take most of a frame: each pixel
    /// column gets the height of the band at its middle.
    void drawBandColumns() {
        p.setRenderHint(QPainter::Antialiasing, false);
        const QList<QRectF> up = columnsOf(CurveRole::up);
        const QList<QRectF> down = columnsOf(CurveRole::down);
        QList<QRectF> both;
        both.reserve(up.size());
        for (qsizetype i = 0; i < up.size(); ++i)
            both.append(up[i] & down[i]);
        p.setBrush(bandColor(true, false, m_medium));
        p.drawRects(up);
        p.setBrush(bandColor(false, true, m_medium));
        p.drawRects(down);
        p.setBrush(bandColor(true, true, m_medium));
        p.drawRects(both);
        p.setRenderHint(QPainter::Antialiasing);
    }

    /// One rectangle per pixel column, empty where there is no band.
    [[nodiscard]] QList<QRectF> columnsOf(CurveRole role) const {
        QList<QRectF> columns(static_cast<qsizetype>(m_plot.width() / pixel) + 1);
        const auto middle = [&](qsizetype i) {
            return m_plot.left() + (static_cast<double>(i) + 0.5) * pixel;
        };
        const auto firstFrom = [&](double at) { // first column with its middle at or after `at`
            const double place = std::ceil((at - middle(0)) / pixel);
            return static_cast<qsizetype>(std::clamp(place, 0.0, static_cast<double>(columns.size())));
        };
        for (const Band &band : m_figure.bands) {
            if (band.role != role)
                continue;
            for (std::size_t k = 1; k < band.points.size(); ++k) {
                const BandPoint &a = band.points[k - 1];
                const BandPoint &b = band.points[k];
                const double width = x(b.x) - x(a.x);
                const qsizetype end = firstFrom(x(b.x));
                for (qsizetype i = firstFrom(x(a.x)); i < end; ++i) {
                    const double part = (middle(i) - x(a.x)) / width;
                    const double top = y(std::lerp(a.upper, b.upper, part));
                    const double bottom = y(std::lerp(a.lower, b.lower, part));
                    columns[i] = {middle(i) - pixel / 2, top, pixel, bottom - top};
                }
            }
        }
        return columns;
    }

    /// The bands of a direction are ordered and disjoint, so each intersecting pair is visited once.
    void drawOverlaps() {
        const auto bandsOf = [&](CurveRole role) {
            std::vector<const Band *> bands;
            for (const Band &band : m_figure.bands) {
                if (band.role == role && band.points.size() > 1)
                    bands.push_back(&band);
            }
            return bands;
        };
        const std::vector<const Band *> ups = bandsOf(CurveRole::up);
        const std::vector<const Band *> downs = bandsOf(CurveRole::down);
        for (std::size_t i = 0, k = 0; i < ups.size() && k < downs.size();) {
            for (const auto &overlap : bandOverlap(ups[i]->points, downs[k]->points))
                drawBand(overlap, bandColor(true, true, m_medium));
            ups[i]->points.back().x < downs[k]->points.back().x ? ++i : ++k;
        }
    }

    /// Draws the part of a line within the x range, including the segments that cross its ends.
    template <class Point>
    void drawLine(const std::vector<Point> &points, double Point::*value, const QPen &line) {
        if (points.size() < 2) // a whisker, or only a marker
            return;
        const auto before = [&](const Point &point) { return point.x < m_figure.x.from; };
        const auto within = [&](const Point &point) { return point.x <= m_figure.x.to; };
        auto first = std::ranges::partition_point(points, before);
        auto last = std::ranges::partition_point(points, within);
        first -= first == points.begin() ? 0 : 1;
        last += last == points.end() ? 0 : 1;
        QPolygonF corners;
        corners.reserve(last - first);
        for (; first < last; ++first)
            corners.append({x(first->x), y((*first).*value)});
        p.setPen(line);
        p.drawPolyline(corners);
    }

    void drawCurves() {
        p.setBrush(Qt::NoBrush);
        const double widest = isDense() ? pixel : mm; // wider lines would hide each other's corners
        const auto lineOf = [&](FigureRole role) {
            QPen line = pen(role);
            line.setWidthF(std::min(line.widthF(), widest));
            return line;
        };
        for (const Band &band : m_figure.bands) {
            if (band.role == CurveRole::mean)
                continue; // wide enough to be seen without
            const QPen edge =
                lineOf(band.role == CurveRole::down ? FigureRole::downEdge : FigureRole::upEdge);
            drawLine(band.points, &BandPoint::upper, edge);
            drawLine(band.points, &BandPoint::lower, edge);
        }
        for (const auto &[role, line] : {std::pair{CurveRole::mean, FigureRole::mean},
                                         {CurveRole::drift, FigureRole::drift},
                                         {CurveRole::down, FigureRole::down},
                                         {CurveRole::up, FigureRole::up}}) {
            for (const Curve &curve : m_figure.curves) {
                if (curve.role == role)
                    drawLine(curve.points, &FigurePoint::y, lineOf(line));
            }
        }
    }

    /// Makes axis-parallel lines fill whole pixels on a screen.
    void sharpenLines(bool sharp) {
        p.setRenderHint(QPainter::Antialiasing, !sharp || m_medium == Medium::paper);
    }

    void drawGrid() {
        sharpenLines(true);
        if (m_medium != Medium::paper)
            m_frame.drawVerticalGrid();
        m_frame.drawHorizontalGrid();
        sharpenLines(false);
    }

    void drawAxes() {
        sharpenLines(true);
        p.setPen(m_frame.axisPen(Qt::SquareCap));
        m_frame.drawEdges();
        const QPen axis = m_frame.axisPen(Qt::FlatCap);
        m_frame.drawX(axis, AxisParts::ticks);
        m_frame.drawY(axis, AxisParts::ticks);
        sharpenLines(false);
        m_frame.drawX(axis, AxisParts::numbers);
        m_frame.drawY(axis, AxisParts::numbers);
        if (m_measures.title > 0) {
            m_frame.drawXTitle(axisTitle(m_figure.x));
        } else {
            drawText(
                p, {m_area.left() + titleCentre - figureTextSize / 2.0, m_plot.bottom() + m_measures.numbers},
                axisTitle(m_figure.x, {}, QLatin1Char(' ') + m_figure.x.unit), colour(FigureRole::text));
        }
        TextLine title = axisTitle(m_figure.y);
        if (textWidth(title) > m_plot.height())
            title = axisTitle(m_figure.y, {}, QStringLiteral(" (") + m_figure.y.unit + QLatin1Char(')'));
        m_frame.drawYTitle(title);
    }

    void drawWhiskers() {
        for (const Band &band : m_figure.bands) {
            if (band.points.size() != 1 || band.points[0].x < m_figure.x.from ||
                band.points[0].x > m_figure.x.to)
                continue;
            const BandPoint &point = band.points[0];
            // Side by side, so that the whiskers of both directions do not hide each other.
            const double at = x(point.x) + (band.role == CurveRole::up ? -0.5 : 0.5) * mm;
            m_frame.inside([&] {
                p.setPen(pen(band.role == CurveRole::up ? FigureRole::upEdge : FigureRole::downEdge));
                p.drawLine(QPointF(at, y(point.lower)), QPointF(at, y(point.upper)));
                for (const double limit : {point.lower, point.upper})
                    p.drawLine(QPointF(at - whiskerCap, y(limit)), QPointF(at + whiskerCap, y(limit)));
            });
        }
    }

    /// Dense readings are smaller and paler, so that the curves above them stay prominent.
    void drawReadings() {
        const double shift = shiftOfReadings();
        const double size = std::clamp(pitch() / (6 * dotRadius), 0.5, 1.0);
        if (size < sizeOfShapes && m_figure.readings.size() > fewReadings) {
            drawManyReadings(shift, size);
            return;
        }
        for (const CurveRole role : {CurveRole::up, CurveRole::down}) {
            beginReadings(role, size);
            for (const ReadingMark &reading : m_figure.readings) {
                if (reading.role == role && shows(reading.x, reading.y))
                    drawReading({x(reading.x) + (role == CurveRole::up ? -shift : shift), y(reading.y)}, role,
                                size);
            }
        }
    }

    /// Thousands of readings in two fill operations.
    void drawManyReadings(double shift, double size) {
        for (const CurveRole role : {CurveRole::up, CurveRole::down}) {
            QPainterPath dots;
            dots.setFillRule(Qt::WindingFill);
            for (const ReadingMark &reading : m_figure.readings) {
                if (reading.role == role && shows(reading.x, reading.y))
                    dots.addRect(
                        dot({x(reading.x) + (role == CurveRole::up ? -shift : shift), y(reading.y)}, size));
            }
            p.fillPath(dots, colourOfDots(role, size));
        }
    }

    [[nodiscard]] static QRectF dot(QPointF at, double size) {
        const double half = 0.9 * dotRadius * size;
        return {at - QPointF(half, half), at + QPointF(half, half)};
    }
    [[nodiscard]] static double strengthOf(double size) {
        return 0.4 + 1.2 * (size - 0.5);
    } ///< 1 at full size
    [[nodiscard]] QColor colourOfDots(CurveRole role, double size) const {
        return paler(colour(role == CurveRole::up ? FigureRole::up : FigureRole::down), strengthOf(size));
    }

    /// Sets pen and brush for the readings of a direction, once for all of them.
    void beginReadings(CurveRole role, double size) {
        if (role == CurveRole::up) {
            p.setPen(QPen(colourOfDots(role, size), 2 * dotRadius * size, Qt::SolidLine, Qt::RoundCap));
        } else {
            QPen outline = pen(FigureRole::reading);
            outline.setColor(paler(outline.color(), strengthOf(size)));
            p.setPen(outline);
            p.setBrush(colour(FigureRole::background));
        }
    }

    void drawReading(QPointF at, CurveRole role, double size) {
        if (size < sizeOfShapes) { // too small for a shape
            p.fillRect(dot(at, size), colourOfDots(role, size));
        } else if (role == CurveRole::up) {
            p.drawPoint(at); // in a PDF a sixth of the bytes of a circle
        } else {
            const double half = squareWidth * size / 2;
            p.drawRect(QRectF(at - QPointF(half, half), at + QPointF(half, half)));
        }
    }

    [[nodiscard]] QColor paler(const QColor &strong, double strength) const {
        return blend(strong, colour(FigureRole::background), strength);
    }

    /// Draws markers at distinguishable distances: for every target, every second, third …
    void drawMarkers() {
        const double distance = pitch();
        const int stride = std::max(1, static_cast<int>(std::ceil((diamondWidth + markerGap) / distance)));
        // ▲ last: at the same point the corners of ◇ remain visible.
        for (const CurveRole role : {CurveRole::down, CurveRole::up}) {
            const int phase = role == CurveRole::up ? 0 : stride / 2; // dense curves alternate
            for (const Curve &curve : m_figure.curves) {
                if (curve.role == role)
                    drawMarkers(curve, stride, phase);
            }
        }
        for (const Curve &curve : m_figure.curves) {
            if (curve.role == CurveRole::mean && curve.points.size() == 1 &&
                shows(curve.points[0].x, curve.points[0].y)) {
                const QPointF at(x(curve.points[0].x), y(curve.points[0].y));
                p.setPen(QPen(colour(FigureRole::mean), pen(FigureRole::mean).widthF()));
                p.drawLine(at - QPointF(diamondWidth, 0), at + QPointF(diamondWidth, 0));
            }
        }
    }

    void drawMarkers(const Curve &curve, int stride, int phase) {
        const bool lonely = curve.points.size() == 1;
        int last = -1; // last stride with a marker
        for (const FigurePoint &point : curve.points) {
            // If a thinned curve lacks the target of a stride, the next target gets its marker.
            const int turn = point.target - 1 < phase ? -1 : (point.target - 1 - phase) / stride;
            const bool misses = &point != &curve.points.front() && (&point)[-1].target + 1 < point.target;
            const bool exact = turn >= 0 && (point.target - 1 - phase) % stride == 0;
            if (!lonely && !exact && !(misses && turn > last))
                continue;
            last = turn;
            if (shows(point.x, point.y))
                drawMarker({x(point.x), y(point.y)}, curve.role);
        }
    }

    void drawMarker(QPointF at, CurveRole role) {
        if (role == CurveRole::up) {
            const double height = triangleWidth * std::sqrt(3.0) / 2;
            const QPolygonF triangle{at + QPointF(-triangleWidth / 2, height / 3),
                                     at + QPointF(triangleWidth / 2, height / 3),
                                     at + QPointF(0, -2 * height / 3)};
            p.setPen(pen(FigureRole::upMarker));
            p.setBrush(colour(FigureRole::up));
            p.drawPolygon(triangle);
        } else {
            const double half = diamondWidth / 2;
            const QPolygonF diamond{at + QPointF(-half, 0), at + QPointF(0, -half), at + QPointF(half, 0),
                                    at + QPointF(0, half)};
            p.setPen(pen(FigureRole::downMarker));
            p.setBrush(colour(FigureRole::background));
            p.drawPolygon(diamond);
        }
    }

    /// A dimension with the place of its line.
    struct PlacedDimension {
        const Dimension &dimension;
        double at = 0;
        double towards = 1; ///< −1: left of its target

        [[nodiscard]] bool inGutter() const { return dimension.place == DimensionPlace::gutter; }
    };

    /// Lines and limits first, because letters and numbers avoid them.
    void drawDimensions() {
        int slot = 0;
        std::vector<PlacedDimension> placed;
        for (const Dimension &dimension : m_figure.dimensions) {
            if (!shows(dimension.lowerPosition, dimension.lower) ||
                !shows(dimension.upperPosition, dimension.upper)) {
                continue; // outside the zoomed range
            }
            PlacedDimension each{dimension, m_plot.right() + gutterStart + slot * gutterStep};
            if (each.inGutter()) {
                ++slot;
            } else {
                each.towards = dimension.place == DimensionPlace::rightOfTarget ? 1 : -1;
                each.at = x(dimension.upperPosition) +
                          each.towards * (besideTarget + earlier(dimension) * besideStep);
            }
            placed.push_back(each);
            p.setPen(pen(FigureRole::leader));
            const double end = each.at + each.towards * leaderOvershoot;
            p.drawLine(QPointF(x(dimension.upperPosition) + each.towards * leaderGap, y(dimension.upper)),
                       QPointF(end, y(dimension.upper)));
            p.drawLine(QPointF(x(dimension.lowerPosition) + each.towards * leaderGap, y(dimension.lower)),
                       QPointF(end, y(dimension.lower)));
        }
        for (const PlacedDimension &each : placed) {
            const double top = y(each.dimension.upper);
            m_lines.emplace_back(each.at - curveArrowWidth / 2, top, curveArrowWidth,
                                 y(each.dimension.lower) - top);
            drawLimit(each.at, each.dimension);
        }
        for (const PlacedDimension &each : placed)
            drawDimension(each);
        for (const PlacedDimension &each : placed)
            drawLimitNumber(each);
    }

    /// Number of earlier dimensions on the same side of the same target.
    [[nodiscard]] double earlier(const Dimension &dimension) const {
        return static_cast<double>(
            std::count_if(m_figure.dimensions.data(), &dimension, [&](const Dimension &other) {
                return other.place == dimension.place && other.upperPosition == dimension.upperPosition;
            }));
    }

    [[nodiscard]] bool showsLimit(const Dimension &dimension) const {
        return dimension.limit && shows(dimension.upperPosition, dimension.lower + *dimension.limit);
    }

    /// Draws the limit as a tick at its distance from the lower value, in its guard band.
    void drawLimit(double at, const Dimension &dimension) {
        if (!showsLimit(dimension))
            return;
        const double limit = dimension.lower + *dimension.limit;
        const double guard = dimension.guard.value_or(0);
        const double top = std::max(y(limit + guard), m_plot.top());
        const double bottom = std::min(y(limit - guard), m_plot.bottom());
        if (dimension.guard)
            drawGuard(QRectF(at - curveGuardWidth / 2, top, curveGuardWidth, bottom - top));
        QPen tick = pen(FigureRole::dimension);
        tick.setCapStyle(Qt::FlatCap);
        p.setPen(tick);
        if (limit > dimension.upper) // connects the tick with its arrow
            p.drawLine(QPointF(at, y(dimension.upper)), QPointF(at, y(limit)));
        tick.setWidthF(limitStroke);
        p.setPen(tick);
        p.drawLine(QPointF(at - curveLimitTick / 2, y(limit)), QPointF(at + curveLimitTick / 2, y(limit)));
        constexpr double clear = 1; // points
        m_taken.emplace_back(at - curveLimitTick / 2, std::min(top, y(limit)) - clear, curveLimitTick,
                             std::max(bottom - top, 0.0) + 2 * clear);
    }

    /// Writes the limit beside its tick, or above or below it.
    void drawLimitNumber(const PlacedDimension &placed) {
        const Dimension &dimension = placed.dimension;
        if (!showsLimit(dimension))
            return;
        constexpr double gap = 0.5 * mm;
        const double limit = dimension.lower + *dimension.limit;
        const double guard = dimension.guard.value_or(0);
        const double width = textWidth(dimension.limitText);
        const double beside = curveLimitTick / 2 + gap + width / 2;
        const double above = std::max(y(limit + guard), m_plot.top()) - gap - letterHeight / 2;
        const double below = std::min(y(limit - guard), m_plot.bottom()) + gap + letterHeight / 2;
        const auto boxAt = [&](QPointF middle) {
            return QRectF(middle - QPointF(width / 2 + 1, letterHeight / 2), QSizeF(width + 2, letterHeight));
        };
        std::vector<QPointF> places{QPointF(placed.at + placed.towards * beside, y(limit)),
                                    QPointF(placed.at - placed.towards * beside, y(limit)),
                                    QPointF(placed.at, above), QPointF(placed.at, below)};
        for (const double away : {1.0, 2.0, 3.0}) {
            for (const double side : {1.0, -1.0}) {
                places.emplace_back(placed.at + side * beside, y(limit) - away * letterHeight);
                places.emplace_back(placed.at + side * beside, y(limit) + away * letterHeight);
            }
            places.emplace_back(placed.at, below + away * letterHeight); // below the letter
        }
        const auto faults = [&](QPointF middle) { // the worst first
            const QRectF box = boxAt(middle);
            return 4 * int(!m_area.contains(box) || hits(m_taken, box)) + 2 * int(hits(m_lines, box)) +
                   int(hitsCurve(box));
        };
        const QRectF box = boxAt(*std::ranges::min_element(places, {}, faults));
        m_taken.push_back(box);
        p.fillRect(box, colour(FigureRole::background));
        drawText(p, {box.left() + 1, box.center().y()}, dimension.limitText, colour(FigureRole::text));
    }

    [[nodiscard]] static bool hits(const std::vector<QRectF> &others, const QRectF &box) {
        return std::ranges::any_of(others, [&](const QRectF &other) { return other.intersects(box); });
    }

    /// True if a curve crosses the box.
    [[nodiscard]] bool hitsCurve(const QRectF &box) const {
        for (const Curve &curve : m_figure.curves) {
            for (std::size_t i = 0; i < curve.points.size(); ++i) {
                const FigurePoint &b = curve.points[i];
                const FigurePoint &a = curve.points[i == 0 ? 0 : i - 1];
                QPointF from = m_frame.at({a.x, a.y});
                QPointF to = m_frame.at({b.x, b.y});
                if (clip(from, to, box))
                    return true;
            }
        }
        return false;
    }

    /// Middle of a letter: on the line of its dimension, or above or below it, free of limits and curves.
    [[nodiscard]] double placeOfLetter(const PlacedDimension &placed, double width, double top,
                                       double bottom) const {
        const double at = placed.at;
        const double outside = (areArrowsInside(top, bottom) ? 0 : 2.5 * curveArrowLength);
        std::vector<double> places;
        if (bottom - top >= letterHeight + 3 * curveArrowLength) {
            const double first = top + curveArrowLength + letterHeight / 2;
            const double last = bottom - curveArrowLength - letterHeight / 2;
            for (const double part : {0.5, 0.25, 0.75, 0.0, 1.0})
                places.push_back(first + part * (last - first));
        }
        for (const double away : {0.5, 1.2, 2.0, 3.0}) {
            places.push_back(top - outside - away * letterHeight);
            places.push_back(bottom + outside + away * letterHeight);
        }
        const QRectF &within = placed.inGutter() ? m_area : m_plot;
        const auto isFree = [&](double middle) {
            const QRectF box = boxOfLetter(at, width, middle);
            return within.contains(box) && !hits(m_taken, box) && (placed.inGutter() || !hitsCurve(box));
        };
        const auto found = std::ranges::find_if(places, isFree);
        return found == places.end() ? places.front() : *found;
    }

    [[nodiscard]] static QRectF boxOfLetter(double at, double width, double middle) {
        return {at - width / 2 - 0.7, middle - letterHeight / 2, width + 1.4, letterHeight};
    }

    void drawGuard(const QRectF &band) {
        p.setPen(pen(FigureRole::guardBand));
        p.setBrush(colour(FigureRole::guardFill));
        p.drawRect(band);
    }

    void drawArrow(QPointF tip, double down) {
        const QPolygonF head{tip, tip + QPointF(-curveArrowWidth / 2, down * curveArrowLength),
                             tip + QPointF(curveArrowWidth / 2, down * curveArrowLength)};
        p.setPen(Qt::NoPen);
        p.setBrush(colour(FigureRole::dimension));
        p.drawPolygon(head);
    }

    [[nodiscard]] static bool areArrowsInside(double top, double bottom) {
        return bottom - top >= 2.4 * curveArrowLength;
    }

    /// Arrows inside, with the letter in a gap of the line; if the arrows would meet, they point inwards from
    /// outside.
    void drawDimension(const PlacedDimension &placed) {
        const double at = placed.at;
        const double top = y(placed.dimension.upper);
        const double bottom = y(placed.dimension.lower);
        const bool arrowsInside = areArrowsInside(top, bottom);
        QPen line = pen(FigureRole::dimension);
        line.setCapStyle(Qt::FlatCap);
        p.setPen(line);
        const double outside = arrowsInside ? 0 : 2.5 * curveArrowLength;
        if (arrowsInside) {
            p.drawLine(QPointF(at, top + curveArrowLength / 2), QPointF(at, bottom - curveArrowLength / 2));
        } else {
            p.drawLine(QPointF(at, top - outside), QPointF(at, top - curveArrowLength / 2));
            p.drawLine(QPointF(at, bottom + curveArrowLength / 2), QPointF(at, bottom + outside));
        }
        drawArrow({at, top}, arrowsInside ? 1 : -1);
        drawArrow({at, bottom}, arrowsInside ? -1 : 1);
        const TextLine label{{placed.dimension.label}, {placed.dimension.subscript, true}};
        const double width = textWidth(label, true);
        const double middle = placeOfLetter(placed, width, top, bottom);
        const QRectF box = boxOfLetter(at, width, middle);
        m_taken.push_back(box);
        p.fillRect(box, colour(FigureRole::background));
        drawText(p, {at - width / 2, middle}, label, colour(FigureRole::text), true);
    }

    [[nodiscard]] double sampleWidth(const LegendEntry &entry) const {
        return entry.sample == LegendSample::readings ? readingsSampleWidth
               : entry.sample == LegendSample::limit  ? curveLimitTick
                                                      : m_measures.sampleWidth;
    }

    void drawLegend() {
        std::vector<PlotEntry> entries;
        for (const LegendEntry &entry : m_figure.legend) {
            if (m_dimensions || entry.sample != LegendSample::limit) // limits are drawn with dimensions
                entries.push_back({sampleWidth(entry), entry.text,
                                   [this, &entry](const QRectF &box) { drawSample(box, entry); }});
        }
        const double start =
            m_medium == Medium::paper ? m_plot.left() + 0.03 * m_plot.width() : m_plot.left();
        m_frame.drawLegendRow(entries, m_area.right() - start,
                              m_medium == Medium::paper ? std::optional(start) : std::nullopt);
    }

    void drawSample(const QRectF &box, const LegendEntry &entry) {
        const QPointF middle = box.center();
        const QPointF half(box.width() / 2, 0);
        switch (entry.sample) {
        case LegendSample::readings:
            for (const CurveRole role : {CurveRole::up, CurveRole::down}) {
                const bool shown = std::any_of(m_figure.curves.begin(), m_figure.curves.end(),
                                               [role](const Curve &curve) { return curve.role == role; });
                if (shown)
                    drawReading(middle + (role == CurveRole::up ? -1 : 1) * QPointF(readingShift, 0), role,
                                1);
            }
            return;
        case LegendSample::limit: {
            if (entry.band)
                drawGuard(QRectF(middle.x() - curveGuardWidth / 2, box.top(), curveGuardWidth, box.height()));
            QPen tick = pen(FigureRole::dimension);
            tick.setWidthF(limitStroke);
            tick.setCapStyle(Qt::FlatCap);
            p.setPen(tick);
            p.drawLine(middle - half, middle + half);
            return;
        }
        case LegendSample::drift:
        case LegendSample::mean:
            if (entry.band)
                p.fillRect(box, bandColor(false, false, m_medium));
            p.setPen(pen(entry.sample == LegendSample::drift ? FigureRole::drift : FigureRole::mean));
            p.drawLine(middle - half, middle + half);
            return;
        case LegendSample::up:
        case LegendSample::down:
            break;
        }
        const bool up = entry.sample == LegendSample::up;
        if (entry.band) {
            p.fillRect(box, bandColor(up, !up, m_medium));
            p.setPen(pen(up ? FigureRole::upEdge : FigureRole::downEdge));
            p.drawLine(box.topLeft(), box.topRight());
            p.drawLine(box.bottomLeft(), box.bottomRight());
        }
        QPen line = pen(up ? FigureRole::up : FigureRole::down);
        line.setCapStyle(Qt::FlatCap);
        p.setPen(line);
        p.drawLine(middle - half, middle + half);
        drawMarker(middle, up ? CurveRole::up : CurveRole::down);
    }

    QPainter &p;
    const CurveFigure &m_figure;
    Medium m_medium;
    QRectF m_area;
    const FrameMeasures &m_measures;
    bool m_dimensions = true;
    std::vector<QRectF> m_taken; ///< by limits, letters and numbers of dimensions
    std::vector<QRectF> m_lines; ///< of dimensions
    PlotFrame m_frame;
    const QRectF &m_plot;
};

} // namespace

FigureTransform drawKind(QPainter &painter, const QRectF &area, const CurveFigure &figure, Medium medium) {
    if (isOrdinary(figure))
        return CurveFigurePainter(painter, area, figure, medium).draw();
    return CurveFigurePainter(painter, area, thinned(figure), medium).draw();
}

} // namespace palmer
