// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/circlefigure.h"

#include "figures/extremes.h"
#include "figures/ticks.h"
#include "kernel/evaluation/iso230_4/circles.h"
#include "kernel/evaluation/iso230_4/paths.h"
#include "kernel/evaluation/resultsof.h"
#include "kernel/numerics/aboutcentre.h"
#include "kernel/numerics/angles.h"
#include "kernel/numerics/centringerror.h"
#include "kernel/numerics/poweroften.h"
#include "language/rounding.h"
#include "system/memory.h"

#include <QRectF>
#include <QStringList>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <string_view>

namespace palmer {

namespace {

constexpr double micrometresPerMillimetre = 1000;
/// Margins for the axes and their letters, mm: at the sides and at the top.
constexpr double sideMargin = 7;
constexpr double topMargin = 3.5;
constexpr double smallestRadius = 8; ///< lower bound of the figure radius, mm

constexpr double innerLimit = 0.15;           ///< fraction of the figure radius; inner bound of the plot
constexpr double nominalCircle = 34.0 / 49.0; ///< fraction of the figure radius
constexpr double worthMoving = 4.999;         ///< least gain in magnification that moves the nominal circle
constexpr int highestDecade = 5;
constexpr int lowestDecade = -6;

constexpr double leastDivision = 0.08; ///< fraction of the figure radius
constexpr std::size_t fewestRings = 4;
constexpr double mostRings = 60; ///< in a view; far more than needed

constexpr double largestLimit = 4;        ///< limits of F above this multiple of the deviations are not drawn
constexpr double contactTolerance = 1e-6; ///< µm
constexpr double contactDistance = 1;     ///< degrees; nearer points count as one contact
constexpr std::size_t mostContacts = 8;

constexpr double keyRow = 4.8; ///< mm
constexpr double keyGap = 1;
constexpr double threeColumns = 105; ///< least width for three columns, mm

/// A test and what the figure shows of it.
struct CircleSource {
    const CircularMeasurement &measurement;
    const CircularResults &results;
    const TestEvaluation &evaluation;
    const CircleFigureOptions &options;

    CircleSource(const Test &test, const TestEvaluation &testEvaluation,
                 const CircleFigureOptions &figureOptions)
        : measurement(std::get<CircularMeasurement>(test.measurement))
        , results(resultsOf(measurement, testEvaluation))
        , evaluation(testEvaluation)
        , options(figureOptions) {}

    [[nodiscard]] bool radial() const { return options.subject == CircleSubject::radialDeviation; }
    [[nodiscard]] bool aboutSetUp() const { return radial() && measurement.centring == Centring::instrument; }

    /// Path or pair the figure shows; a single sense is not a pair.
    [[nodiscard]] CircleOf of() const {
        if (options.of != CircleOf::both || results.paths.empty())
            return options.of;
        const bool alone = results.paths.size() == 1 || (radial() && !aboutSetUp());
        return alone ? iso230_4::circleOf(results.paths.front().sense) : CircleOf::both;
    }

    [[nodiscard]] bool shows(Sense sense) const {
        return of() == CircleOf::both || of() == iso230_4::circleOf(sense);
    }

    /// Circle about whose centre the figure is drawn; null: the programmed centre.
    [[nodiscard]] const CircleResult *circle() const {
        if (aboutSetUp())
            return nullptr;
        return results.circle(of(), radial() ? ReferenceCircle::leastSquares : measurement.referenceCircle);
    }

    [[nodiscard]] std::string index() const {
        for (const EvaluatedPath &path : results.paths) {
            if (shows(path.sense))
                return path.index; // a pair uses the index of the path measured first
        }
        return {};
    }

    [[nodiscard]] const Parameter *parameter(std::string_view id) const {
        const auto found = std::ranges::find_if(
            evaluation.parameters, [&](const Parameter &p) { return id == p.term.id && p.index == index(); });
        return found == evaluation.parameters.end() ? nullptr : &*found;
    }

