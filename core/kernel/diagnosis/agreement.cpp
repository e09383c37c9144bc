// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/diagnosis/agreement.h"

#include "kernel/numerics/angles.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>

namespace palmer {

namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

constexpr double mostU = 3;

/// Variance of a reading in a slow estimate.
double slowVariance(const InfluenceFit &fit) {
    return fit.noise.variance(0.5) * std::max(1.0, fit.noise.readingsPerIndependent());
}

Matrix inverseOf(const Matrix &gram) {
    return gram.completeOrthogonalDecomposition().pseudoInverse();
}

/// Returns |even − odd| / u for each factor.
Vector bySectors(const PathRows &rows, const InfluenceFit &fit) {
    constexpr double sector = 15;
    Vector isOdd(rows.size());
    for (Eigen::Index i = 0; i < rows.size(); ++i) {
        const PathPosition &p = rows.positions()[std::size_t(i)];
        isOdd[i] = int((std::atan2(p.sine, p.cosine) / degree + fullTurn) / sector) % 2;
    }
    const Matrix &basis = fit.fit.basis;
    const Matrix ofOdd = isOdd.asDiagonal() * basis;
    const Matrix gram = ofOdd.transpose() * basis;
    const Matrix odd = inverseOf(gram);
    const Matrix even = inverseOf(Matrix::Identity(gram.rows(), gram.cols()) - gram);
    // Plain residuals have no part in the basis: what the even sectors say, the odd ones contradict.
    const Vector difference = fit.fit.toScaled * ((even + odd) * (ofOdd.transpose() * fit.fit.residual));
    const Matrix covariance = fit.fit.toScaled * (even + odd) * fit.fit.toScaled.transpose();
    return difference.cwiseAbs().cwiseQuotient(
        (covariance.diagonal() * slowVariance(fit)).cwiseMax(1e-300).cwiseSqrt());
}

/// Returns how far Huber's weights move each factor.
Vector byRobustWeights(const InfluenceFit &fit) {
    constexpr double huber = 1.345;
    constexpr double within = 0.8213; // part of a normal distribution
    constexpr int turns = 6;
    const double bound = huber * fit.residual;
    Vector rest = fit.fit.residual;
    Vector moved = Vector::Zero(fit.fit.basis.cols());
    for (int turn = 0; turn < turns; ++turn) {
        const Vector step = fit.fit.basis.transpose() * rest.cwiseMin(bound).cwiseMax(-bound) / within;
        rest -= fit.fit.basis * step;
        moved += step;
    }
    return (fit.fit.toScaled * moved).cwiseQuotient(fit.fit.lengths);
}

const FitTerm stepOfRadius{InfluenceId::radiusDrift, PlaneAxis::none, true};

/// True if a step of the radius between the senses explains as much as the lateral play that is seen.
bool stepInsteadOfPlay(const PathRows &rows, const InfluenceFit &fit) {
    std::vector<FitTerm> terms{stepOfRadius};
    for (std::size_t j = 0; j < fit.terms.size(); ++j) {
        const FitTerm &term = fit.terms[j];
        const bool isPlay = term.id == InfluenceId::lateralPlay;
        if ((isPlay && !(fit.isSeparable(j) && std::abs(fit.factor(j)) > mostU * fit.u(j))) ||
            (term.id == InfluenceId::radiusDrift && term.second))
            return false;
        if (!isPlay)
            terms.push_back(term);
    }
    const ColumnFit other = columnFit(rows.columns(terms), rows.deviations());
    constexpr double quantile95 = 3.84;
    return other.residual.squaredNorm() - fit.fit.residual.squaredNorm() < quantile95 * slowVariance(fit);
}

/// True if a step of the radius between the senses explains more than the noise that is left with it, even
/// though lateral play takes most of it up.
bool hasStepBetweenSenses(const PathRows &rows, const InfluenceFit &fit) {
    const auto isStep = [](const FitTerm &term) {
        return term.id == InfluenceId::radiusDrift && term.second;
    };
    if (std::ranges::any_of(fit.terms, isStep))
        return false;
    std::vector<FitTerm> terms{stepOfRadius};
    const Vector whole = rows.columns(terms).col(0);
    const Vector column = whole - fit.fit.basis * (fit.fit.basis.transpose() * whole);
    constexpr double least = 1e-6; // of a column that is there: both senses
    if (column.squaredNorm() < least * whole.squaredNorm())
        return false;
    const double along = column.dot(fit.fit.residual);
    const double explained = along * along / column.squaredNorm();
    constexpr double quantile998 = 9.55; // of χ² with one degree of freedom
    if (explained < quantile998 * fit.noise.fastest())
        return false;
    terms.insert(terms.end(), fit.terms.begin(), fit.terms.end());
    return explained > quantile998 * slowVariance({rows, std::move(terms)});
}

} // namespace

