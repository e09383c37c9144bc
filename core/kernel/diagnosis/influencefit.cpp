// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/diagnosis/influencefit.h"

#include "kernel/diagnosis/agreement.h"
#include "kernel/diagnosis/pitchscan.h"
#include "kernel/diagnosis/residualtest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace palmer {

namespace {

using Vector = Eigen::VectorXd;

constexpr double mostHidden = 1e-6;
constexpr double mostInflated = 10;
constexpr double mostByChance = 1e-3; ///< probability
constexpr double worthATrial = 1e-2;  ///< probability, from the quick test

/// Pitches of screws and racks, mm, including inch sizes.
constexpr std::array plausiblePitches{1.0,  2.0,  2.5,  3.0,  4.0,  5.0,  5.08, 6.0,  6.35, 8.0,  10.0,
                                      12.0, 12.7, 15.0, 16.0, 20.0, 25.0, 25.4, 30.0, 32.0, 40.0, 50.0};
/// Widths of spikes, degrees; each half of the previous one.
constexpr std::array plausibleWidths{8.0, 4.0, 2.0, 1.0, 0.5};

struct Candidate {
    std::vector<FitTerm> terms;
    double score = 0; ///< explained part of the sum of squares / noise variance in its band
    double explained = 0;
    double noise = 0;
};

/// Bound of what else explains as much, in noise variances: 95 % of χ² with one degree of freedom.
constexpr double asGood = 3.84;
constexpr double widestSpike = 20; ///< degrees

bool has(const std::vector<FitTerm> &terms, InfluenceId id, PlaneAxis axis) {
    return std::ranges::any_of(terms, [&](const FitTerm &t) { return t.id == id && t.axis == axis; });
}

/// Returns the narrowest spike, in degrees, whose height can be determined: enough of it lies between the
/// readings and outside the omitted reversals.
double narrowestSpike(const PathRows &rows) {
    constexpr double beyondReversals = 0.3;
    return std::max(beyondReversals, 1.5 * rows.step() * 180 / std::numbers::pi);
}

constexpr std::array axes{PlaneAxis::first, PlaneAxis::second};

double stated(const DiagnosisOptions &options, PlaneAxis axis) {
    return options.pitch[axis == PlaneAxis::second].value_or(0);
}

/// Candidates of the search, with the part of the residual each would explain.
class Search {
public:
    Search(const PathRows &rows, const DiagnosisOptions &options, bool onlyDrift)
        : m_rows(rows)
        , m_options(options)
        , m_onlyDrift(onlyDrift)
        , m_radius(rows.positions().empty() ? 0 : rows.positions().front().radius)
        , m_bothSenses(std::ranges::any_of(rows.positions(), [](const auto &p) { return p.sense > 0; }) &&
                       std::ranges::any_of(rows.positions(), [](const auto &p) { return p.sense < 0; })) {}

    /// Returns the best candidate; score 0 if there is none. `quiet`: against the noise of the fastest
    /// waves alone, for what is taken for slow noise as long as it is not fitted.
    Candidate best(const InfluenceFit &fit, bool quiet) {
        m_trials = 0;
        m_quiet = quiet;
        m_noise.clear();
        Candidate result;
        const auto keep = [&](Candidate candidate) {
            ++m_trials;
            if (candidate.score > result.score)
                result = std::move(candidate);
        };
        for (const PlaneAxis axis : axes) {
            if (m_onlyDrift)
                break;
            if (!m_options.spikeWidth && !has(fit.terms, InfluenceId::reversalSpike, axis))
                addSpikes(fit, axis, keep);
            if (stated(m_options, axis) == 0 && !has(fit.terms, InfluenceId::cyclic, axis))
                addPitches(fit, axis, keep);
        }
        if (!has(fit.terms, InfluenceId::radiusDrift, PlaneAxis::none))
            addDrift(fit, keep);
        return result;
    }

    /// Moves a periodic candidate to the pitch that explains most.
    void refine(const InfluenceFit &fit, Candidate &candidate) const {
        const FitTerm &term = candidate.terms.front();
        const PitchScan scan(m_rows, fit, term.axis);
        const double pitch = scan.refined(term.shape, plausiblePitches, asGood * candidate.noise);
        candidate.explained = scan.explainedBy(pitch);
        candidate.terms = cyclicTerms(term.axis, pitch);
    }