    /// G or G(b); that of the feedback signal if only this was measured.
    [[nodiscard]] const Parameter *circularDeviation() const {
        const bool pair = of() == CircleOf::both;
        const Parameter *external = parameter(pair ? "G(b)" : "G");
        return external ? external : parameter(pair ? "G(b)f" : "Gf");
    }
};

PathProfile profile(const Arc &arc, const std::vector<std::size_t> &source, PointsView points, Point centre,
                    double nominalRadius) {
    PathProfile result;
    result.sense = arc.sense;
    result.sampleInterval = arc.sampleInterval;
    const auto reserve = [&](auto &values) { // 10⁶ points: 6.5 ms instead of 10
        values.reserve(source.size());
        useHugePages(values.data(), source.size() * sizeof values.front());
    };
    reserve(result.angles);
    reserve(result.deviations);
    result.source = source;
    // Blocks that fit into the L1 cache; for 10⁶ points every further pass costs milliseconds.
    constexpr std::size_t few = 512;
    std::array<double, few> angles{};
    std::array<double, few> deviations{};
    for (std::size_t begin = 0; begin < source.size(); begin += few) {
        const std::size_t size = std::min(few, source.size() - begin);
        aboutCentre({points.x.subspan(begin, size), points.y.subspan(begin, size)}, centre,
                    std::span(angles).first(size), std::span(deviations).first(size));
        for (std::size_t i = 0; i < size; ++i) {
            angles[i] += arc.angles[source[begin + i]];
            deviations[i] = (deviations[i] - nominalRadius) * micrometresPerMillimetre;
        }
        result.angles.insert(result.angles.end(), angles.data(), angles.data() + size);
        result.deviations.insert(result.deviations.end(), deviations.data(), deviations.data() + size);
    }
    return result;
}

/// As it was read: about the centre of the set-up.
PathProfile profileAsRead(const Arc &arc, const std::vector<std::size_t> &source) {
    PathProfile result;
    result.sense = arc.sense;
    result.sampleInterval = arc.sampleInterval;
    result.source = source;
    for (const std::size_t i : source) {
        result.angles.push_back(arc.angles[i]);
        result.deviations.push_back(arc.radialDeviations[i] * micrometresPerMillimetre);
    }
    return result;
}

std::vector<std::size_t> allIndices(std::size_t size) {
    std::vector<std::size_t> result(size);
    std::iota(result.begin(), result.end(), std::size_t(0));
    return result;
}

std::vector<std::size_t> evaluatedPoints(const Arc &arc) {
    std::vector<std::size_t> result;
    const auto range = iso230_4::evaluatedRange(arc);
    for (std::size_t i = 0; range && i < arc.angles.size(); ++i) {
        if (arc.angles[i] >= range->from && arc.angles[i] <= range->to)
            result.push_back(i);
    }
    return result;
}

/// The points of a further arc as those of the evaluated ones are made.
Points pointsOf(const Arc &arc, const std::vector<std::size_t> &source, const CircleSource &from) {
    std::vector<double> angles;
    std::vector<double> distances;
    for (const std::size_t i : source) {
        angles.push_back(arc.angles[i]);
        distances.push_back(from.measurement.nominalRadius + arc.radialDeviations[i]);
    }
    return arc.angleReference == AngleReference::commanded && from.results.centringError
               ? rebuildPoints({angles, distances}, *from.results.centringError)
               : polarPoints(angles, distances);
}

/// Each to its index.
void put(const Points &points, const std::vector<std::size_t> &source, Points &all) {
    for (std::size_t place = 0; place < source.size(); ++place) {
        all.x[source[place]] = points.x[place];
        all.y[source[place]] = points.y[place];
    }
}

/// All points of an arc. Evaluated points are copied, which saves a sine and a cosine each.
Points allPoints(const Arc &arc, std::size_t index, const CircleSource &from) {
    Points result;
    result.x.resize(arc.angles.size());
    result.y.resize(arc.angles.size());
    const auto path = std::ranges::find(from.results.paths, index, &EvaluatedPath::arc);
    std::vector<std::size_t> others;
    std::size_t next = 0; // behind the evaluated ones
    const auto leaveUpTo = [&](std::size_t end) {
        for (; next < end; ++next)
            others.push_back(next);
    };
    if (path != from.results.paths.end()) {
        for (const std::size_t evaluated : path->source) {
            leaveUpTo(evaluated);
            ++next;
        }
        put(path->points, path->source, result);
    }
    leaveUpTo(arc.angles.size());
    put(pointsOf(arc, others, from), others, result);
    return result;
}

bool isOrdered(const std::vector<double> &angles) {
    return std::ranges::is_sorted(angles) || std::ranges::is_sorted(angles, std::greater<>());
}

void finish(PathProfile &profile, const CircleSource &source, std::size_t arc) {
    profile.arc = arc;
    profile.index = iso230_4::axisIndex(source.measurement.plane, profile.sense);
    const double correction =
        source.radial() ? source.results.correction.value_or(0) * micrometresPerMillimetre : 0;
    if (correction != 0) {
        for (double &deviation : profile.deviations)
            deviation += correction;
    }
    profile.ordered = isOrdered(profile.angles);
}

std::vector<PathProfile> profilesOf(const CircleSource &source) {
    const CircularMeasurement &measurement = source.measurement;
    const CircleResult *circle = source.circle();
    const Point centre = circle ? circle->centre : Point{};
    std::vector<PathProfile> result;
    for (const EvaluatedPath &path : source.results.paths) {
        if (!source.shows(path.sense) || path.source.empty())
            continue;
        const Arc &arc = measurement.arcs[path.arc];
        result.push_back(source.aboutSetUp() ? profileAsRead(arc, path.source)
                                             : profile(arc, path.source, path.points.view(), centre,
                                                       measurement.nominalRadius));
        finish(result.back(), source, path.arc);
    }
    if (!source.options.repetitions)
        return result;
    for (const std::size_t k : source.results.repetitions) {
        const Arc &arc = measurement.arcs[k];
        const std::vector<std::size_t> points = evaluatedPoints(arc);
        if (!source.shows(arc.sense) || points.empty())
            continue;
        result.push_back(source.aboutSetUp() ? profileAsRead(arc, points)
                                             : profile(arc, points, pointsOf(arc, points, source).view(),
                                                       centre, measurement.nominalRadius));
        result.back().repetition = true;
        finish(result.back(), source, k);
    }
    return result;
}

void include(Interval &range, double value) {
    range.from = std::min(range.from, value);
    range.to = std::max(range.to, value);
}

/// Sector of the circle that the paths cover; null if it exceeds three quarters of the circle.
std::optional<Interval> sectorOf(std::span<const PathProfile> profiles) {
    std::optional<Interval> sector;
    for (const PathProfile &profile : profiles) {
        if (profile.angles.empty())
            continue;
        const Interval angles = extremesOf(profile.angles);
        sector =
            sector ? Interval{std::min(sector->from, angles.from), std::max(sector->to, angles.to)} : angles;
    }
    constexpr double mostOfCircle = 270;
    return sector && sector->to - sector->from <= mostOfCircle ? sector : std::nullopt;
}

/// Bounding box of a sector of the unit circle and its centre, y upwards.
QRectF boxOf(const Interval &sector) {
    QRectF box(0, 0, 0, 0);
    const auto add = [&](double degrees) {
        const double angle = degrees * std::numbers::pi / 180;
        const QPointF at(std::cos(angle), std::sin(angle));
        box = QRectF(QPointF(std::min(box.left(), at.x()), std::min(box.top(), at.y())),
                     QPointF(std::max(box.right(), at.x()), std::max(box.bottom(), at.y())));
    };
    add(sector.from);
    add(sector.to);
    constexpr double quarter = 90;
    const double first = std::ceil(sector.from / quarter) * quarter;
    for (int i = 0; first + i * quarter < sector.to; ++i)
        add(first + i * quarter);
    return box;
}

/// Sets radius and middle of a figure that shows only a sector, if that makes it larger.
void fillFrame(CircleFigure &figure, const std::optional<Interval> &sector) {
    if (!sector)
        return;
    constexpr double worthIt = 1.1;
    constexpr double tails = 3;     // margin for the ends of the axes, mm
    constexpr double scaleRoom = 9; // margin below for the scale, mm
    const QRectF box = boxOf(*sector);
    const double width = figure.size.width() - 2 * sideMargin;
    const double height = figure.size.height() - topMargin - scaleRoom - tails;
    const double radius = std::min(width / box.width(), height / box.height());
    if (!(radius > worthIt * figure.figureRadius))
        return;
    figure.figureRadius = radius;
    figure.sector = sector;
    const double down = (scaleRoom + tails - topMargin) / 2;
    figure.home = QPointF(box.center().x() * radius, box.center().y() * radius - down);
    constexpr double touches = 1e-6;
    if (box.right() < touches)
        figure.firstAxis = u'−' + figure.firstAxis;
    if (box.bottom() < touches)
        figure.secondAxis = u'−' + figure.secondAxis;
}

Interval deviationsOf(std::span<const PathProfile> profiles) {
    Interval range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const PathProfile &profile : profiles) {
        if (profile.deviations.empty())
            continue;
        const Interval own = extremesOf(profile.deviations);
        range = {std::min(range.from, own.from), std::max(range.to, own.to)};
    }
    return range.from <= range.to ? range : Interval{};
}

int decimalsOfDecade(double step) {
    return std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
}

QString ratio(double magnification, const Language &language) {
    return magnification >= 1
               ? language.number(magnification, Quantity::number, -1) + QStringLiteral(":1")
               : QStringLiteral("1:") + language.number(std::round(1 / magnification), Quantity::number, -1);
}

QString withSign(double value, int decimals, const Language &language) {
    const QString digits = language.number(value, Quantity::number, decimals);
    return value > 0 ? QStringLiteral("+") + digits : digits;
}

/// Visible part of the figure plane, as distances from the centre and directions.
struct Visible {
    Interval radii;                 ///< mm
    std::optional<Interval> angles; ///< degrees; null: all
};

Visible visible(const CircleFigure &figure) {
    const CircleView &view = figure.view;
    const double halfWidth = figure.size.width() / 2 / view.zoom;
    const double halfHeight = figure.size.height() / 2 / view.zoom;
    const double dx = std::max(0.0, std::abs(view.x) - halfWidth);
    const double dy = std::max(0.0, std::abs(view.y) - halfHeight);
    Visible result{
        {std::hypot(dx, dy), std::hypot(std::abs(view.x) + halfWidth, std::abs(view.y) + halfHeight)},
        std::nullopt};
    if (dx == 0 && dy == 0)
        return result; // the view contains the centre
    const double middle = std::atan2(view.y, view.x);
    Interval angles{0, 0};
    for (const double x : {view.x - halfWidth, view.x + halfWidth}) {
        for (const double y : {view.y - halfHeight, view.y + halfHeight})
            include(angles, std::remainder(std::atan2(y, x) - middle, 2 * std::numbers::pi));
    }
    constexpr double degrees = 180 / std::numbers::pi;
    result.angles = Interval{(middle + angles.from) * degrees, (middle + angles.to) * degrees};
    return result;
}

/// In the whole figure the rings cover the paths; in a zoomed view they cover the view.
void addRings(CircleFigure &figure, const Interval &deviations, const Visible &inView,
              const Language &language) {
    const double perMicrometre = figure.magnification / micrometresPerMillimetre; // mm on paper
    // Round in the displayed unit.
    const double scale = unitScale(Quantity::micrometres, language.units());
    const double shownDivision =
        roundStep(scale * leastDivision * figure.figureRadius / (perMicrometre * figure.view.zoom), 1,
                  TickSteps::values);
    figure.division = shownDivision / scale;
    const int decimals = decimalsOfDecade(shownDivision);
    figure.divisionLabel = language.quantity(
        figure.division, Quantity::micrometres,
        std::max(0, decimals - shownUnit(Quantity::micrometres, language.units()).decimals));

    const auto deviation = [&](double radius) { return (radius - figure.plotRadius) / perMicrometre; };
    const double slack = 1e-9;
    const double lowest = std::ceil(deviation(innerLimit * figure.figureRadius) / figure.division - slack);
    const double highest = std::floor(deviation(figure.figureRadius) / figure.division + slack);
    double first = std::ceil(deviations.from / figure.division - slack);
    double last = std::floor(deviations.to / figure.division + slack);
    if (figure.view.zoom > 1) {
        first = std::ceil(deviation(inView.radii.from) / figure.division);
        last = std::floor(deviation(inView.radii.to) / figure.division);
    } else if (last - first + 1 < static_cast<double>(fewestRings)) {
        first = std::floor(std::min(0.0, deviations.from) / figure.division);
        last = std::ceil(std::max(0.0, deviations.to) / figure.division);
    }
    first = std::max(std::min(first, 0.0), lowest);
    last = std::min(std::max(last, 0.0), highest);
    if (figure.view.zoom > 1) {
        first = std::max(first, std::ceil(deviation(inView.radii.from) / figure.division) - 1);
        last =
            std::min({last, std::floor(deviation(inView.radii.to) / figure.division) + 1, first + mostRings});
    }
    figure.rings.clear();
    for (int i = 0; first + i <= last; ++i) {
        const double k = first + i;
        const double value = k == 0 ? 0.0 : k * figure.division;
        figure.rings.push_back({value, withSign(value * scale, decimals, language)});
    }
}

void addTraces(CircleFigure &figure, std::span<const PathProfile> profiles, const Visible &inView) {
    const double step = figure.pointStep / (figure.figureRadius * figure.view.zoom) * 180 / std::numbers::pi;
    figure.traces.clear();
    for (const PathProfile &profile : profiles) {
        for (CircleTrace &trace : decimated(profile, step, inView.angles))
            figure.traces.push_back(std::move(trace));
    }
}

/// Range of the deviations of the paths, their envelope and the limits of F.
Interval reach(const CircleFigure &figure, std::span<const PathProfile> profiles) {
    Interval range = deviationsOf(profiles);
    if (figure.envelope) {
        include(range, figure.envelope->inner);
        include(range, figure.envelope->outer);
    }
    for (const DeviationCircle &limit : figure.limits)
        include(range, limit.deviation);
    return range;
}

/// "G", "G(b)f": without the axes.
std::string nameOf(const Parameter &parameter) {
    return std::string(parameter.term.symbol.base) + parameter.term.symbol.subscript;
}

/// Label of a limit (mm), with the digits it was entered with.
QString limitLabel(const std::string &of, double limit, const Language &language) {
    const int decimals = limitDecimals(limit, Quantity::deviation, language.units());
    return language.sentence(REPORT_TEXT("report", "limit of %1: %2"),
                             {of, Number{limit, Quantity::deviation, decimals}});
}

/// Limits outside the figure are not drawn but listed in the caption.
void nameBeyond(CircleFigure &figure, const QStringList &labels, const Language &language) {
    if (!labels.isEmpty())
        figure.caption += u' ' + language.sentence(REPORT_TEXT("report", "(beyond the figure: %1)"),
                                                   {labels.join(QStringLiteral(", ")).toStdString()});
}

void addEnvelope(CircleFigure &figure, const CircleSource &source, const Language &language) {
    const Parameter *shown = source.circularDeviation();
    const CircleResult *circle = source.circle();
    if (source.radial() || !circle || !shown || !shown->value)
        return;
    const double nominal = source.measurement.nominalRadius;
    CircleEnvelope envelope;
    envelope.label = QString::fromUtf8(shown->term.symbol.base);
    envelope.subscript = QString::fromUtf8(shown->term.symbol.subscript);
    envelope.id = QString::fromStdString(parameterId(*shown));
    envelope.inner = (circle->innerRadius - nominal) * micrometresPerMillimetre;
    envelope.outer = (circle->outerRadius - nominal) * micrometresPerMillimetre;
    if (source.options.limits && shown->limit && shown->limit->value) {
        envelope.limit = *shown->limit->value * micrometresPerMillimetre;
        if (shown->verdict && shown->guardBand)
            envelope.guard = *shown->guardBand * micrometresPerMillimetre;
        envelope.limitLabel = limitLabel(nameOf(*shown), *shown->limit->value, language);
    }
    figure.envelope = envelope;
}

/// Adds Fmin and Fmax as circles, and their limits.
void addRadialDeviations(CircleFigure &figure, const CircleSource &source, const Test &test,
                         std::span<const PathProfile> profiles, const Language &language,
                         QStringList &beyond) {
    if (!source.radial() || profiles.empty())
        return;
    const Parameter *most = source.parameter("Fmax");
    const Parameter *least = source.parameter("Fmin");
    if (!most || !least || !most->value || !least->value)
        return;
    if (source.of() != CircleOf::both) {
        CircleEnvelope envelope;
        envelope.id = QString::fromStdString(parameterId(*most));
        envelope.inner = *least->value * micrometresPerMillimetre;
        envelope.outer = *most->value * micrometresPerMillimetre;
        envelope.dimension = false;
        figure.envelope = envelope;
    }
    if (!source.options.limits)
        return;
    const Interval range = deviationsOf(profiles);
    const double largest = largestLimit * std::max(std::abs(range.from), std::abs(range.to));
    const auto add = [&](const char *id, double sign) {
        const auto found = test.limits.find(id);
        if (found == test.limits.end() || !found->second.value ||
            (most->limit != found->second && least->limit != found->second))
            return; // none, or agreed for another edition
        const double limit = sign * *found->second.value;
        const QString label = limitLabel(id, limit, language);
        if (std::abs(limit) * micrometresPerMillimetre <= largest)
            figure.limits.push_back({limit * micrometresPerMillimetre, label});
        else if (!beyond.contains(label) && !(sign < 0))
            beyond << label;
    };
    add("Fmin", 1);
    add("F", -1);
    add("F", 1);
    add("Fmax", 1);
}

/// Adds the points first … next − 1 at which a path reaches `deviation`, except those of known contacts.
void addContacts(std::vector<ContactMark> &found, const PathProfile &profile, std::size_t first,
                 std::size_t next, double deviation, bool outer) {
    for (std::size_t i = first; i < next && found.size() < mostContacts; ++i) {
        if (std::abs(profile.deviations[i] - deviation) > contactTolerance)
            continue;
        const bool known = std::ranges::any_of(found, [&](const ContactMark &other) {
            return other.mark.sense == profile.sense &&
                   std::abs(std::remainder(other.mark.at.angle - profile.angles[i], fullTurn)) <
                       contactDistance;
        });
        if (!known)
            found.push_back({{profile.sense, profile[i]}, outer});
    }
}

/// Adds the points at which `deviation` is reached, one per contact.
void addContacts(CircleFigure &figure, std::span<const PathProfile> profiles, double deviation, bool outer) {
    constexpr std::size_t some = 4096; // most blocks have no contact, which extremes tell in a quarter of the
                                       // time
    std::vector<ContactMark> found;
    for (const PathProfile &profile : profiles) {
        for (std::size_t first = 0; profile.isEvaluated() && first < profile.deviations.size();
             first += some) {
            const std::size_t next = std::min(first + some, profile.deviations.size());
            const Interval range = extremesOf(std::span(profile.deviations).subspan(first, next - first));
            if (range.from - 2 * contactTolerance <= deviation &&
                deviation <= range.to + 2 * contactTolerance)
                addContacts(found, profile, first, next, deviation, outer);
        }
    }
    figure.contacts.insert(figure.contacts.end(), found.begin(), found.end());
}

/// An empty figure with its axes, in a frame that its paths fill.
CircleFigure framed(const Plane &plane, std::span<const PathProfile> profiles,
                    const CircleFigureOptions &options) {
    CircleFigure figure;
    figure.firstAxis = QString::fromStdString(plane.first);
    figure.secondAxis = QString::fromStdString(plane.second);
    figure.size = options.size;
    figure.pointStep = options.pointStep;
    figure.figureRadius = std::max(smallestRadius, std::min(options.size.width() / 2 - sideMargin,
                                                            options.size.height() / 2 - topMargin));
    if (options.fillFrame)
        fillFrame(figure, sectorOf(profiles));
    return figure;
}

void setScale(CircleFigure &figure, const Interval &deviations, const CircleFigureOptions &options,
              const Language &language) {
    const CircleScale scale = circleScale(deviations, figure.figureRadius, options.mostMagnification);
    figure.plotRadius = scale.plotRadius;
    figure.magnification = scale.magnification;
    figure.ratio = ratio(figure.magnification, language);
}

QString captionOf(const CircleFigure &figure, const Language &language) {
    return language.sentence(REPORT_TEXT("report", "magnification %1, %2 per division"),
                             {figure.ratio.toStdString(), figure.divisionLabel.toStdString()});
}

QString senseText(Sense sense, const std::string &index, const Language &language) {
    return language.sentence(sense == Sense::counterclockwise ? REPORT_TEXT("report", "anticlockwise, %1")
                                                              : REPORT_TEXT("report", "clockwise, %1"),
                             {index});
}

void addLegend(CircleFigure &figure, const CircleSource &source, std::span<const PathProfile> profiles,
               const Language &language) {
    const auto add = [&](CircleLegendSample sample, const QString &text) {
        figure.legend.push_back({sample, text});
    };
    bool repeated = false;
    bool synthetic = false;
    for (const PathProfile &profile : profiles) {
        repeated |= profile.repetition;
        synthetic |= profile.synthetic;
        if (profile.isEvaluated())
            add(profile.sense == Sense::counterclockwise ? CircleLegendSample::counterclockwise
                                                         : CircleLegendSample::clockwise,
                senseText(profile.sense, profile.index, language));
    }
    if (repeated)
        add(CircleLegendSample::repetitions, language.text(REPORT_TEXT("report", "repetitions")));
    if (synthetic)
        add(CircleLegendSample::synthetic, language.text(REPORT_TEXT("report", "synthetic path")));
    add(CircleLegendSample::nominal, language.text(REPORT_TEXT("report", "nominal circle")));
    if (figure.envelope && figure.envelope->dimension) {
        const Text text = source.measurement.referenceCircle == ReferenceCircle::minimumZone
                              ? REPORT_TEXT("report", "minimum zone, %1")
                              : REPORT_TEXT("report", "least squares, %1");
        add(CircleLegendSample::envelope,
            language.sentence(text, {(figure.envelope->label + figure.envelope->subscript).toStdString()}));
    } else if (figure.envelope) {
        add(CircleLegendSample::envelope, QStringLiteral("Fmin, Fmax"));
    }
    if (!figure.limits.empty())
        add(CircleLegendSample::limit, language.text(REPORT_TEXT("report", "limits of F")));
    add(CircleLegendSample::centre, language.text(REPORT_TEXT("report", "reference centre")));
    if (!figure.starts.empty())
        add(CircleLegendSample::start, language.text(REPORT_TEXT("report", "starting point")));
    if (!figure.contacts.empty())
        add(CircleLegendSample::contacts, language.text(REPORT_TEXT("report", "ruling points")));
    setLegend(figure, std::move(figure.legend), figure.size.width() >= threeColumns ? 3 : 2);
}

Text titleText(const CircleSource &source, std::size_t paths) {
    if (source.radial())
        return REPORT_TEXT("report", "Radial deviation F, %1");
    if (source.options.of != CircleOf::both)
        return source.measurement.source == SignalSource::feedback
                   ? REPORT_TEXT("report", "Circular deviation Gf, %1")
                   : REPORT_TEXT("report", "Circular deviation G, %1");
    return paths == 1 ? REPORT_TEXT("report", "Actual path, %1") : REPORT_TEXT("report", "Actual paths");
}

Message centreText(const CircleSource &source) {
    if (source.aboutSetUp())
        return {REPORT_TEXT("report", "about the centre of the set-up"), {}, {}};
    if (!source.circle())
        return {REPORT_TEXT("report", "about the programmed centre"), {}, {}};
    const bool isZone = source.circle()->kind == ReferenceCircle::minimumZone;
    const Parameter *shown = source.circularDeviation();
    if (!source.radial() && !shown) // the edition has no G(b)
        return {isZone ? REPORT_TEXT("report", "about the centre of the minimum zone of both paths")
                       : REPORT_TEXT("report", "about the centre of the least squares circle of both paths"),
                {},
                {}};
    return {isZone ? REPORT_TEXT("report", "about the centre of the minimum zone of %1")
                   : REPORT_TEXT("report", "about the centre of the least squares circle of %1"),
            {source.radial() ? std::string("F") : nameOf(*shown)},
            {}};
}

} // namespace