// With the whole fitted, columns of all reversals but one give the differences from that one.
int reversals(const PathRows &rows, const InfluenceFit &fit, const FitTerm &term) {
    std::vector<FitTerm> parts(4, term);
    for (std::size_t k = 0; k < parts.size(); ++k)
        parts[k].part = int(k) + 1;
    const Matrix whole = rows.columns(parts);
    const Vector lengths = whole.colwise().norm();
    std::vector<Eigen::Index> present;
    for (Eigen::Index k = 0; k < lengths.size(); ++k) {
        if (lengths[k] > lengths.maxCoeff() / 2)
            present.push_back(k);
    }
    const int count = int(present.size());
    present.pop_back();
    if (present.empty())
        return count;
    const Matrix some = whole(Eigen::all, present);
    const Matrix beyond = some - fit.fit.basis * (fit.fit.basis.transpose() * some);
    const Matrix inverse = inverseOf(beyond.transpose() * beyond);
    const Vector differences = inverse * (beyond.transpose() * fit.fit.residual);
    const double variance = slowVariance(fit);
    const auto isFar = [&](const Vector &weights) {
        return std::abs(weights.dot(differences)) >
               mostU * std::sqrt(weights.dot(inverse * weights) * variance);
    };
    const Eigen::Index n = differences.size();
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index k = i; k < n; ++k) {
            const Vector own = Vector::Unit(n, i);
            if (isFar(k == i ? own : Vector(own - Vector::Unit(n, k))))
                return -count;
        }
    }
    return count;
}

Agreement agreement(const PathRows &rows, const InfluenceFit &fit) {
    Agreement result{std::vector<std::vector<Message>>(fit.terms.size()), false};
    if (!(fit.residual > leastAmplitude))
        return result;
    const Vector sectors = bySectors(rows, fit);
    const Vector robust = byRobustWeights(fit);
    const bool isStep = stepInsteadOfPlay(rows, fit);
    result.stepBetweenSenses = hasStepBetweenSenses(rows, fit);
    for (std::size_t j = 0; j < fit.terms.size(); ++j) {
        const FitTerm &term = fit.terms[j];
        if (!fit.isSeparable(j) || term.id == InfluenceId::centre || term.id == InfluenceId::radius)
            continue;
        const auto object = [&](const Text &text) { result.objections[j].push_back({text}); };
        const auto i = Eigen::Index(j);
        if (term.id == InfluenceId::backlash || (term.id == InfluenceId::reversalSpike && !term.second)) {
            const int count = reversals(rows, fit, term);
            if (count < 0)
                object(REPORT_TEXT("report", "The reversals, each fitted alone, contradict each other."));
            if (std::abs(count) == 1)
                object(REPORT_TEXT("report", "Only one reversal is in the data."));
        }
        if (sectors[i] > mostU)
            object(REPORT_TEXT("report", "Even and odd sectors of 15° contradict each other."));
        if (std::abs(robust[i]) > mostU * fit.u(j))
            object(REPORT_TEXT("report", "A few readings make it: robust weights give another value."));
        if (term.id == InfluenceId::lateralPlay && isStep)
            object(REPORT_TEXT("report", "Radii that differ between the senses explain it as well."));
    }
    return result;
}

} // namespace palmer
