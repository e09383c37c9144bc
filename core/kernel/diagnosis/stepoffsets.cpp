// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/diagnosis/stepoffsets.h"

#include "kernel/numerics/angles.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palmer {

namespace {

bool makesStep(InfluenceId id) {
    return id == InfluenceId::backlash || id == InfluenceId::lateralPlay;
}

bool hasSteps(const InfluenceFit &fit) {
    constexpr double least = 1e-4; // mm
    for (std::size_t j = 0; j < fit.terms.size(); ++j) {
        const double height = std::abs(fit.factor(j));
        if (makesStep(fit.terms[j].id) && height > 5 * fit.u(j) && height > least && fit.isSeparable(j))
            return true;
    }
    return false;
}

constexpr std::array spikeWidths{1.0, 3.0}; ///< degrees

/// A reading near a reversal.
struct NearReversal {
    double travelled = 0; ///< since the reversal, degrees; negative: before it
    bool ofFirst = false; ///< the first axis reverses there
    double before = 0;    ///< minus the smooth columns and the steps as before the reversal, mm
    double after = 0;     ///< as after it
    std::array<double, spikeWidths.size()> spike{};
};

/// Returns the position turned by an angle (rad) in the direction of travel.
PathPosition ahead(const PathPosition &from, double angle) {
    PathPosition p = from;
    const double c = std::cos(angle);
    const double s = std::sin(angle) * from.sense;
    p.cosine = from.cosine * c - from.sine * s;
    p.sine = from.sine * c + from.cosine * s;
    return p;
}

std::vector<NearReversal> nearReversals(const PathRows &rows, const InfluenceFit &fit, double sense) {
    constexpr double quarter = 90;
    std::vector<NearReversal> near;
    for (Eigen::Index i = 0; i < rows.size(); ++i) {
        const PathPosition &p = rows.positions()[std::size_t(i)];
        if (p.sense != sense || !rows.counts(i) ||
            std::min(std::abs(p.sine), std::abs(p.cosine)) > std::sin(stepReach * degree))
            continue;
        NearReversal one;
        one.travelled = std::remainder(sense * std::atan2(p.sine, p.cosine) / degree, quarter);
        one.ofFirst = std::abs(p.sine) < std::abs(p.cosine);
        // The column on the other side is that at the mirrored place.
        const PathPosition mirrored = ahead(p, -2 * one.travelled * degree);
        const bool isAfter = one.travelled >= 0;
        double rest = rows.deviations()[i];
        for (std::size_t j = 0; j < fit.terms.size(); ++j) {
            const FitTerm &term = fit.terms[j];
            const double factor = fit.factor(j);
            if (makesStep(term.id)) {
                one.before -= factor * columnValue(term, isAfter ? mirrored : p);
                one.after -= factor * columnValue(term, isAfter ? p : mirrored);
            } else if (term.id != InfluenceId::centre || term.circle == rows.circleOf(i)) {
                rest -= factor * columnValue(term, p);
            }
        }
        one.before += rest;
        one.after += rest;
        for (std::size_t w = 0; w < spikeWidths.size(); ++w)
            one.spike[w] = std::exp(-one.travelled / spikeWidths[w]);
        near.push_back(one);
    }
    return near;
}

/// Returns the sum of squares with the steps at `offset`, less what spikes of either axis explain behind
/// it.
double sumOfSquares(const std::vector<NearReversal> &near, double offset) {
    double sum = 0;
    std::array<std::array<double, 2>, spikeWidths.size()> along{};
    std::array<std::array<double, 2>, spikeWidths.size()> squares{};
    for (const NearReversal &row : near) {
        const bool isAfter = row.travelled >= offset;
        const double rest = isAfter ? row.after : row.before;
        sum += rest * rest;
        for (std::size_t w = 0; isAfter && w < spikeWidths.size(); ++w) {
            along[w][row.ofFirst] += row.spike[w] * rest;
            squares[w][row.ofFirst] += row.spike[w] * row.spike[w];
        }
    }
    double explained = 0;
    for (std::size_t w = 0; w < spikeWidths.size(); ++w) {
        double both = 0;
        for (const std::size_t axis : {0U, 1U})
            both += squares[w][axis] > 0 ? along[w][axis] * along[w][axis] / squares[w][axis] : 0;
        explained = std::max(explained, both);
    }
    return sum - explained;
}

/// Offset of the steps of one sense: mean, standard uncertainty, and half the range of what is likely.
struct Offset {
    double mean = 0;
    double u = 0;
    double bound = 0;
};

std::optional<Offset> offsetOf(const PathRows &rows, const InfluenceFit &fit, double sense) {
    constexpr double finest = 0.02;
    constexpr double widest = 4;
    constexpr auto places = static_cast<std::size_t>(2 * widest / finest) + 1;
    const auto offsetAt = [](std::size_t place) { return double(place) * finest - widest; };
    const std::vector<NearReversal> near = nearReversals(rows, fit, sense);
    if (near.empty())
        return std::nullopt;
    std::vector<double> sums;
    for (std::size_t place = 0; place < places; ++place)
        sums.push_back(sumOfSquares(near, offsetAt(place)));
    const double best = *std::ranges::min_element(sums);
    // Noise as far from the reversals, or as near them, whichever is more; each of four is one reading at
    // least.
    const auto count = double(near.size());
    const double variance = std::max(fit.noise.variance(0.1),
                                     best / count * std::min(fit.noise.readingsPerIndependent(), count / 4));
    double all = 0;
    Offset offset;
    double low = widest;
    double high = -widest;
    double squares = 0;
    for (std::size_t k = 0; k < sums.size(); ++k) {
        const double at = offsetAt(k);
        const double weight = variance > 0 ? std::exp((best - sums[k]) / (2 * variance)) : sums[k] == best;
        all += weight;
        offset.mean += weight * at;
        squares += weight * at * at;
        constexpr double likely = 1e-4;
        if (weight > likely) {
            low = std::min(low, at);
            high = std::max(high, at);
        }
    }
    offset.mean /= all;
    offset.u = std::sqrt(std::max(0.0, squares / all - offset.mean * offset.mean)) + finest / 2;
    offset.bound = (high - low + finest) / 2;
    return offset;
}

} // namespace

StepOffsets stepOffsets(const PathRows &rows, const InfluenceFit &far, bool commanded) {
    StepOffsets result;
    result.rotation.commanded = commanded;
    if (!hasSteps(far))
        return result;
    const auto forward = offsetOf(rows, far, 1);
    const auto back = offsetOf(rows, far, -1);
    const double u = std::hypot(forward ? forward->u : 0, back ? back->u : 0) / (forward && back ? 2 : 1);
    constexpr double located = 1;
    result.seen = (forward || back) && u < located;
    result.rotation.u = u;
    if (!result.seen)
        return result;
    if (forward && back) {
        const double bound = std::min(3 * u, (forward->bound + back->bound) / 2);
        result.rotation = {(forward->mean - back->mean) / 2, u, bound, commanded};
        result.lag = (forward->mean + back->mean) / 2;
        result.lagBound = bound;
        return result;
    }
    const Offset one = forward ? *forward : *back;
    const double bound = std::min(3 * u, one.bound);
    if (commanded)
        std::tie(result.lag, result.lagBound) = std::pair(one.mean, bound);
    else
        result.rotation = {forward ? one.mean : -one.mean, u, bound, commanded};
    return result;
}

} // namespace palmer