CircleScale circleScale(const Interval &deviations, double figureRadius, double most) {
    const double inward = std::min(0.0, deviations.from) / micrometresPerMillimetre;
    const double outward = std::max(0.0, deviations.to) / micrometresPerMillimetre;
    const double inner = innerLimit * figureRadius;
    const double preferred = nominalCircle * figureRadius;
    constexpr double tolerance = 1 + 1e-12;
    const auto fits = [&](double magnification) {
        return magnification * outward <= (figureRadius - preferred) * tolerance &&
               -magnification * inward <= (preferred - inner) * tolerance;
    };
    const auto fitsMoved = [&](double magnification) {
        return magnification * (outward - inward) <= (figureRadius - inner) * tolerance;
    };
    const auto largest = [most](const auto &suits) {
        for (int decade = highestDecade; decade > lowestDecade; --decade) {
            for (const double factor : {1.0, 0.5, 0.2}) {
                const double magnification = factor * powerOfTen(decade);
                if (magnification <= most && suits(magnification))
                    return magnification;
            }
        }
        return powerOfTen(lowestDecade);
    };
    const double there = largest(fits);
    const double moved = largest(fitsMoved);
    if (moved < worthMoving * there)
        return {preferred, there};
    return {std::clamp(preferred, inner - moved * inward,
                       std::max(inner - moved * inward, figureRadius - moved * outward)),
            moved};
}

