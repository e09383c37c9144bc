// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/thermal/response.h"

#include "kernel/numerics/correlatednoise.h"
#include "kernel/numerics/studentt.h"
#include "kernel/thermal/responsefit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace palmer {

namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

/// The rows from the first to the last temperature, short gaps of it bridged.
struct Prepared {
    ResponseState state = ResponseState::found;
    std::size_t first = 0;
    ResponseRecord record;
};

Prepared prepare(const ThermalRecord &given) {
    constexpr std::size_t longestBridge = 3; // steps
    Prepared result;
    const auto &theta = given.temperatures;
    const auto isKnown = [](double value) { return !std::isnan(value); };
    const auto begin = std::ranges::find_if(theta, isKnown);
    const auto end = std::find_if(theta.rbegin(), theta.rend(), isKnown).base();
    constexpr std::ptrdiff_t fewest = 8;
    if (end - begin < fewest) {
        result.state = ResponseState::tooFewValues;
        return result;
    }
    result.first = static_cast<std::size_t>(begin - theta.begin());
    const auto count = static_cast<std::size_t>(end - begin);
    const auto times = given.times.subspan(result.first, count);
    ResponseRecord &record = result.record;
    record.settled = given.settled;
    record.step = (times.back() - times.front()) / static_cast<double>(count - 1);
    constexpr double alike = 0.01;
    for (std::size_t i = 1; i < count; ++i) {
        if (std::abs(times[i] - times[i - 1] - record.step) > alike * record.step)
            result.state = ResponseState::noEqualSteps;
    }
    const auto deviations = given.deviations.subspan(result.first, count);
    record.deviations.assign(deviations.begin(), deviations.end());
    for (auto value = begin; value != end; ++value)
        record.temperatures.push_back(*value - *begin);
    std::size_t known = 0;
    for (std::size_t i = 1; i < count; ++i) {
        std::vector<double> &y = record.temperatures;
        if (!isKnown(y[i]))
            continue;
        if (i - known > longestBridge && result.state == ResponseState::found)
            result.state = ResponseState::gapInTemperature;
        for (std::size_t j = known + 1; j < i; ++j)
            y[j] = y[known] +
                   (y[i] - y[known]) * static_cast<double>(j - known) / static_cast<double>(i - known);
        known = i;
    }
    return result;
}

/// Returns F(1 − p; 2, ν).
double fisherQuantile(double exceeded, double degrees) {
    return degrees / 2 * (std::pow(exceeded, -2 / degrees) - 1);
}

/// Returns the standard deviation of the noise of equally spaced temperatures: median |Δ²θ|/1.652.
double noiseOf(const std::vector<double> &theta, double resolution) {
    std::vector<double> second;
    for (std::size_t i = 2; i < theta.size(); ++i)
        second.push_back(std::abs(theta[i] - 2 * theta[i - 1] + theta[i - 2]));
    const auto middle = second.begin() + static_cast<std::ptrdiff_t>(second.size() / 2);
    std::ranges::nth_element(second, middle);
    constexpr double medianOfNormal = 1.652; // √6·0.6745
    return std::max(*middle / medianOfNormal, resolution / std::sqrt(12.0));
}

/// The quality of an estimate: its variance as if from white noise, and its degrees of freedom.
struct Noise {
    double variance = 0;
    double degrees = 0;

    [[nodiscard]] double allowed() const { // δ, by which S may exceed its minimum
        const double t = studentQuantile975(static_cast<int>(degrees));
        return variance * t * t;
    }
};

Noise noiseOf(const CorrelatedNoise &noise, const Eigen::VectorXd &weights) {
    const double white = weights.squaredNorm();
    if (white <= 0)
        return {0, 0};
    const double u = noise.standardUncertainty(weights);
    return {u * u / white, noise.degreesOfFreedom(weights)};
}

class Scan {
public:
    Scan(const ResponseFit &fit, double step, double length)
        : m_fit(fit)
        , m_longest(4 * length) {
        constexpr double ratio = 1.1;
        m_points.push_back(fit.at(0));
        double tau = step / 2;
        while (tau < m_longest) {
            m_points.push_back(fit.at(tau));
            tau *= ratio;
        }
        m_points.push_back(fit.at(m_longest));
        const auto best = std::ranges::min_element(m_points, {}, &ResponseFit::At::squares);
        m_best = *best;
        refine(static_cast<std::size_t>(best - m_points.begin()));
    }

    [[nodiscard]] const ResponseFit::At &best() const { return m_best; }

    /// Returns the least squares without y, whatever the τ of a fitted start.
    [[nodiscard]] double leastWithout() const {
        const auto least = std::ranges::min_element(m_points, {}, &ResponseFit::At::without);
        return std::min(least->without, m_best.without);
    }

