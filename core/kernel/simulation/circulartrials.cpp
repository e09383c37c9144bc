#include "kernel/simulation/circulartrials.h"

#include "kernel/evaluation/iso230_4/circles.h"
#include "kernel/evaluation/iso230_4/paths.h"
#include "kernel/numerics/centringerror.h"
#include "kernel/uncertainty/circularbudget.h"

#include <algorithm>
#include <cmath>

namespace palmer {

namespace {

constexpr double coverage = 2;                      ///< k of the contributions
constexpr double rootOfTwelve = 3.4641016151377546; ///< width of a uniform distribution over its deviation

/// Places of the random numbers of a trial.
enum Place : std::uint32_t { commonPlace = 0, repeatabilityPlace = 4, firstPointPlace = 64 };

constexpr std::size_t pointsPerStep = 8; ///< of four places: two words a point

/// The circles a result looks at.
std::vector<std::pair<CircleOf, ReferenceCircle>> circlesOf(const CircularRow &row,
                                                            const CircularMeasurement &measurement) {
    const std::string_view quantity = row.quantity;
    const bool width = quantity.starts_with('G');
    if (quantity == "F" && measurement.centring == Centring::instrument)
        return {};
    const ReferenceCircle kind = width ? measurement.referenceCircle : ReferenceCircle::leastSquares;
    if (row.of == CircularRow::Of::pair)
        return {{CircleOf::both, kind}};
    return {{CircleOf::counterclockwise, kind}, {CircleOf::clockwise, kind}};
}

double deviation(const std::vector<Contribution> &contributions, std::string_view id) {
    const auto found = std::ranges::find(contributions, id, [](const Contribution &c) { return c.id; });
    return found == contributions.end() ? 0 : found->expanded.value_or(0) / coverage;
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
    m_noise = std::max(0.0, measurement.uncertainty.pointNoise.value_or(0)) / micrometresPerMm;
    m_resolution = deviation(contributions, resolutionId) * rootOfTwelve;
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
        for (const auto &circle : circlesOf(*listed[k].row, measurement)) {
            if (std::ranges::find(m_circles, circle) == m_circles.end())
                m_circles.push_back(circle);
        }
    }

