// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/diagnosis/diagnosis.h"

#include "kernel/diagnosis/agreement.h"
#include "kernel/diagnosis/influencefit.h"
#include "kernel/diagnosis/residualtest.h"
#include "kernel/diagnosis/sourcewords.h"
#include "kernel/diagnosis/stepoffsets.h"
#include "kernel/diagnosis/traces.h"
#include "kernel/evaluation/iso230_4/circles.h"
#include "kernel/numerics/angles.h"
#include "kernel/numerics/minimumzone.h"
#include "kernel/numerics/studentt.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace palmer {

namespace {

using Vector = Eigen::VectorXd;

constexpr std::size_t fewestPoints = 30;

bool isUsable(const DiagnosedCircle &circle) {
    const auto matches = [](const DiagnosedArc &arc) { return arc.angles.size() == arc.points.size(); };
    return circle.nominalRadius > 0 && std::isfinite(circle.nominalRadius) &&
           (!circle.feed || (*circle.feed > 0 && std::isfinite(*circle.feed))) &&
           std::ranges::all_of(circle.arcs, matches);
}

std::vector<FitTerm> basicTerms(std::size_t circles, bool severalFeeds, const DiagnosisOptions &options,
                                bool bothSenses) {
    std::vector<FitTerm> terms;
    for (std::size_t k = 0; k < circles; ++k) {
        for (const PlaneAxis axis : {PlaneAxis::first, PlaneAxis::second})
            terms.push_back({InfluenceId::centre, axis, false, 0, k});
    }
    const auto add = [&terms](InfluenceId id) {
        if (influence(id).ofAxis) {
            terms.push_back({id, PlaneAxis::first});
            terms.push_back({id, PlaneAxis::second});
        } else {
            terms.push_back({id, PlaneAxis::none});
        }
    };
    for (const InfluenceId id : {InfluenceId::radius, InfluenceId::scaleMismatch, InfluenceId::squareness,
                                 InfluenceId::servoMismatch, InfluenceId::backlash, InfluenceId::lateralPlay,
                                 InfluenceId::straightness})
        add(id);
    if (severalFeeds) {
        add(InfluenceId::commonLag);
        add(InfluenceId::lagMismatch);
    }
    const auto append = [&terms](const std::vector<FitTerm> &more) {
        terms.insert(terms.end(), more.begin(), more.end());
    };
    for (const PlaneAxis axis : {PlaneAxis::first, PlaneAxis::second}) {
        if (options.spikeWidth)
            append(spikeTerms(axis, *options.spikeWidth, true));
        if (const auto pitch = options.pitch[axis == PlaneAxis::second])
            append(cyclicTerms(axis, *pitch));
    }
    if (options.drift)
        append(driftTerms(options, bothSenses));
    return terms;
}

double coverageFactor(double degreesOfFreedom, double probability) {
    constexpr double most = 1e6;
    return studentQuantile(probability, static_cast<int>(std::min(degreesOfFreedom, most)));
}

std::string planeName(const DiagnosedCircle &circle) {
    return circle.first + "–" + circle.second;
}

/// Returns the minimum zone width of a trace (one value per row of the circle) about the nominal radius, mm.
double zoneOf(const PathRows &rows, std::size_t circle, const Vector &trace) {
    std::vector<double> x;
    std::vector<double> y;
    for (const ArcRows &arc : rows.arcs()) {
        if (arc.circle != circle)
            continue;
        for (std::size_t i = arc.record.begin; i < arc.record.begin + arc.record.size; ++i) {
            const PathPosition &p = rows.positions()[i];
            const double r = p.radius + trace[Eigen::Index(i)];
            x.push_back(r * p.cosine);
            y.push_back(r * p.sine);
        }
    }
    const MinimumZone zone = minimumZone({x, y});
    return zone.valid() ? zone.width : 0;
}

/// Returns the standard deviation of the part of the readings that no source explains.
double restOf(const DiagnosedCircle &circle, const Diagnosis &diagnosis) {
    double squares = 0;
    std::size_t count = 0;
    for (const std::vector<double> &curve : unexplained(circle, diagnosis)) {
        for (const double value : curve)
            squares += value * value;
        count += curve.size();
    }
    return std::sqrt(squares / static_cast<double>(count));
}

/// Builds the diagnosis from a finished fit.
class Assembly {
public:
    Assembly(std::span<const DiagnosedCircle> circles, const PathRows &rows, const InfluenceFit &fit,
             std::vector<Point> centres, const Agreement &agreement)
        : m_circles(circles)
        , m_rows(rows)
        , m_fit(fit)
        , m_centres(std::move(centres))
        , m_agreement(agreement) {}

