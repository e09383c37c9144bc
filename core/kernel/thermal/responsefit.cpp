// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/thermal/responsefit.h"

#include <Eigen/Dense>

#include <cmath>

namespace palmer {

using Vector = Eigen::VectorXd;

Vector delayed(const std::vector<double> &temperatures, double step, double tau) {
    const auto n = static_cast<Eigen::Index>(temperatures.size());
    if (tau <= 0)
        return Eigen::Map<const Vector>(temperatures.data(), n);
    const double q = step / tau;
    const double kept = std::exp(-q);
    const double w = -std::expm1(-q) / q;
    Vector y(n);
    double value = temperatures.front();
    y[0] = value;
    for (Eigen::Index i = 1; i < n; ++i) {
        const auto row = static_cast<std::size_t>(i);
        value = kept * value + (w - kept) * temperatures[row - 1] + (1 - w) * temperatures[row];
        y[i] = value;
    }
    return y;
}

ResponseFit::ResponseFit(const ResponseRecord &record)
    : m_record(record) {
    const auto n = static_cast<Eigen::Index>(record.deviations.size());
    m_mask = Vector::Ones(n);
    m_x = Eigen::Map<const Vector>(record.deviations.data(), n);
    for (Eigen::Index i = 0; i < n; ++i) {
        if (std::isnan(m_x[i]))
            m_x[i] = m_mask[i] = 0;
    }
    m_used = static_cast<Eigen::Index>(m_mask.sum());
    m_times = Vector::LinSpaced(n, 0, record.step * static_cast<double>(n - 1));
    m_straight.resize(n, 2);
    m_straight.col(0) = m_mask.normalized();
    Vector t = masked(m_times);
    t -= m_straight.col(0) * m_straight.col(0).dot(t);
    m_straight.col(1) = t.normalized();
    m_xLeft = m_x - m_straight * (m_straight.transpose() * m_x);
}

Vector ResponseFit::masked(const Vector &column) const {
    return column.cwiseProduct(m_mask);
}

Vector ResponseFit::startOf(double tau) const {
    return masked((-m_times / tau).array().exp().matrix());
}

ResponseFit::At ResponseFit::at(double tau) const {
    At result;
    result.tau = tau;
    Vector x = m_xLeft;
    Vector y = masked(delayed(m_record.temperatures, m_record.step, tau));
    const double mean = y.sum() / static_cast<double>(m_used);
    result.ofY = y.squaredNorm() - static_cast<double>(m_used) * mean * mean;
    y -= m_straight * (m_straight.transpose() * y);
    if (hasStart(tau)) {
        Vector start = startOf(tau);
        const double whole = start.squaredNorm();
        start -= m_straight * (m_straight.transpose() * start);
        constexpr double independent = 1e-12; // of its squares: otherwise a straight line already
        const double squares = start.squaredNorm();
        if (squares > independent * whole) {
            x -= start * (start.dot(x) / squares);
            y -= start * (start.dot(y) / squares);
        }
    }
    result.left = y.squaredNorm();
    result.without = x.squaredNorm();
    result.k = result.left > 0 ? y.dot(x) / result.left : 0;
    result.squares = (x - result.k * y).squaredNorm();
    return result;
}

ResponseFit::Linear ResponseFit::linearAt(const At &fit) const {
    const auto yAt = [&](double tau) { return delayed(m_record.temperatures, m_record.step, tau); };
    Linear result;
    result.response = yAt(fit.tau);
    const bool start = hasStart(fit.tau);
    const Eigen::Index columns = start ? 4 : 3; // 1, t, y, start
    Eigen::MatrixXd design(m_x.size(), columns + 1);
    design.col(0) = m_mask;
    const double scale = m_times[m_times.size() - 1];
    design.col(1) = masked(m_times / scale);
    design.col(2) = masked(result.response);
    if (start)
        design.col(3) = startOf(fit.tau);
    const Vector first = design.leftCols(columns).colPivHouseholderQr().solve(m_x);
    // ∂x/∂τ; at τ = 0 over half a step, the first of the grid.
    constexpr double nearby = 1e-4;
    const double below = fit.tau > 0 ? fit.tau * (1 - nearby) : 0;
    const double above = fit.tau > 0 ? fit.tau * (1 + nearby) : m_record.step / 2;
    Vector turned = fit.k * (yAt(above) - yAt(below)) / (above - below);
    if (start)
        turned += first[3] * (startOf(above) - startOf(below)) / (above - below);
    const Vector lastColumn = masked(turned);
    const double size = lastColumn.norm();
    const bool turns = size > 0;
    if (turns)
        design.col(columns) = lastColumn / size;
    else
        design.conservativeResize(Eigen::NoChange, columns);
    const Eigen::Index all = design.cols();
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(design);
    result.basis = qr.householderQ() * Eigen::MatrixXd::Identity(design.rows(), all);
    const Eigen::MatrixXd r = qr.matrixQR().topLeftCorner(all, all).triangularView<Eigen::Upper>();
    const Eigen::MatrixXd inverse =
        r.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(all, all));
    result.fitted = design.leftCols(columns) * first;
    result.residual = m_x - result.fitted;
    result.descent = result.residual.dot(lastColumn);
    result.slope = first[1] / scale;
    result.ofSlope = inverse.row(1).transpose() / scale;
    result.ofK = inverse.row(2).transpose();
    result.ofTau = turns ? Vector(inverse.row(columns).transpose() / size) : Vector::Zero(all);
    return result;
}

} // namespace palmer