std::vector<PathProfile> profilesOfPaths(const Test &test, const TestEvaluation &evaluation,
                                         const CircleFigureOptions &options, std::span<const Points> paths) {
    const CircleSource source(test, evaluation, options);
    const CircleResult *circle = source.circle();
    std::vector<PathProfile> result;
    for (std::size_t i = 0; i < source.results.paths.size() && i < paths.size(); ++i) {
        const EvaluatedPath &path = source.results.paths[i];
        if (!source.shows(path.sense) || path.source.empty())
            continue;
        result.push_back(profile(source.measurement.arcs[path.arc], path.source, paths[i].view(),
                                 circle ? circle->centre : Point{}, source.measurement.nominalRadius));
        finish(result.back(), source, path.arc);
    }
    return result;
}

std::vector<PathProfile> profilesAbout(const CircularMeasurement &measurement, const CircularResults &results,
                                       std::span<const Points> paths, Point centre, double radius) {
    std::vector<PathProfile> result;
    for (std::size_t i = 0; i < results.paths.size() && i < paths.size(); ++i) {
        const EvaluatedPath &path = results.paths[i];
        result.push_back(profile(measurement.arcs[path.arc], path.source, paths[i].view(), centre, radius));
        result.back().arc = path.arc;
        result.back().index = path.index;
        result.back().ordered = isOrdered(result.back().angles);
    }
    return result;
}