    Diagnosis diagnosis(const std::vector<FoundInfluence> &found) {
        m_diagnosis.first = m_circles.front().first;
        m_diagnosis.second = m_circles.front().second;
        m_diagnosis.reasons = misfits(m_rows, m_fit);
        if (m_agreement.stepBetweenSenses)
            m_diagnosis.reasons.push_back({REPORT_TEXT("report", "a step of the radius between the senses")});
        m_diagnosis.modelFits = m_diagnosis.reasons.empty();
        m_diagnosis.rank = m_fit.fit.rank;
        m_diagnosis.of = static_cast<int>(m_fit.terms.size());
        m_diagnosis.condition = m_fit.fit.condition;
        m_diagnosis.residual = m_fit.residual;
        m_diagnosis.readingsPerIndependent = m_fit.noise.readingsPerIndependent();
        m_diagnosis.points = m_rows.used();
        for (std::size_t j = 0; j < m_fit.terms.size(); ++j) {
            m_diagnosis.toldApart += m_fit.isSeparable(j) ? 1 : 0;
            if (isListed(m_fit.terms[j]))
                addSource(j, found);
        }
        order();
        findPartners();
        return std::move(m_diagnosis);
    }

private:
    [[nodiscard]] bool isListed(const FitTerm &term) const {
        return !term.second && (term.id != InfluenceId::centre || m_circles.size() == 1);
    }
    /// True if a term is followed by its second column.
    [[nodiscard]] bool hasSecond(std::size_t term) const {
        return term + 1 < m_fit.terms.size() && m_fit.terms[term + 1].second;
    }

    [[nodiscard]] std::string nameOf(PlaneAxis axis) const {
        const DiagnosedCircle &circle = m_circles.front();
        return axis == PlaneAxis::none    ? planeName(circle)
               : axis == PlaneAxis::first ? circle.first
                                          : circle.second;
    }

    /// Returns what the fitted points lack of a centre: that of their circle and of the set-up, mm.
    [[nodiscard]] double takenOut(const FitTerm &term) const {
        if (term.id != InfluenceId::centre)
            return 0;
        const Point &setUp = m_circles.front().setUp;
        return term.axis == PlaneAxis::first ? m_centres.front().x + setUp.x : m_centres.front().y + setUp.y;
    }