    /// Returns other periodic deviations, on either axis, that explain within the bound as much.
    [[nodiscard]] std::vector<FitTerm> asGoodAs(const InfluenceFit &fit, const Candidate &chosen) const {
        std::vector<FitTerm> result;
        const FitTerm &mine = chosen.terms.front();
        for (const Peak &peak : m_peaks) {
            constexpr double apart = 0.75; // periods over the radius; neighbours explain each other
            const bool same =
                peak.axis == mine.axis && std::abs(m_radius / peak.pitch - m_radius / mine.shape) < apart;
            if (!same && peak.explained > chosen.explained / 2 &&
                PitchScan(m_rows, fit, peak.axis).explainedBy(peak.pitch) >
                    chosen.explained - asGood * peak.noise)
                result.push_back({InfluenceId::cyclic, peak.axis, false, peak.pitch});
        }
        return result;
    }

    [[nodiscard]] int trials() const { return m_trials; }

private:
    /// Returns the noise in the band of a feature whose wave takes `angle` (rad).
    [[nodiscard]] double noiseOf(const InfluenceFit &fit, double angle) const {
        return m_quiet ? fit.noise.fastest() : fit.noise.variance(m_rows.step() / angle);
    }
    /// Like noiseOf(), in a band four times as wide: a feature not yet fitted counts as noise, and one only a
    /// few waves per turn long would otherwise hide itself.
    [[nodiscard]] double noiseAround(const InfluenceFit &fit, double angle) const {
        return noiseOf(fit, angle / 4);
    }

    /// Returns the part of the residual that each column explains alone, beyond what is already fitted.
    [[nodiscard]] static Vector explained(const InfluenceFit &fit, const Eigen::MatrixXd &columns) {
        const Vector along = columns.transpose() * fit.fit.residual;
        const Vector whole = columns.colwise().squaredNorm();
        const Vector rest =
            whole - Vector((fit.fit.basis.transpose() * columns).colwise().squaredNorm().transpose());
        return (rest.array() > 1e-9 * whole.array()).select(along.array().square() / rest.array(), 0);
    }

    template <class Keep>
    void addSpikes(const InfluenceFit &fit, PlaneAxis axis, const Keep &keep) const {
        constexpr auto count = static_cast<Eigen::Index>(plausibleWidths.size());
        Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(m_rows.size(), count);
        for (Eigen::Index i = 0; i < m_rows.size(); ++i) {
            if (!m_rows.counts(i))
                continue;
            // Each width is half of the previous one, so its column is the square.
            double value =
                std::exp(-sinceReversal(m_rows.positions()[std::size_t(i)], axis) / plausibleWidths[0]);
            for (Eigen::Index k = 0; k < count; ++k, value *= value)
                columns(i, k) = value;
        }
        const Vector scores = explained(fit, columns);
        for (Eigen::Index k = 0; k < count; ++k) {
            const double width = plausibleWidths[std::size_t(k)];
            const double angle = width * std::numbers::pi / 180;
            if (width >= narrowestSpike(m_rows))
                keep({spikeTerms(axis, width, false),
                      scores[k] / noiseAround(fit, 2 * std::numbers::pi * angle), scores[k]});
        }
    }

    template <class Keep>
    void addPitches(const InfluenceFit &fit, PlaneAxis axis, const Keep &keep) {
        std::erase_if(m_peaks, [&](const Peak &peak) { return peak.axis == axis; });
        const PitchScan scan(m_rows, fit, axis);
        Peak best;
        const std::vector<double> scores = scan.explained();
        while (m_noise.size() < scores.size()) // the same of both axes
            m_noise.push_back(noiseOf(fit, 1 / PitchScan::periods(m_noise.size())));
        for (std::size_t k = 1; k + 1 < scores.size(); ++k) {
            const double pitch = m_radius / PitchScan::periods(k);
            const double noise = m_noise[k];
            if (scores[k] / noise > best.explained / best.noise)
                best = {axis, pitch, scores[k], noise};
            if (scores[k] > scores[k - 1] && scores[k] >= scores[k + 1] && scores[k] > 2 * asGood * noise)
                m_peaks.push_back({axis, pitch, scores[k], noise});
        }
        m_trials += static_cast<int>(scores.size() / 2);
        // Fewer than two periods over the circle look like the shape of the guideway: the end of the range.
        if (!(best.pitch > 0) || best.pitch > m_radius)
            return;
        keep({cyclicTerms(axis, best.pitch), best.explained / best.noise, best.explained, best.noise});
    }