    /// Returns all τ with S ≤ S_min + δ, from the lowest to the highest, with their fits.
    struct Within {
        Range range;
        std::vector<ResponseFit::At> fits;
    };
    [[nodiscard]] Within within(double allowed) const {
        const double most = m_best.squares + allowed;
        const auto holds = [most](const ResponseFit::At &one) { return one.squares <= most; };
        const auto first = std::ranges::find_if(m_points, holds);
        const auto last = std::find_if(m_points.rbegin(), m_points.rend(), holds);
        Within result;
        double low = 0;
        double high = m_longest;
        if (first == m_points.end()) { // the minimum lies between two points of the grid
            const auto above = std::ranges::lower_bound(m_points, m_best.tau, {}, &ResponseFit::At::tau);
            low = edge(std::prev(above)->tau, m_best.tau, most);
            high = edge(above->tau, m_best.tau, most);
            result.range = {low, high};
        } else {
            if (first != m_points.begin())
                result.range.low = low =
                    edge(std::prev(first)->tau,
                         std::min(first->tau, std::max(m_best.tau, std::prev(first)->tau)), most);
            if (last != m_points.rbegin())
                result.range.high = high =
                    edge(std::prev(last)->tau,
                         std::max(last->tau, std::min(m_best.tau, std::prev(last)->tau)), most);
        }
        constexpr int steps = 40;
        for (int i = 0; i <= steps; ++i) {
            const ResponseFit::At one = m_fit.at(low + (high - low) * i / steps);
            if (holds(one) || i == 0 || i == steps)
                result.fits.push_back(one);
        }
        std::ranges::copy_if(m_points, std::back_inserter(result.fits), holds);
        result.fits.push_back(m_best);
        return result;
    }

private:
    /// Returns the τ between one outside and one within at which S reaches `most`.
    [[nodiscard]] double edge(double outside, double inside, double most) const {
        constexpr int halvings = 40;
        for (int i = 0; i < halvings; ++i) {
            const double middle = (outside + inside) / 2;
            (m_fit.at(middle).squares <= most ? inside : outside) = middle;
        }
        return inside;
    }

    /// Golden section between the neighbours of the best point of the grid, then the zero of dS/dτ: S itself
    /// is flat about its minimum, where the last digits of exp would decide the ninth of τ.
    void refine(std::size_t index) {
        narrow(index);
        constexpr double nearby = 1e-5;
        constexpr double reach = 1e-3;
        constexpr int steps = 6;
        double last = m_best.tau;
        double tau = last * (1 + nearby);
        if (last <= 0 || last >= m_longest)
            return;
        double before = m_fit.linearAt(m_best).descent;
        for (int i = 0; i < steps && tau != last; ++i) {
            const double descent = m_fit.linearAt(m_fit.at(tau)).descent;
            if (descent == before)
                break;
            const double next = tau - descent * (tau - last) / (descent - before);
            if (!(std::abs(next - m_best.tau) < reach * m_best.tau))
                return;
            last = std::exchange(tau, next);
            before = descent;
        }
        m_best = m_fit.at(tau);
    }

    void narrow(std::size_t index) {
        double low = m_points[index == 0 ? 0 : index - 1].tau;
        double high = m_points[std::min(index + 1, m_points.size() - 1)].tau;
        constexpr double golden = 0.6180339887498949;
        constexpr int steps = 25;
        ResponseFit::At left = m_fit.at(high - golden * (high - low));
        ResponseFit::At right = m_fit.at(low + golden * (high - low));
        for (int i = 0; i < steps; ++i) {
            if (left.squares <= right.squares) {
                high = right.tau;
                right = left;
                left = m_fit.at(high - golden * (high - low));
            } else {
                low = left.tau;
                left = right;
                right = m_fit.at(low + golden * (high - low));
            }
            for (const ResponseFit::At &one : {left, right}) {
                if (one.squares < m_best.squares)
                    m_best = one;
            }
        }
    }

    const ResponseFit &m_fit;
    double m_longest;
    std::vector<ResponseFit::At> m_points; ///< by τ
    ResponseFit::At m_best;
};

/// True if a straight drift explains y. With a fitted start, for any τ that the data allow: judged at the
/// best τ alone, only estimates far from the truth would pass, whose intervals then miss it.
bool isStraight(const Scan &scan, bool hasStart, const Noise &ofTau) {
    constexpr double leastOfY = 0.03;
    const auto holds = [](const ResponseFit::At &one) { return one.left < leastOfY * one.ofY; };
    return holds(scan.best()) || (hasStart && std::ranges::any_of(scan.within(ofTau.allowed()).fits, holds));
}