    std::uint32_t place = firstPointPlace;
    double low = 0;
    double high = 0;
    std::size_t points = 0;
    for (const EvaluatedPath &path : m_results.paths) {
        const Arc &arc = measurement.arcs[path.arc];
        Part part{path.arc, {}, {}, {}, place};
        for (const std::size_t i : path.source) {
            part.angles.push_back(arc.angles[i]);
            part.directions.push_back(direction(arc.angles[i]));
            part.deviations.push_back(arc.radialDeviations[i]);
            low = points == 0 ? part.deviations.back() : std::min(low, part.deviations.back());
            high = points == 0 ? part.deviations.back() : std::max(high, part.deviations.back());
            ++points;
        }
        place += static_cast<std::uint32_t>((part.angles.size() / pointsPerStep + 1) * 4);
        m_parts.push_back(std::move(part));
    }
    for (const std::size_t k : m_results.repetitions) {
        const Arc &arc = measurement.arcs[k];
        const auto range = iso230_4::evaluatedRange(arc);
        if (arc.angleReference != AngleReference::commanded || !range)
            continue;
        Part part{k, {}, {}, {}, 0};
        for (std::size_t i = 0; i < arc.angles.size(); ++i) {
            if (arc.angles[i] < range->from || arc.angles[i] > range->to)
                continue;
            part.angles.push_back(arc.angles[i]);
            part.directions.push_back(direction(arc.angles[i]));
            part.deviations.push_back(measurement.nominalRadius + arc.radialDeviations[i]);
        }
        m_repeated.push_back(std::move(part));
    }
    m_middle = (low + high) / 2;
    m_scale = high > low ? m_zero / (high - low) : 0;
    constexpr std::size_t pointsPerChunk = 50000; // some milliseconds
    constexpr std::size_t mostOfChunk = 50;
    m_chunk = static_cast<int>(
        std::clamp<std::size_t>(pointsPerChunk / std::max<std::size_t>(points, 1), 1, mostOfChunk));
}

CircularTrials::Workplace CircularTrials::workplace() const {
    Workplace result{std::make_shared<CircularMeasurement>(m_measurement),
                     std::make_shared<CircularResults>(m_results),
                     {}};
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

void CircularTrials::perturb(long long trial, std::size_t index, const Common &all, Workplace &place) const {
    const Part &part = m_parts[index];
    const std::size_t n = part.deviations.size();
    std::vector<double> &errors = place.errors;
    errors.assign(n + pointsPerStep, 0);
    if (m_noise > 0 || m_resolution > 0) {
        std::uint32_t next = part.place;
        for (std::size_t i = 0; i < n; i += pointsPerStep, next += 4) {
            const auto words = m_draws.places(trial, next);
            for (std::size_t half = 0; half < 2; ++half) {
                Lanes error = m_resolution / 2 * RandomDraws::symmetric(words[2 + half]);
                if (m_noise > 0)
                    error += m_noise * RandomDraws::normal(words[half]);
                const auto values = error.values();
                std::ranges::copy(values, errors.begin() + static_cast<std::ptrdiff_t>(i + half * 4));
            }
        }
    }
    const double common = all.drift[index % 2] + all.zero;
    auto &deviations = place.measurement->arcs[part.arc].radialDeviations;
    const auto &source = m_results.paths[index].source;
    for (std::size_t i = 0; i < n; ++i) {
        const double d = part.deviations[i];
        const Point u = part.directions[i];
        deviations[source[i]] = d + (common + all.scale * (d - m_middle) -
                                     (all.centring.x * u.x + all.centring.y * u.y) + errors[i]);
    }
}

bool CircularTrials::wanted(CircleOf of, ReferenceCircle kind) const {
    return std::ranges::find(m_circles, std::pair{of, kind}) != m_circles.end();
}

bool CircularTrials::evaluate(Workplace &place, const std::stop_token &stop) const {
    const double radius = m_measurement.nominalRadius;
    std::vector<std::vector<double>> distances(m_parts.size());
    std::vector<CommandedArc> commanded;
    for (std::size_t k = 0; k < m_parts.size(); ++k) {
        const Part &part = m_parts[k];
        const auto &deviations = place.measurement->arcs[part.arc].radialDeviations;
        distances[k].reserve(part.angles.size());
        for (const std::size_t i : m_results.paths[k].source)
            distances[k].push_back(radius + deviations[i]);
    }
    // The arcs in the order of time, as `paths` takes them.
    std::vector<std::pair<std::size_t, CommandedArc>> inOrder;
    for (std::size_t k = 0; k < m_parts.size(); ++k) {
        if (m_measurement.arcs[m_parts[k].arc].angleReference == AngleReference::commanded)
            inOrder.push_back({m_parts[k].arc, {m_parts[k].angles, distances[k], m_parts[k].directions}});
    }
    for (const Part &part : m_repeated)
        inOrder.push_back({part.arc, {part.angles, part.deviations, part.directions}});
    std::ranges::sort(inOrder, {}, &std::pair<std::size_t, CommandedArc>::first);
    for (const auto &[arc, path] : inOrder)
        commanded.push_back(path);
    CircularResults &results = *place.results;
    results.centringError.reset();
    if (!commanded.empty()) {
        const CentringError error = centringError(commanded);
        if (error.valid())
            results.centringError = error.e;
    }
    for (std::size_t k = 0; k < m_parts.size(); ++k) {
        const Part &part = m_parts[k];
        Points &points = results.paths[k].points;
        if (m_measurement.arcs[part.arc].angleReference == AngleReference::commanded &&
            results.centringError) {
            points = rebuildPoints({part.angles, distances[k], part.directions}, *results.centringError);
            continue;
        }
        points.x.resize(part.angles.size());
        points.y.resize(part.angles.size());
        for (std::size_t i = 0; i < part.angles.size(); ++i) {
            points.x[i] = distances[k][i] * part.directions[i].x;
            points.y[i] = distances[k][i] * part.directions[i].y;
        }
    }
    results.circles = iso230_4::circles(results.paths, [&](CircleOf of, ReferenceCircle kind) {
        return !stop.stop_requested() && wanted(of, kind);
    });
    return !stop.stop_requested();
}

void CircularTrials::run(long long first, Workplace &place, std::span<double> values,
                         const std::stop_token &stop) const {
    const auto trials = static_cast<std::size_t>(m_chunk);
    const CircularCase whole{m_test, *place.measurement, m_surroundings, m_edition, *place.results};
    for (std::size_t k = 0; k < trials; ++k) {
        const long long trial = first + static_cast<long long>(k);
        const Common all = common(trial);
        for (std::size_t part = 0; part < m_parts.size(); ++part)
            perturb(trial, part, all, place);
        if (!evaluate(place, stop))
            return;
        place.results->correction = m_results.correction.value_or(0) + all.correction;
        const auto listed = iso230_4::listedParameters(whole);
        for (std::size_t p = 0; p < m_listed.size(); ++p) {
            const auto found = iso230_4::value(listed[m_listed[p]], whole);
            const RandomDraws::Words words =
                m_draws.words(trial, repeatabilityPlace + static_cast<std::uint32_t>(p));
            // A circle that noise makes impossible says nothing of Y.
            values[p * trials + k] =
                found.value_or(m_parameters[p].value) + m_repeatability[p] * RandomDraws::normal(words[0]);
        }
    }
}

CircularMeasurement CircularTrials::perturbed(long long trial) const {
    Workplace place = workplace();
    const Common all = common(trial);
    for (std::size_t part = 0; part < m_parts.size(); ++part)
        perturb(trial, part, all, place);
    return *place.measurement;
}

} // namespace palmer