    void addSource(std::size_t j, const std::vector<FoundInfluence> &found) {
        const FitTerm &term = m_fit.terms[j];
        SourceEstimate source;
        source.id = term.id;
        source.axis = term.axis;
        source.axisName = nameOf(term.axis);
        source.shape = term.shape;
        source.fitted[0] = m_fit.factor(j);
        source.separable = m_fit.isSeparable(j);
        Vector weights = Vector::Unit(Eigen::Index(m_fit.terms.size()), Eigen::Index(j));
        double value = source.fitted[0];
        if (hasSecond(j) && term.id != InfluenceId::reversalSpike)
            source.fitted[1] = m_fit.factor(j + 1);
        if (term.id == InfluenceId::cyclic) {
            source.separable = source.separable && m_fit.isSeparable(j + 1);
            value = std::hypot(source.fitted[0], source.fitted[1]);
            if (value > 0) {
                weights[Eigen::Index(j)] = source.fitted[0] / value;
                weights[Eigen::Index(j + 1)] = source.fitted[1] / value;
            }
            source.phase = std::atan2(source.fitted[1], source.fitted[0]);
            source.pitch = term.shape;
        }
        if (term.id == InfluenceId::reversalSpike)
            source.width = term.shape;
        if (term.id == InfluenceId::radiusDrift && hasSecond(j))
            source.step = source.fitted[1];
        value += takenOut(term);
        for (const FoundInfluence &one : found) {
            if (one.id == term.id && one.axis == term.axis) {
                source.proposed = true;
                source.significance = one.significance;
                addAlternatives(source, one);
            }
        }
        const std::vector<Message> &objections = m_agreement.objections[j];
        source.reasons.insert(source.reasons.end(), objections.begin(), objections.end());
        source.indication = !m_diagnosis.modelFits || !source.reasons.empty();
        if (source.separable) {
            const bool needsFeed = term.id == InfluenceId::servoMismatch;
            if (!needsFeed || m_circles.front().feed) {
                source.value = value;
                source.u = m_fit.u(weights);
            }
            source.degreesOfFreedom = m_fit.degreesOfFreedom(weights);
            source.contribution = contribution({j});
            if (source.u && *source.contribution > 0)
                source.u = std::max(*source.u, byResolution() * std::abs(value) / *source.contribution);
        }
        m_terms.push_back(j);
        m_diagnosis.sources.push_back(std::move(source));
    }

    void addAlternatives(SourceEstimate &source, const FoundInfluence &found) const {
        for (const FitTerm &other : found.alternatives)
            source.reasons.push_back(
                {REPORT_TEXT("report", "A periodic deviation of %1 with a pitch of %2 explains it as well."),
                 {other.axis == PlaneAxis::first ? m_circles.front().first : m_circles.front().second,
                  Number{other.shape, Quantity::position, 1}}});
    }

    /// Returns what the resolution leaves open of a height that four reversals, or quarters, show, mm.
    [[nodiscard]] double byResolution() const { return m_circles.front().resolution / std::sqrt(12.0 * 4); }

    /// Returns the contribution to G(b) of the circle where it is largest; G excludes centre and radius.
    [[nodiscard]] double contribution(const std::vector<std::size_t> &terms) const {
        const auto moves = [&](std::size_t j) {
            return m_fit.terms[j].id != InfluenceId::centre && m_fit.terms[j].id != InfluenceId::radius;
        };
        if (std::ranges::none_of(terms, moves))
            return 0;
        Vector trace = Vector::Zero(m_rows.size());
        for (const std::size_t j : terms) {
            const bool both = hasSecond(j) && m_fit.terms[j].id != InfluenceId::reversalSpike;
            for (std::size_t k = j; k <= j + (both ? 1 : 0); ++k) {
                const double factor = m_fit.factor(k);
                for (Eigen::Index i = 0; i < trace.size(); ++i)
                    trace[i] += factor * columnValue(m_fit.terms[k], m_rows.positions()[std::size_t(i)]);
            }
        }
        double largest = 0;
        for (std::size_t circle = 0; circle < m_circles.size(); ++circle)
            largest = std::max(largest, zoneOf(m_rows, circle, trace));
        return largest;
    }

