// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/trend/trendline.h"

#include "kernel/numerics/normalquantile.h"
#include "kernel/numerics/studentt.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <map>

namespace palmer {

namespace {

constexpr double twoSidedProbability = 0.975;
constexpr double oneSidedProbability = 0.95;
constexpr Eigen::Index lineColumns = 2;

/// The line fitted for a given scatter s.
struct Fit {
    double chi2 = 0;
    double level = 0;
    double slope = 0;
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
};

class Fitter {
public:
    explicit Fitter(std::span<const TrendPoint> points)
        : m_points(points)
        , m_count(static_cast<Eigen::Index>(points.size())) {
        double sum = 0;
        for (const TrendPoint &point : points) {
            sum += point.time;
            for (const SharedPart &part : point.shared)
                m_sources.emplace(part.source, 0);
        }
        m_centre = sum / static_cast<double>(points.size());
        Eigen::Index next = lineColumns;
        for (auto &[source, column] : m_sources)
            column = next++;
        m_columns = next;
        m_least = leastUncertainty();
    }

    [[nodiscard]] double centre() const { return m_centre; }

    [[nodiscard]] Fit fit(double scatterSquared) const {
        const Eigen::Index rows = m_count + m_columns - lineColumns;
        Eigen::MatrixXd a = Eigen::MatrixXd::Zero(rows, m_columns);
        Eigen::VectorXd b = Eigen::VectorXd::Zero(rows);
        for (Eigen::Index i = 0; i < m_count; ++i) {
            const TrendPoint &point = m_points[static_cast<std::size_t>(i)];
            const double own = std::sqrt(point.own * point.own + scatterSquared);
            const double weight = 1 / std::max(own, m_least);
            a(i, 0) = weight;
            a(i, 1) = weight * (point.time - m_centre);
            for (const SharedPart &part : point.shared)
                a(i, m_sources.at(part.source)) += weight * part.u;
            b[i] = weight * point.value;
        }
        for (Eigen::Index k = lineColumns; k < m_columns; ++k)
            a(m_count + k - lineColumns, k) = 1;
        // The columns of the line come last: their covariance then follows from the last 2 × 2 block of R.
        const Eigen::MatrixXd ordered = reversed(a);
        const Eigen::HouseholderQR<Eigen::MatrixXd> qr(ordered);
        const Eigen::VectorXd turned = qr.householderQ().adjoint() * b;
        const Eigen::Matrix2d triangle =
            qr.matrixQR().block<2, 2>(m_columns - lineColumns, m_columns - lineColumns);
        const Eigen::Matrix2d inverse =
            triangle.triangularView<Eigen::Upper>().solve(Eigen::Matrix2d::Identity());
        const Eigen::Vector2d line = inverse * turned.segment<2>(m_columns - lineColumns);
        return {turned.tail(rows - m_columns).squaredNorm(), line[0], line[1], inverse * inverse.transpose()};
    }

private:
    /// Moves the two columns of the line to the end, after those of the shared errors.
    [[nodiscard]] Eigen::MatrixXd reversed(const Eigen::MatrixXd &a) const {
        Eigen::MatrixXd result(a.rows(), a.cols());
        result << a.rightCols(m_columns - lineColumns), a.leftCols(lineColumns);
        return result;
    }

    /// Returns the smallest own uncertainty used, a ten-millionth of the size of the data: weights stay
    /// finite.
    [[nodiscard]] double leastUncertainty() const {
        constexpr double part = 1e-7;
        const auto [least, most] = std::ranges::minmax_element(m_points, {}, &TrendPoint::value);
        double size = most->value - least->value;
        for (const TrendPoint &point : m_points) {
            size = std::max(size, point.own);
            for (const SharedPart &shared : point.shared)
                size = std::max(size, std::abs(shared.u));
        }
        return size > 0 ? part * size : 1;
    }