ResponseState judge(const Scan &scan, const ResponseRecord &record, const Noise &ofK, const Noise &ofTau,
                    double residual, double resolution, int ofTemperatures) {
    constexpr double leastDegrees = 3;
    constexpr double error = 0.05;
    constexpr double mostNoise = 0.2;
    const ResponseFit::At &best = scan.best();
    if (ofK.degrees < leastDegrees)
        return ResponseState::tooFewValues;
    if (!(scan.leastWithout() - best.squares >
          2 * fisherQuantile(error / ofTemperatures, ofK.degrees) * ofK.variance))
        return ResponseState::notProven;
    if (isStraight(scan, !record.settled, ofTau))
        return ResponseState::straightDrift;
    const double passed = std::sqrt(record.step / (record.step + 2 * best.tau));
    if (noiseOf(record.temperatures, resolution) * std::abs(best.k) * passed > mostNoise * residual)
        return ResponseState::noisyTemperature;
    return ResponseState::found;
}

} // namespace

ThermalResponse thermalResponse(const ThermalRecord &given, int ofTemperatures) {
    ThermalResponse result;
    const Prepared prepared = prepare(given);
    result.state = prepared.state;
    if (result.state != ResponseState::found)
        return result;
    const ResponseRecord &record = prepared.record;
    const std::size_t rows = record.deviations.size();
    const ResponseFit fit(record);
    result.count = static_cast<std::size_t>(fit.used());
    if (fit.used() < Eigen::Index{2} * fit.parameters(1)) {
        result.state = ResponseState::tooFewValues;
        return result;
    }
    const Scan scan(fit, record.step, record.step * static_cast<double>(rows - 1));
    const ResponseFit::At &best = scan.best();
    const auto [least, most] = std::ranges::minmax_element(record.deviations);
    if (best.left <= 0 || *least == *most) { // a constant temperature, or nothing that follows it
        result.state = ResponseState::notProven;
        return result;
    }
    const ResponseFit::Linear linear = fit.linearAt(best);
    const std::array records{Record{0, rows, result.count}};
    const CorrelatedNoise noise(linear.basis, linear.residual, records);
    const Noise ofK = noiseOf(noise, linear.ofK);
    const Noise ofTau = noiseOf(noise, linear.ofTau);
    result.squares = best.squares;
    result.residual = std::sqrt(best.squares / static_cast<double>(fit.used() - fit.parameters(best.tau)));
    result.state = judge(scan, record, ofK, ofTau, result.residual, given.resolution, ofTemperatures);
    if (result.state != ResponseState::found)
        return result;
    result.k = best.k;
    result.tau = best.tau;
    result.tauRange = scan.within(ofTau.allowed()).range;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const ResponseFit::At &one : scan.within(ofK.allowed()).fits) {
        const double room = best.squares + ofK.allowed() - one.squares;
        const double half = std::sqrt(std::max(room, 0.0) / one.left);
        low = std::min(low, one.k - half);
        high = std::max(high, one.k + half);
    }
    result.kRange = {low, high};
    if (!result.tauRange.high) // |k| is known from below only
        (result.k > 0 ? result.kRange.high : result.kRange.low).reset();
    result.slope = linear.slope;
    const double half = noise.standardUncertainty(linear.ofSlope) *
                        studentQuantile975(static_cast<int>(noise.degreesOfFreedom(linear.ofSlope)));
    result.slopeRange = {linear.slope - half, linear.slope + half};
    for (std::size_t i = 0; i < rows; ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        const double x = record.deviations[i];
        result.times.push_back(given.times[prepared.first + i]);
        result.fitted.push_back(std::isnan(x) ? notANumber : linear.fitted[row]);
        result.response.push_back(best.k * linear.response[row]);
        result.rest.push_back(x - result.response.back());
    }
    return result;
}

double ThermalResponse::variationWhenHeld(double hold, double duration) const {
    const double reached = tau > 0 ? -std::expm1(-duration / tau) : 1;
    const auto ofRest = variation(times, rest, duration);
    return 2 * hold * std::abs(k) * reached + (ofRest ? ofRest->value : 0);
}

std::optional<double> ThermalResponse::warmUp(std::span<const double> temperatures) const {
    constexpr double steady = 0.05;
    constexpr double left = 0.1;
    constexpr double lastTimes = 3;
    if (response.size() < 2)
        return std::nullopt;
    const auto rangeOf = [](auto begin, auto end) {
        double low = std::numeric_limits<double>::infinity();
        double high = -low;
        for (; begin != end; ++begin) {
            if (!std::isnan(*begin)) {
                low = std::min(low, *begin);
                high = std::max(high, *begin);
            }
        }
        return high - low;
    };
    const double length = times.back() - times.front();
    const auto end = std::ranges::lower_bound(times, times.back() - lastTimes * tau) - times.begin();
    const bool isSteady =
        lastTimes * tau < length && rangeOf(temperatures.begin() + end, temperatures.end()) <=
                                        steady * rangeOf(temperatures.begin(), temperatures.end());
    const double range = rangeOf(response.begin(), response.end());
    if (!isSteady || std::abs(slope) * length >= left * range)
        return std::nullopt;
    std::size_t last = 0;
    for (std::size_t i = 0; i < response.size(); ++i) {
        if (std::abs(response[i] - response.back()) > left * range)
            last = i;
    }
    return times[last] - times.front();
}

} // namespace palmer