    /// Sorts sources by contribution; inseparable ones follow, centre and radius come last.
    void order() {
        const auto key = [&](std::size_t i) {
            const SourceEstimate &source = m_diagnosis.sources[i];
            const bool last = source.id == InfluenceId::centre || source.id == InfluenceId::radius;
            return std::pair(last ? 2 : source.contribution ? 0 : 1, -source.contribution.value_or(0));
        };
        std::vector<std::size_t> places(m_diagnosis.sources.size());
        std::iota(places.begin(), places.end(), std::size_t(0));
        std::ranges::stable_sort(places, [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
        std::vector<SourceEstimate> sorted;
        std::vector<std::size_t> terms;
        for (const std::size_t i : places) {
            sorted.push_back(std::move(m_diagnosis.sources[i]));
            terms.push_back(m_terms[i]);
        }
        m_diagnosis.sources = std::move(sorted);
        m_terms = std::move(terms);
    }

    /// Finds groups of sources that cannot be separated, and the known sum of each group.
    void findPartners() {
        std::vector<std::size_t> apart;
        for (std::size_t i = 0; i < m_terms.size(); ++i) {
            if (!m_diagnosis.sources[i].separable)
                apart.push_back(i);
        }
        while (!apart.empty()) {
            const std::vector<std::size_t> group = takeGroup(apart);
            for (const std::size_t i : group) {
                for (const std::size_t other : group) {
                    if (other != i)
                        m_diagnosis.sources[i].with.push_back(other);
                }
            }
            if (group.size() > 1)
                addSum(group);
        }
    }

    /// Takes the first of the sources and all linked to it, directly or through others.
    [[nodiscard]] std::vector<std::size_t> takeGroup(std::vector<std::size_t> &apart) const {
        std::vector<std::size_t> group{apart.front()};
        apart.erase(apart.begin());
        for (std::size_t k = 0; k < group.size(); ++k) {
            const auto linked = std::stable_partition(apart.begin(), apart.end(), [&](std::size_t other) {
                return !areLinked(m_terms[group[k]], m_terms[other]);
            });
            group.insert(group.end(), linked, apart.end());
            apart.erase(linked, apart.end());
        }
        std::ranges::sort(group);
        return group;
    }

    /// True if one can replace the other, at least partly: in the null space, or with almost the same column.
    [[nodiscard]] bool areLinked(std::size_t a, std::size_t b) const {
        const ColumnFit &fit = m_fit.fit;
        const auto i = Eigen::Index(a);
        const auto j = Eigen::Index(b);
        if (std::abs(fit.hidden.row(i).dot(fit.hidden.row(j))) > 1e-6)
            return true;
        constexpr double close = 0.8; // correlation of the estimates
        return std::abs(fit.toScaled.row(i).dot(fit.toScaled.row(j))) >
               close * fit.inflation(i) * fit.inflation(j);
    }

    /// Adds the best determined combination of the group: the eigenvector of the largest eigenvalue of its
    /// information after all other columns are fitted.
    void addSum(const std::vector<std::size_t> &group) {
        const auto n = Eigen::Index(group.size());
        const Eigen::MatrixXd gram = information(group);
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(gram);
        const Vector best = eigen.eigenvectors().col(n - 1);
        Eigen::Index leading = 0;
        while (leading + 1 < n && std::abs(best[leading]) < 0.3 * best.cwiseAbs().maxCoeff())
            ++leading;
        SourceSum sum;
        Vector weights = Vector::Zero(Eigen::Index(m_fit.terms.size()));
        std::vector<std::size_t> terms;
        const auto unitOf = [&](Eigen::Index i) {
            return fittedUnit(m_diagnosis.sources[group[std::size_t(i)]].id);
        };
        const double shown = unitOf(leading).perBase;
        const auto weight = [&](Eigen::Index i) {
            const auto term = Eigen::Index(m_terms[group[std::size_t(i)]]);
            return best[i] * m_fit.fit.lengths[term];
        };
        for (Eigen::Index i = 0; i < n; ++i) {
            const std::size_t source = group[std::size_t(i)];
            terms.push_back(m_terms[source]);
            if (std::abs(best[i]) < 1e-3 * std::abs(best[leading]))
                continue;
            const double factor = weight(i) / weight(leading);
            weights[Eigen::Index(m_terms[source])] = factor;
            const SourceSum::Part part{source, factor * shown / unitOf(i).perBase, unitOf(i).name};
            if (i == leading)
                sum.of.insert(sum.of.begin(), part);
            else
                sum.of.push_back(part);
        }
        double value = 0;
        for (std::size_t j = 0; j < m_fit.terms.size(); ++j)
            value += weights[Eigen::Index(j)] * (m_fit.factor(j) + takenOut(m_fit.terms[j]));
        sum.value = value * shown;
        sum.u = m_fit.u(weights) * shown;
        const double half = coverageFactor(m_fit.degreesOfFreedom(weights), 0.975) * sum.u;
        if (m_diagnosis.modelFits)
            sum.interval = {sum.value - half, sum.value + half};
        sum.contribution = contribution(terms);
        m_diagnosis.sums.push_back(std::move(sum));
    }

    struct Unit {
        const char *name = nullptr;
        double perBase = 1;
    };

    /// Returns the unit of a parameter as it is in the fit, which sums need.
    [[nodiscard]] Unit fittedUnit(InfluenceId id) const {
        if (id == InfluenceId::commonLag) // shown as its root
            id = InfluenceId::lagMismatch;
        else if (id == InfluenceId::servoMismatch && !m_circles.front().feed) // fitted with a feed of 1 mm/s
            id = InfluenceId::backlash;
        return {influence(id).unit, influence(id).unitsPerBase};
    }

    /// Returns the information on the scaled coefficients of the group while all others are free.
    [[nodiscard]] Eigen::MatrixXd information(const std::vector<std::size_t> &group) const {
        const Eigen::Index p = m_fit.fit.toScaled.rows();
        // The scaled columns in the basis: (Mᵀ)⁺ = the transpose of the pseudo-inverse of M.
        const Eigen::MatrixXd inBasis = m_fit.fit.toScaled.completeOrthogonalDecomposition().pseudoInverse();
        std::vector<Eigen::Index> own;
        std::vector<Eigen::Index> others;
        for (Eigen::Index j = 0; j < p; ++j) {
            const bool inside =
                std::ranges::any_of(group, [&](std::size_t i) { return Eigen::Index(m_terms[i]) == j; });
            (inside ? own : others).push_back(j);
        }
        Eigen::MatrixXd mine(inBasis.rows(), Eigen::Index(group.size()));
        for (std::size_t i = 0; i < group.size(); ++i)
            mine.col(Eigen::Index(i)) = inBasis.col(Eigen::Index(m_terms[group[i]]));
        Eigen::MatrixXd rest(inBasis.rows(), Eigen::Index(others.size()));
        for (std::size_t i = 0; i < others.size(); ++i)
            rest.col(Eigen::Index(i)) = inBasis.col(others[i]);
        if (rest.cols() > 0)
            mine -= rest * rest.completeOrthogonalDecomposition().solve(mine);
        return mine.transpose() * mine;
    }

    std::span<const DiagnosedCircle> m_circles;
    const PathRows &m_rows;
    const InfluenceFit &m_fit;
    std::vector<Point> m_centres;
    const Agreement &m_agreement;
    std::vector<std::size_t> m_terms; ///< per source
    Diagnosis m_diagnosis;
};

} // namespace

std::optional<Interval> SourceEstimate::interval() const {
    if (!value || !u || indication)
        return std::nullopt;
    const double k = coverageFactor(degreesOfFreedom, 0.975);
    return Interval{*value - k * *u, *value + k * *u};
}

bool SourceEstimate::isSeen() const {
    return interval() && std::abs(*value) > coverageFactor(degreesOfFreedom, 0.9995) * *u;
}

bool Rotation::isStated() const {
    constexpr double least = 0.05; // degrees
    return angle && std::abs(*angle) > std::max(least, bound);
}

double shownUncertainty(const SourceEstimate &source) {
    const double u = source.u.value_or(0);
    const double unit = influence(source.id).unitsPerBase;
    if (source.id != InfluenceId::commonLag || !(u > 0))
        return u * unit;
    const double root = std::sqrt(std::abs(source.value.value_or(0)));
    return u / (2 * std::max(root, std::sqrt(u) / 2)) * unit;
}

std::optional<double> shownExpanded(const SourceEstimate &source) {
    if (!source.interval())
        return std::nullopt;
    return coverageFactor(source.degreesOfFreedom, 0.975) * shownUncertainty(source);
}

const SourceEstimate *Diagnosis::find(InfluenceId id, PlaneAxis axis) const {
    const auto found =
        std::ranges::find_if(sources, [&](const SourceEstimate &s) { return s.id == id && s.axis == axis; });
    return found == sources.end() ? nullptr : &*found;
}

namespace {

/// Returns the step of a lattice on which the first readings of all arcs lie, mm; 0 if there is none.
double resolutionOf(const std::vector<Arc> &arcs) {
    constexpr std::size_t most = 4000;
    constexpr double finest = 1e-8;
    std::vector<double> readings;
    for (const Arc &arc : arcs)
        readings.insert(readings.end(), arc.radialDeviations.begin(),
                        arc.radialDeviations.begin() +
                            std::ptrdiff_t(std::min(most, arc.radialDeviations.size())));
    std::ranges::sort(readings);
    double step = 0;
    for (std::size_t i = 1; i < readings.size(); ++i) {
        const double difference = readings[i] - readings[i - 1];
        if (difference > finest && (step == 0 || difference < step))
            step = difference;
    }
    const auto isOn = [&](double reading) {
        constexpr double alike = 1e-3;
        return std::abs(std::remainder(reading - readings.front(), step)) < alike * step;
    };
    return step > 0 && std::ranges::all_of(readings, isOn) ? step : 0;
}

} // namespace

DiagnosedCircle diagnosedCircle(const CircularMeasurement &measurement, const CircularResults &results) {
    DiagnosedCircle circle;
    circle.first = measurement.plane.first;
    circle.second = measurement.plane.second;
    circle.nominalRadius = measurement.nominalRadius;
    constexpr double secondsPerMinute = 60;
    if (measurement.feed)
        circle.feed = *measurement.feed / secondsPerMinute;
    circle.feedback = measurement.source == SignalSource::feedback;
    circle.resolution = resolutionOf(measurement.arcs);
    for (const EvaluatedPath &path : results.paths) {
        const Arc &arc = measurement.arcs[path.arc];
        DiagnosedArc one{path.sense, path.points.view(), {}, arc.angleReference == AngleReference::commanded};
        one.angles.reserve(path.source.size());
        for (const std::size_t point : path.source)
            one.angles.push_back(arc.angles[point]);
        circle.arcs.push_back(std::move(one));
    }
    const CircleOf of =
        results.paths.size() == 1 ? iso230_4::circleOf(results.paths.front().sense) : CircleOf::both;
    if (const CircleResult *fitted = results.circle(of, ReferenceCircle::leastSquares))
        circle.centre = fitted->centre;
    if (results.centringError)
        circle.setUp = {-results.centringError->x, -results.centringError->y};
    return circle;
}

bool areSeveralFeeds(std::span<const DiagnosedCircle> circles) {
    if (circles.size() < 2)
        return false;
    const DiagnosedCircle &one = circles.front();
    const auto same = [&](const DiagnosedCircle &c) {
        return c.first == one.first && c.second == one.second && c.feed.has_value() &&
               c.feedback == one.feedback && std::abs(c.nominalRadius - one.nominalRadius) <= 1e-6;
    };
    const auto other = [&](const DiagnosedCircle &c) {
        return std::abs(*c.feed - *one.feed) > 0.01 * *one.feed;
    };
    return std::ranges::all_of(circles, same) && std::ranges::any_of(circles, other);
}

namespace {

constexpr double leastLag = 0.05;         ///< degrees
constexpr double usualRegistration = 0.1; ///< u of the angles where no step shows them, degrees
constexpr double usualStart = 0.5;        ///< the same where the start was entered
constexpr double leastLeftOut = 0.1;      ///< degrees from a reversal
constexpr double mostLeftOut = 1;

/// The facts that the arcs of all circles share.
struct Ground {
    std::vector<Point> centres; ///< mm, one a circle
    bool commanded = false;     ///< angles of at least one arc
    bool bothSenses = false;
};

/// Null if a circle has no centre.
std::optional<Ground> groundOf(std::span<const DiagnosedCircle> circles) {
    Ground ground;
    std::array<bool, 2> senses{};
    for (const DiagnosedCircle &circle : circles) {
        const auto centre = centreOf(circle);
        if (!centre || !std::isfinite(centre->x) || !std::isfinite(centre->y))
            return std::nullopt;
        ground.centres.push_back(*centre);
        for (const DiagnosedArc &arc : circle.arcs) {
            ground.commanded |= arc.commanded;
            senses[arc.sense == Sense::clockwise] |= arc.points.size() > 0;
        }
    }
    ground.bothSenses = senses[0] && senses[1];
    return ground;
}

} // namespace

Diagnosis diagnose(const DiagnosedCircle &circle, const DiagnosisOptions &options) {
    return diagnose(std::span(&circle, 1), options);
}

Diagnosis diagnose(std::span<const DiagnosedCircle> circles, const DiagnosisOptions &options) {
    const bool severalFeeds = areSeveralFeeds(circles);
    if (circles.empty() || (circles.size() > 1 && !severalFeeds) || !std::ranges::all_of(circles, isUsable))
        return {};
    const std::optional<Ground> ground = groundOf(circles);
    if (!ground)
        return {};
    const auto &[centres, commanded, bothSenses] = *ground;
    const double pause = options.pause.value_or(0);
    PathRows rows(circles, centres, 0, pause);
    const std::vector<FitTerm> terms = basicTerms(circles.size(), severalFeeds, options, bothSenses);
    if (rows.used() < std::max(fewestPoints, 2 * terms.size()) || !rows.deviations().allFinite())
        return {};
    StepOffsets steps;
    double lagAngle = 0;
    double turned = 0;
    for (int turn = 0; turn < 4; ++turn) { // far offsets bend what is smooth, too
        const PathRows far(circles, centres, lagAngle, pause, stepReach, turned);
        if (far.used() < std::max(fewestPoints, 2 * terms.size()))
            break;
        if (turn > 0)
            rows = PathRows(circles, centres, lagAngle, pause, leastLeftOut, turned);
        steps = stepOffsets(rows, InfluenceFit(far, terms), commanded);
        steps.lag += lagAngle;
        if (steps.rotation.angle)
            *steps.rotation.angle += turned;
        const double before = std::abs(lagAngle) + std::abs(turned);
        lagAngle = commanded && std::abs(steps.lag) > std::max(leastLag, steps.lagBound) ? steps.lag : 0;
        turned = steps.rotation.removed();
        constexpr double little = 0.3; // degrees
        if (std::abs(std::abs(lagAngle) + std::abs(turned) - before) < little)
            break;
    }
    // As far as the steps show it; nearer readings may lie on the other side.
    const double turnedBy = steps.rotation.angle
                                ? steps.rotation.u
                                : std::max(steps.rotation.u, commanded ? usualStart : usualRegistration);
    if (steps.seen)
        rows = PathRows(circles, centres, lagAngle, pause,
                        std::clamp(2 * turnedBy, leastLeftOut, mostLeftOut), turned);
    InfluenceFit fit(rows, terms);
    std::vector<FoundInfluence> found;
    if (options.search)
        found = searchInfluences(rows, options, fit, steps.rotation.isStated());
    const Agreement agreed = agreement(rows, fit);
    fit.turnBy(rows, turnedBy * degree);
    Diagnosis result = Assembly(circles, rows, fit, centres, agreed).diagnosis(found);
    result.rotation = steps.rotation;
    result.lagAngle = lagAngle;
    result.pause = pause;
    const bool fittedMeans =
        std::ranges::any_of(rows.arcs(), [](const ArcRows &arc) { return arc.perRow > 1; });
    if (fittedMeans && circles.size() == 1)
        result.residual = restOf(circles.front(), result); // averaged rows scatter less
    result.remarks = diagnosisRemarks(circles, options, result);
    return result;
}

} // namespace palmer