std::vector<PathProfile> pathProfiles(const Test &test, const TestEvaluation &evaluation,
                                      const CircleFigureOptions &options) {
    return profilesOf(CircleSource(test, evaluation, options));
}

PathProfile wholeArc(const Test &test, const TestEvaluation &evaluation, std::size_t arc) {
    const CircleFigureOptions options;
    const CircleSource source(test, evaluation, options);
    const Arc &measured = source.measurement.arcs[arc];
    const CircleResult *circle =
        source.results.circle(iso230_4::circleOf(measured.sense), ReferenceCircle::leastSquares);
    PathProfile result =
        profile(measured, allIndices(measured.angles.size()), allPoints(measured, arc, source).view(),
                circle ? circle->centre : Point{}, source.measurement.nominalRadius);
    finish(result, source, arc);
    return result;
}

CircleFigure circleFigure(const Test &test, const TestEvaluation &evaluation, const Language &language,
                          const CircleFigureOptions &options) {
    return circleFigure(test, evaluation, pathProfiles(test, evaluation, options), language, options);
}

CircleFigure circleFigure(const Test &test, const TestEvaluation &evaluation,
                          std::span<const PathProfile> profiles, const Language &language,
                          const CircleFigureOptions &options) {
    const CircleSource source(test, evaluation, options);
    CircleFigure figure = framed(source.measurement.plane, profiles, options);
    addEnvelope(figure, source, language);
    QStringList beyond;
    addRadialDeviations(figure, source, test, profiles, language, beyond);
    for (const PathProfile &profile : profiles) {
        if (!profile.isEvaluated())
            continue;
        figure.starts.push_back({profile.sense, profile[0]});
        figure.arrows.push_back({profile.sense, QString::fromStdString(profile.index)});
    }
    if (options.contacts && figure.envelope) {
        addContacts(figure, profiles, figure.envelope->outer, true);
        addContacts(figure, profiles, figure.envelope->inner, false);
    }
    const Interval deviations = reach(figure, profiles);
    setScale(figure, deviations, options, language);
    if (figure.envelope && figure.envelope->limit &&
        *figure.envelope->limit * figure.magnification / micrometresPerMillimetre > figure.figureRadius) {
        figure.envelope->limit.reset();
        beyond << figure.envelope->limitLabel;
    }

    const auto paths = static_cast<std::size_t>(std::ranges::count_if(profiles, &PathProfile::isEvaluated));
    const std::string name = paths == 0 ? std::string() : profiles.front().index;
    figure.title = language.sentence(titleText(source, paths), {name});
    figure.centre = language.sentence(centreText(source));
    const Visible inView = visible(figure);
    addRings(figure, deviations, inView, language);
    addTraces(figure, profiles, inView);
    figure.caption = captionOf(figure, language);
    nameBeyond(figure, beyond, language);
    addLegend(figure, source, profiles, language);
    return figure;
}

