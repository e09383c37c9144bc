// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/simulation/circulartrials.h"

#include "kernel/evaluation/iso230_4/circles.h"
#include "kernel/evaluation/iso230_4/paths.h"
#include "kernel/numerics/centringerror.h"
#include "kernel/numerics/minimumzone.h"
#include "kernel/numerics/wideregisters.h"
#include "kernel/uncertainty/circularbudget.h"

#include <algorithm>
#include <cmath>

namespace palmer {

namespace {

constexpr double coverage = 2;                      ///< k of the contributions
constexpr double rootOfTwelve = 3.4641016151377546; ///< width / standard deviation, uniform distribution

/// Counters of the random numbers of a trial.
enum Place : std::uint32_t { commonPlace = 0, repeatabilityPlace = 4, firstPointPlace = 64 };

double deviation(const std::vector<Contribution> &contributions, std::string_view id) {
    const auto found = std::ranges::find(contributions, id, [](const Contribution &c) { return c.id; });
    return found == contributions.end() ? 0 : found->expanded.value_or(0) / coverage;
}

/// Errors added to all deviations of a path.
struct Shift {
    double common = 0; ///< mm
    double scale = 0;  ///< per unit of deviation from the middle
    double middle = 0; ///< mm
    Point centring;    ///< mm
};

/// Adds the shift to the errors of the points, and gives deviations and distances from the programmed centre.
/// A plain loop, so that the compiler can vectorise it for the function it is inlined into.
[[gnu::always_inline]] inline void shift(const Shift &by, double nominalRadius, const double *deviation,
                                         const double *ux, const double *uy, std::span<double> errors,
                                         double *distance) {
    double *error = errors.data();
    for (std::size_t i = 0; i < errors.size(); ++i) {
        error[i] = deviation[i] + (by.common + by.scale * (deviation[i] - by.middle) -
                                   (by.centring.x * ux[i] + by.centring.y * uy[i]) + error[i]);
        distance[i] = nominalRadius + error[i];
    }
}

/// rebuiltRadius() for all points of a path.
[[gnu::always_inline]] inline void rebuild(std::span<const double> distances, const double *ux,
                                           const double *uy, Point e, double *radius) {
    for (std::size_t i = 0; i < distances.size(); ++i)
        radius[i] = rebuiltRadius(distances[i], {ux[i], uy[i]}, e);
}

} // namespace

CircularTrials::CircularTrials(const Test &test, const CircularMeasurement &measurement,
                               const Surroundings &surroundings, const TestEvaluation &evaluation,
                               long long seed)
    : m_test(test)
    , m_measurement(measurement)
    , m_surroundings(surroundings)
    , m_edition(*evaluation.edition)
    , m_results(std::get<CircularResults>(evaluation.results))
    , m_draws(seed) {
    const auto &contributions = evaluation.uncertainty.contributions;
    m_zero = deviation(contributions, displacementId);
    m_length = deviation(contributions, referenceLengthId);
    m_correction = deviation(contributions, correctionId);
    constexpr double micrometresPerMm = 1000;
    m_errors.noise = std::max(0.0, measurement.uncertainty.pointNoise.value_or(0)) / micrometresPerMm;
    m_errors.resolution = deviation(contributions, resolutionId) * rootOfTwelve;
    m_drift = deviation(contributions, driftId) * rootOfTwelve;
    if (measurement.centring == Centring::instrument)
        m_centring = deviation(contributions, centringId);

    const CircularCase whole{test, measurement, surroundings, m_edition, m_results};
    const auto listed = iso230_4::listedParameters(whole);
    std::vector<std::optional<double>> repeated(listed.size());
    if (!measurement.uncertainty.repeatability)
        repeated = iso230_4::repeatabilities(whole);
    for (std::size_t k = 0; k < listed.size() && k < evaluation.parameters.size(); ++k) {
        const Parameter &parameter = evaluation.parameters[k];
        if (!parameter.value || !parameter.budgetUncertainty)
            continue;
        m_parameters.push_back({parameterId(parameter), *parameter.value, 0, 0, 0, 0, {}});
        m_listed.push_back(k);
        m_repeatability.push_back(repeated[k].value_or(deviation(contributions, repeatabilityId)));
        if (parameter.term.circle == OfCircle::hysteresis)
            m_hysteresis = m_listed.size() - 1;
        wantCircles(parameter.term);
    }

    addParts();
    addReferences();
}

void CircularTrials::wantCircles(const Term &term) {
    if (term.circle == OfCircle::radialDeviation && m_measurement.centring == Centring::instrument) {
        m_readings = true;
        return;
    }
    const bool width = term.circle == OfCircle::deviation;
    const ReferenceCircle kind = width ? m_measurement.referenceCircle : ReferenceCircle::leastSquares;
    const auto want = [&](CircleOf of) {
        const auto found =
            std::ranges::find_if(m_circles, [&](const Circle &c) { return c.of == of && c.kind == kind; });
        const bool radiusAlone = term.of == Of::pair && !width;
        if (found == m_circles.end())
            m_circles.push_back({of, kind, radiusAlone, {}, {}, {}});
        else
            found->radiusAlone = found->radiusAlone && radiusAlone;
    };
    if (term.of == Of::pair) {
        want(CircleOf::both);
        return;
    }
    want(CircleOf::counterclockwise);
    want(CircleOf::clockwise);
}

void CircularTrials::addParts() {
    std::uint32_t place = firstPointPlace;
    double low = 0;
    double high = 0;
    std::size_t points = 0;
    for (const EvaluatedPath &path : m_results.paths) {
        m_parts.push_back(partOf(path, place));
        for (const double deviation : m_parts.back().deviations) {
            low = points == 0 ? deviation : std::min(low, deviation);
            high = points == 0 ? deviation : std::max(high, deviation);
            ++points;
        }
        place += placesOfPoints(m_parts.back().angles.size());
    }
    addRepeated();
    m_middle = (low + high) / 2;
    m_scale = high > low ? m_zero / (high - low) : 0;
    constexpr std::size_t pointsPerChunk = 50000; // takes some milliseconds
    constexpr std::size_t mostOfChunk = 50;
    m_chunk = static_cast<int>(
        std::clamp<std::size_t>(pointsPerChunk / std::max<std::size_t>(points, 1), 1, mostOfChunk));
}

CircularTrials::Part CircularTrials::partOf(const EvaluatedPath &path, std::uint32_t place) const {
    const Arc &arc = m_measurement.arcs[path.arc];
    const bool commanded = arc.angleReference == AngleReference::commanded;
    Part part{path.arc, {}, {}, {}, place, commanded, {}};
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> radii;
    for (const std::size_t i : path.source) {
        const Point u = direction(arc.angles[i]);
        const double r = m_measurement.nominalRadius + arc.radialDeviations[i];
        part.angles.push_back(arc.angles[i]);
        part.directions.push_back(u);
        part.deviations.push_back(arc.radialDeviations[i]);
        x.push_back(u.x);
        y.push_back(u.y);
        radii.push_back(commanded && m_results.centringError ? rebuiltRadius(r, u, *m_results.centringError)
                                                             : r);
    }
    const CircleOf of = iso230_4::circleOf(path.sense);
    const CircleResult *circle = m_results.circle(of, ReferenceCircle::leastSquares);
    if (!circle)
        circle = m_results.circle(of, ReferenceCircle::minimumZone);
    part.rays = Rays(std::move(x), std::move(y), std::move(radii), circle ? circle->centre : Point{});
    return part;
}

void CircularTrials::addRepeated() {
    for (const std::size_t k : m_results.repetitions) {
        const Arc &arc = m_measurement.arcs[k];
        const auto range = iso230_4::evaluatedRange(arc);
        if (arc.angleReference != AngleReference::commanded || !range)
            continue;
        Part part{k, {}, {}, {}, 0, true, {}};
        for (std::size_t i = 0; i < arc.angles.size(); ++i) {
            if (arc.angles[i] < range->from || arc.angles[i] > range->to)
                continue;
            part.angles.push_back(arc.angles[i]);
            part.directions.push_back(direction(arc.angles[i]));
            part.deviations.push_back(m_measurement.nominalRadius + arc.radialDeviations[i]);
        }
        m_repeated.push_back(std::move(part));
    }
}

void CircularTrials::addReferences() {
    std::vector<std::vector<double>> distances(m_parts.size());
    for (std::size_t k = 0; k < m_parts.size(); ++k) {
        for (const double d : m_parts[k].deviations)
            distances[k].push_back(m_measurement.nominalRadius + d);
    }
    const std::vector<CommandedArc> arcs = inOrderOfTime(distances);
    if (const CentringError error = centringError(arcs); error.status == CentringError::Status::converged)
        m_nearbyCentring.emplace(arcs, error);
    const CircleResult *both = m_results.circle(CircleOf::both, ReferenceCircle::leastSquares);
    if (m_hysteresis && both && m_parts.size() == 2)
        m_nearbyHysteresis.emplace(m_parts[0].rays, m_parts[1].rays, both->centre);
    for (Circle &circle : m_circles) {
        Points points;
        std::vector<const Rays *> sets;
        for (std::size_t k = 0; k < m_parts.size(); ++k) {
            if (circle.of != CircleOf::both && circle.of != iso230_4::circleOf(m_results.paths[k].sense))
                continue;
            circle.parts.push_back(k);
            sets.push_back(&m_parts[k].rays);
            points.append(m_parts[k].rays.reference().view());
        }
        const CircleResult *result = m_results.circle(circle.of, circle.kind);
        if (!result)
            continue;
        if (circle.kind == ReferenceCircle::leastSquares) {
            circle.nearby.emplace(sets, result->centre);
        } else {
            const MinimumZone zone = minimumZone(points.view());
            // If only noise varies, any four points will do.
            const std::size_t quarter = points.size() / 4;
            circle.contacts = {0, 2 * quarter, quarter, 3 * quarter};
            if (zone.valid() && zone.certified)
                circle.contacts = {zone.outer[0], zone.outer[1], zone.inner[0], zone.inner[1]};
        }
    }
}

CircularTrials::Buffers CircularTrials::buffers() const {
    Buffers result{std::make_shared<CircularMeasurement>(m_measurement),
                   std::make_shared<CircularResults>(m_results),
                   {},
                   {},
                   {}};
    for (const Part &part : m_parts) {
        result.distances.emplace_back(part.deviations.size());
        result.looks.push_back(part.rays.sample());
    }
    return result;
}

CircularTrials::Common CircularTrials::common(long long trial) const {
    std::array<RandomDraws::Words, 2> words{m_draws.words(trial, commonPlace),
                                            m_draws.words(trial, commonPlace + 1)};
    const auto more = m_draws.words(trial, commonPlace + 2);
    Common result{};
    result.drift = {m_drift / 2 * RandomDraws::symmetric(words[0][0]),
                    m_drift / 2 * RandomDraws::symmetric(words[0][1])};
    result.zero = m_zero * RandomDraws::normal(words[0][2]) + m_length * RandomDraws::normal(words[0][3]);
    result.scale = m_scale * RandomDraws::normal(words[1][0]);
    result.correction = m_correction * RandomDraws::normal(words[1][1]);
    result.centring = {m_centring * RandomDraws::normal(words[1][2]),
                       m_centring * RandomDraws::normal(more[0])};
    return result;
}

void CircularTrials::perturb(long long trial, std::size_t index, const Common &all, Buffers &buffers) const {
    const Part &part = m_parts[index];
    const std::size_t n = part.deviations.size();
    std::vector<double> &errors = buffers.errors;
    errors.resize(n);
    if (m_errors.noise > 0 || m_errors.resolution > 0)
        drawPointErrors(m_draws, trial, part.place, m_errors, errors);
    else
        std::ranges::fill(errors, 0);
    const Shift by{all.drift[index % 2] + all.zero, all.scale, m_middle, all.centring};
    inAvailableRegisters([&](auto) __attribute__((always_inline)) {
        shift(by, m_measurement.nominalRadius, part.deviations.data(), part.rays.x().data(),
              part.rays.y().data(), errors, buffers.distances[index].data());
    });
    if (m_readings)
        setReadings(index, buffers);
}

void CircularTrials::setReadings(std::size_t index, Buffers &buffers) const {
    auto &deviations = buffers.measurement->arcs[m_parts[index].arc].radialDeviations;
    const auto &source = m_results.paths[index].source;
    for (std::size_t i = 0; i < source.size(); ++i)
        deviations[source[i]] = buffers.errors[i];
}

std::vector<CommandedArc>
CircularTrials::inOrderOfTime(std::span<const std::vector<double>> distances) const {
    std::vector<std::pair<std::size_t, CommandedArc>> inOrder;
    for (std::size_t k = 0; k < m_parts.size(); ++k) {
        if (m_parts[k].commanded)
            inOrder.push_back({m_parts[k].arc, {m_parts[k].angles, distances[k], m_parts[k].directions}});
    }
    for (const Part &part : m_repeated)
        inOrder.push_back({part.arc, {part.angles, part.deviations, part.directions}});
    std::ranges::sort(inOrder, {}, &std::pair<std::size_t, CommandedArc>::first);
    std::vector<CommandedArc> result;
    result.reserve(inOrder.size());
    for (const auto &[arc, path] : inOrder)
        result.push_back(path);
    return result;
}

std::optional<Point> CircularTrials::centringErrorOf(const Buffers &buffers) const {
    const std::vector<CommandedArc> arcs = inOrderOfTime(buffers.distances);
    if (arcs.empty())
        return std::nullopt;
    if (m_nearbyCentring) {
        std::vector<std::span<const double>> distances;
        distances.reserve(arcs.size());
        for (const CommandedArc &arc : arcs)
            distances.push_back(arc.distances);
        if (const auto e = m_nearbyCentring->centringError(distances))
            return e;
    }
    const CentringError error = centringError(arcs);
    return error.valid() ? std::optional(error.e) : std::nullopt;
}

void CircularTrials::setPoints(Buffers &buffers) const {
    for (std::size_t k = 0; k < m_parts.size(); ++k) {
        const Part &part = m_parts[k];
        Rays::Look &look = buffers.looks[k];
        const auto &e = buffers.results->centringError;
        if (part.commanded && e) {
            inAvailableRegisters([&](auto) __attribute__((always_inline)) {
                rebuild(buffers.distances[k], part.rays.x().data(), part.rays.y().data(), *e,
                        look.radii.data());
            });
        } else {
            look.radii.swap(buffers.distances[k]); // redrawn by the next trial
        }
        part.rays.prepare(look);
    }
}

std::optional<CircleResult> CircularTrials::minimumZoneOf(const Circle &circle,
                                                          const Buffers &buffers) const {
    if (!circle.contacts)
        return std::nullopt;
    std::array<RaysLook, 2> looks{};
    for (std::size_t k = 0; k < circle.parts.size(); ++k)
        looks[k] = {&m_parts[circle.parts[k]].rays, &buffers.looks[circle.parts[k]]};
    const auto zone = minimumZone(std::span(looks).first(circle.parts.size()), *circle.contacts);
    if (!zone)
        return std::nullopt;
    return CircleResult{
        circle.of,         circle.kind,       zone->centre, (zone->innerRadius + zone->outerRadius) / 2,
        zone->innerRadius, zone->outerRadius, zone->width,  zone->certified};
}

std::optional<CircleResult> CircularTrials::leastSquaresOf(const Circle &circle,
                                                           const Buffers &buffers) const {
    if (!circle.nearby)
        return std::nullopt;
    std::array<const Rays::Look *, 2> looks{};
    for (std::size_t k = 0; k < circle.parts.size(); ++k)
        looks[k] = &buffers.looks[circle.parts[k]];
    const auto fit = circle.nearby->fit(std::span(looks).first(circle.parts.size()));
    if (!fit)
        return std::nullopt;
    CircleResult result{circle.of, circle.kind, fit->centre, fit->radius, 0, 0, 0, std::nullopt};
    if (circle.radiusAlone)
        return result;
    result.innerRadius = std::numeric_limits<double>::infinity();
    for (const std::size_t k : circle.parts) {
        const Rays::Extremes extremes = m_parts[k].rays.extremes(buffers.looks[k], fit->centre);
        result.innerRadius = std::min(result.innerRadius, extremes.least);
        result.outerRadius = std::max(result.outerRadius, extremes.greatest);
    }
    result.width = result.outerRadius - result.innerRadius;
    return result;
}

std::optional<double> CircularTrials::hysteresisOf(const Buffers &buffers) const {
    const CircleResult *both = buffers.results->circle(CircleOf::both, ReferenceCircle::leastSquares);
    if (!m_nearbyHysteresis || !both)
        return std::nullopt;
    return m_nearbyHysteresis->largestDifference(
        {RaysLook{&m_parts[0].rays, &buffers.looks.front()}, RaysLook{&m_parts[1].rays, &buffers.looks[1]}},
        both->centre);
}

void CircularTrials::fillPoints(const std::vector<std::size_t> &parts, Buffers &buffers) const {
    ++buffers.plain;
    for (const std::size_t k : parts)
        m_parts[k].rays.fill(buffers.looks[k], buffers.results->paths[k].points);
}

bool CircularTrials::evaluate(Buffers &buffers, const std::stop_token &stop) const {
    CircularResults &results = *buffers.results;
    results.centringError = centringErrorOf(buffers);
    setPoints(buffers);
    results.circles.clear();
    for (const Circle &circle : m_circles) {
        if (stop.stop_requested())
            return false;
        const auto result = circle.kind == ReferenceCircle::minimumZone ? minimumZoneOf(circle, buffers)
                                                                        : leastSquaresOf(circle, buffers);
        if (result) {
            results.circles.push_back(*result);
            continue;
        }
        fillPoints(circle.parts, buffers);
        const auto plain = iso230_4::circles(results.paths, [&](CircleOf of, ReferenceCircle kind) {
            return of == circle.of && kind == circle.kind;
        });
        results.circles.insert(results.circles.end(), plain.begin(), plain.end());
    }
    return !stop.stop_requested();
}

void CircularTrials::run(long long first, Buffers &buffers, std::span<double> values,
                         const std::stop_token &stop) const {
    const auto trials = static_cast<std::size_t>(m_chunk);
    const CircularCase whole{m_test, *buffers.measurement, m_surroundings, m_edition, *buffers.results};
    const auto listed = iso230_4::listedParameters(whole);
    for (std::size_t k = 0; k < trials; ++k) {
        const long long trial = first + static_cast<long long>(k);
        const Common all = common(trial);
        for (std::size_t part = 0; part < m_parts.size(); ++part)
            perturb(trial, part, all, buffers);
        if (!evaluate(buffers, stop))
            return;
        buffers.results->correction = m_results.correction.value_or(0) + all.correction;
        for (std::size_t p = 0; p < m_listed.size(); ++p) {
            std::optional<double> found;
            if (p == m_hysteresis) {
                found = hysteresisOf(buffers);
                if (!found)
                    fillPoints({0, 1}, buffers);
            }
            if (!found)
                found = iso230_4::value(listed[m_listed[p]], whole);
            const RandomDraws::Words words =
                m_draws.words(trial, repeatabilityPlace + static_cast<std::uint32_t>(p));
            // A circle made impossible by noise says nothing about Y.
            values[p * trials + k] =
                found.value_or(m_parameters[p].value) + m_repeatability[p] * RandomDraws::normal(words[0]);
        }
    }
}

CircularMeasurement CircularTrials::perturbed(long long trial) const {
    Buffers buffers = this->buffers();
    const Common all = common(trial);
    for (std::size_t part = 0; part < m_parts.size(); ++part) {
        perturb(trial, part, all, buffers);
        setReadings(part, buffers);
    }
    return *buffers.measurement;
}

} // namespace palmer