    std::span<const TrendPoint> m_points;
    Eigen::Index m_count;
    Eigen::Index m_columns = 0;
    std::map<std::string, Eigen::Index> m_sources;
    double m_centre = 0;
    double m_least = 0;
};

/// Solves χ²(s²) = n − 2 for s², given χ²(0) > n − 2: Illinois method on 1/χ², which is nearly straight.
double scatterSquared(const Fitter &fitter, double chi2AtZero, double degrees) {
    const auto excess = [&](double chi2) { return 1 / chi2 - 1 / degrees; };
    double high = 1;
    while (fitter.fit(high).chi2 > degrees)
        high *= 4;
    while (high > 0 && fitter.fit(high / 16).chi2 < degrees)
        high /= 16;
    double low = 0;
    double ofLow = excess(chi2AtZero);
    double ofHigh = excess(fitter.fit(high).chi2);
    constexpr int mostSteps = 200;
    constexpr double tolerance = 1e-13;
    for (int step = 0; step < mostSteps && high - low > tolerance * high; ++step) {
        const double next = high - ofHigh * (high - low) / (ofHigh - ofLow);
        if (!(next > low && next < high))
            break;
        const double ofNext = excess(fitter.fit(next).chi2);
        if (ofNext >= 0) {
            high = next;
            ofHigh = ofNext;
            ofLow /= 2;
        } else {
            low = next;
            ofLow = ofNext;
            ofHigh /= 2;
        }
        if (std::abs(ofNext) < tolerance / degrees)
            return next;
    }
    return high;
}

bool isUsable(std::span<const TrendPoint> points) {
    const bool finite = std::ranges::all_of(points, [](const TrendPoint &point) {
        return std::isfinite(point.time) && std::isfinite(point.value) && std::isfinite(point.own) &&
               std::ranges::all_of(point.shared,
                                   [](const SharedPart &part) { return std::isfinite(part.u); });
    });
    if (!finite || points.size() < fewestTrendPoints)
        return false;
    const auto [first, last] = std::ranges::minmax_element(points, {}, &TrendPoint::time);
    return last->time > first->time;
}

} // namespace

double TrendLine::at(double time) const {
    return level + slope * (time - centre);
}

double TrendLine::uncertaintyAt(double time) const {
    const double away = time - centre;
    return std::sqrt(std::max(0.0, levelVariance + 2 * away * covariance + away * away * slopeVariance));
}

double TrendLine::slopeUncertainty() const {
    return std::sqrt(slopeVariance);
}

bool TrendLine::isShown() const {
    return std::abs(slope) >= twoSided * slopeUncertainty();
}

std::optional<TrendLine> trendLine(std::span<const TrendPoint> points) {
    if (!isUsable(points))
        return std::nullopt;
    const Fitter fitter(points);
    const int degrees = static_cast<int>(points.size()) - 2;
    Fit fit = fitter.fit(0);
    TrendLine result;
    // Values without an own part predict no scatter about the line, as shared errors only move it.
    if (std::ranges::all_of(points, [](const TrendPoint &point) { return point.own > 0; }))
        result.chi2PerDof = fit.chi2 / degrees;
    if (fit.chi2 > degrees) {
        const double squared = scatterSquared(fitter, fit.chi2, degrees);
        fit = fitter.fit(squared);
        result.scatter = std::sqrt(squared);
    }
    const auto [first, last] = std::ranges::minmax_element(points, {}, &TrendPoint::time);
    result.points = points.size();
    result.first = first->time;
    result.last = last->time;
    result.centre = fitter.centre();
    result.level = fit.level;
    result.slope = fit.slope;
    result.levelVariance = fit.covariance(0, 0);
    result.slopeVariance = fit.covariance(1, 1);
    result.covariance = fit.covariance(0, 1);
    const bool scatters = result.scatter > 0;
    result.twoSided =
        scatters ? studentQuantile(twoSidedProbability, degrees) : normalQuantile(twoSidedProbability);
    result.oneSided =
        scatters ? studentQuantile(oneSidedProbability, degrees) : normalQuantile(oneSidedProbability);
    return result;
}

} // namespace palmer