CircleFigure pathsFigure(std::span<const PathProfile> profiles, const Plane &plane, const Language &language,
                         const CircleFigureOptions &options) {
    CircleFigure figure = framed(plane, profiles, options);
    const Interval deviations = reach(figure, profiles);
    setScale(figure, deviations, options, language);
    const Visible inView = visible(figure);
    addRings(figure, deviations, inView, language);
    addTraces(figure, profiles, inView);
    figure.caption = captionOf(figure, language);
    return figure;
}

void setLegend(CircleFigure &figure, std::vector<CircleLegendEntry> entries, int columns) {
    figure.legend = std::move(entries);
    figure.keyColumns = columns;
    figure.keyHeight = keyGap + keyRow * std::ceil(static_cast<double>(figure.legend.size()) / columns);
}

std::vector<CircleFigureOptions> separateCircleFigures(const Test &test, const TestEvaluation &evaluation) {
    const CircleFigureOptions options;
    const CircleSource source(test, evaluation, options);
    std::vector<CircleFigureOptions> result;
    if (source.results.paths.size() == 2)
        result.push_back({});
    for (const auto subject : {CircleSubject::circularDeviation, CircleSubject::radialDeviation}) {
        for (const EvaluatedPath &path : source.results.paths) {
            CircleFigureOptions one;
            one.of = iso230_4::circleOf(path.sense);
            one.subject = subject;
            const CircleSource of(test, evaluation, one);
            const Parameter *shown = of.radial() ? of.parameter("Fmax") : of.circularDeviation();
            if (shown && shown->value)
                result.push_back(one);
        }
    }
    return result;
}

QSizeF printedSize(const CircleFigure &figure) {
    return {figure.size.width(), figure.size.height() + figure.keyHeight};
}

CircleFigure withView(CircleFigure figure, std::span<const PathProfile> profiles, const CircleView &view,
                      const Language &language) {
    // With the same zoom and all directions visible before and after, the points do not change: panning over
    // 10⁶ of them takes 7 ms less per frame.
    const bool samePoints = figure.view.zoom == view.zoom && !visible(figure).angles;
    figure.view = view;
    const Visible inView = visible(figure);
    addRings(figure, view.zoom > 1 ? Interval{} : reach(figure, profiles), inView, language);
    if (!samePoints || inView.angles)
        addTraces(figure, profiles, inView);
    return figure;
}

} // namespace palmer