    template <class Keep>
    void addDrift(const InfluenceFit &fit, const Keep &keep) const {
        Vector column = Vector::Zero(m_rows.size());
        for (Eigen::Index i = 0; i < column.size(); ++i) {
            if (m_rows.counts(i))
                column[i] = m_rows.positions()[std::size_t(i)].turns;
        }
        const std::vector<FitTerm> terms = driftTerms(m_options, m_bothSenses);
        constexpr double eighth = std::numbers::pi / 4; // of a turn
        const double score = explained(fit, column)[0];
        keep({terms, score / noiseAround(fit, eighth), score});
    }

    struct Peak {
        PlaneAxis axis = PlaneAxis::none;
        double pitch = 0;
        double explained = 0;
        double noise = 1;
    };

    const PathRows &m_rows;
    const DiagnosisOptions &m_options;
    bool m_onlyDrift;
    double m_radius;
    bool m_bothSenses;
    bool m_quiet = false;
    int m_trials = 0;
    std::vector<double> m_noise; ///< in the band of each pitch of a scan
    std::vector<Peak> m_peaks;
};

/// Iterates the width of each free spike until it converges.
void refineWidths(const PathRows &rows, InfluenceFit &fit) {
    constexpr int turns = 8;
    std::vector<FitTerm> terms = fit.terms;
    std::optional<ColumnFit> refined;
    for (int turn = 0; turn < turns; ++turn) {
        const ColumnFit &last = refined ? *refined : fit.fit;
        bool moved = false;
        for (std::size_t j = 0; j + 1 < terms.size(); ++j) {
            if (terms[j].id != InfluenceId::reversalSpike || terms[j].second || !terms[j + 1].second)
                continue;
            const double height = last.coefficient(Eigen::Index(j));
            const double width = terms[j].shape;
            if (height == 0)
                continue;
            const double narrowest = narrowestSpike(rows);
            const double wanted = width + last.coefficient(Eigen::Index(j + 1)) / height;
            const double next =
                std::clamp(std::clamp(wanted, width * 0.7, width * 1.4), narrowest, widestSpike);
            moved |= std::abs(next - width) > 1e-4 * width;
            terms[j].shape = terms[j + 1].shape = next;
        }
        if (!moved)
            break;
        refined = columnFit(rows.columns(terms), rows.deviations());
        fit.terms = terms;
    }
    if (refined)
        fit = InfluenceFit(rows, std::vector<FitTerm>(fit.terms), std::move(*refined));
}

/// Returns the probability that noise alone makes as much of the candidate, the last terms of the fit.
double byChance(const InfluenceFit &fit, std::size_t firstTerm, int trials) {
    const FitTerm &term = fit.terms[firstTerm];
    double square = 0;
    if (term.id == InfluenceId::cyclic) {
        const double a = fit.factor(firstTerm) / fit.u(firstTerm);
        const double b = fit.factor(firstTerm + 1) / fit.u(firstTerm + 1);
        square = a * a + b * b;
    } else {
        square = std::pow(fit.factor(firstTerm) / fit.u(firstTerm), 2);
    }
    return std::min(1.0, trials * std::exp(-square / 2));
}

/// True if a width stayed where its range ends, or its last step is not small against the height.
bool isAtEnd(const PathRows &rows, const InfluenceFit &fit, std::size_t term) {
    const FitTerm &spike = fit.terms[term];
    constexpr double close = 1.001;
    constexpr double small = 0.1;
    return spike.id == InfluenceId::reversalSpike &&
           (spike.shape <= narrowestSpike(rows) * close || spike.shape >= widestSpike / close ||
            std::abs(fit.factor(term + 1)) > small * spike.shape * std::abs(fit.factor(term)));
}

double amplitude(const InfluenceFit &fit, std::size_t firstTerm) {
    if (fit.terms[firstTerm].id == InfluenceId::cyclic)
        return std::hypot(fit.factor(firstTerm), fit.factor(firstTerm + 1));
    return std::abs(fit.factor(firstTerm));
}

} // namespace

InfluenceFit::InfluenceFit(const PathRows &rows, std::vector<FitTerm> fitted)
    : InfluenceFit(rows, fitted, columnFit(rows.columns(fitted), rows.deviations())) {}

InfluenceFit::InfluenceFit(const PathRows &rows, std::vector<FitTerm> fitted, ColumnFit columns)
    : terms(std::move(fitted))
    , fit(std::move(columns))
    , noise(fit.basis, fit.residual, rows.records()) {
    const double freedom = static_cast<double>(rows.used()) - fit.rank;
    if (freedom > 0)
        residual = fit.residual.norm() / std::sqrt(freedom);
}

Vector InfluenceFit::basisWeights(const Vector &weights) const {
    return fit.toScaled.transpose() * weights.cwiseQuotient(fit.lengths);
}

double InfluenceFit::u(const Vector &weights) const {
    const Vector ofBasis = basisWeights(weights);
    return std::hypot(noise.standardUncertainty(ofBasis), m_turned.size() > 0 ? ofBasis.dot(m_turned) : 0);
}

double InfluenceFit::degreesOfFreedom(const Vector &weights) const {
    const Vector ofBasis = basisWeights(weights);
    const double part = noise.standardUncertainty(ofBasis) / u(weights);
    const double freedom = noise.degreesOfFreedom(ofBasis);
    return part > 0 ? freedom / std::pow(part, 4) : freedom; // Welch–Satterthwaite; the angle counts as known
}

void InfluenceFit::turnBy(const PathRows &rows, double uncertainty) {
    constexpr double little = 1e-4; // rad
    Vector change = Vector::Zero(rows.size());
    for (Eigen::Index i = 0; i < rows.size(); ++i) {
        if (!rows.counts(i))
            continue;
        const PathPosition &p = rows.positions()[std::size_t(i)];
        PathPosition turned = p;
        turned.cosine = p.cosine - little * p.sine;
        turned.sine = p.sine + little * p.cosine;
        for (std::size_t j = 0; j < terms.size(); ++j) {
            if (terms[j].id != InfluenceId::centre && terms[j].id != InfluenceId::cyclic)
                change[i] += factor(j) * (columnValue(terms[j], turned) - columnValue(terms[j], p));
        }
    }
    m_turned = fit.basis.transpose() * change * (uncertainty / little);
}

double InfluenceFit::u(std::size_t term) const {
    return u(Vector::Unit(Eigen::Index(terms.size()), Eigen::Index(term)));
}

bool InfluenceFit::isSeparable(std::size_t term) const {
    const auto j = Eigen::Index(term);
    return fit.hiddenPart(j) < mostHidden && fit.inflation(j) <= mostInflated;
}

std::vector<FitTerm> spikeTerms(PlaneAxis axis, double width, bool fixed) {
    std::vector<FitTerm> result{{InfluenceId::reversalSpike, axis, false, width}};
    if (!fixed)
        result.push_back({InfluenceId::reversalSpike, axis, true, width});
    return result;
}

std::vector<FitTerm> cyclicTerms(PlaneAxis axis, double pitch) {
    return {{InfluenceId::cyclic, axis, false, pitch}, {InfluenceId::cyclic, axis, true, pitch}};
}

std::vector<FitTerm> driftTerms(const DiagnosisOptions &options, bool bothSenses) {
    std::vector<FitTerm> result{{InfluenceId::radiusDrift, PlaneAxis::none, false, 0}};
    if (!options.pause && bothSenses)
        result.push_back({InfluenceId::radiusDrift, PlaneAxis::none, true, 0});
    return result;
}

std::vector<FoundInfluence> searchInfluences(const PathRows &rows, const DiagnosisOptions &options,
                                             InfluenceFit &fit, bool onlyDrift) {
    std::vector<FoundInfluence> result;
    Search search(rows, options, onlyDrift);
    const auto tryOne = [&](bool quiet) {
        Candidate candidate = search.best(fit, quiet);
        const int trials = search.trials();
        if (candidate.terms.empty() || trials * std::exp(-candidate.score / 2) > worthATrial)
            return false;
        if (candidate.terms.front().id == InfluenceId::cyclic)
            search.refine(fit, candidate);
        std::vector<FitTerm> terms = fit.terms;
        const std::size_t place = terms.size();
        terms.insert(terms.end(), candidate.terms.begin(), candidate.terms.end());
        InfluenceFit more(rows, std::move(terms));
        refineWidths(rows, more);
        const double chance = byChance(more, place, trials);
        const bool significant = chance <= mostByChance && amplitude(more, place) >= leastAmplitude &&
                                 more.isSeparable(place) && !isAtEnd(rows, more, place);
        const FitTerm &term = more.terms[place];
        if (!significant || (quiet && !misfits(rows, more).empty()) ||
            (term.id == InfluenceId::reversalSpike && reversals(rows, more, term) < 0))
            return false;
        result.push_back(
            {term.id, term.axis, chance,
             term.id == InfluenceId::cyclic ? search.asGoodAs(fit, candidate) : std::vector<FitTerm>()});
        fit = std::move(more);
        return true;
    };
    constexpr std::size_t most = 5; // both spikes, both screws, a drift
    while (result.size() < most && fit.residual > 0) {
        if (!tryOne(false) && (misfits(rows, fit).empty() || !tryOne(true)))
            break;
    }
    return result;
}

} // namespace palmer
