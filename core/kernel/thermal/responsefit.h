// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <vector>

namespace palmer {

/// A record ready to be fitted: times from 0 at equal steps, no temperature missing; NaN: no deviation.
struct ResponseRecord {
    double step = 1; ///< h, s
    std::vector<double> deviations;
    std::vector<double> temperatures; ///< from the first of them, whose level would cost digits
    bool settled = false;             ///< in balance at the first temperature: no start to be fitted
};

/// Returns y with τ·dy/dt = θ − y and y(0) = θ(0), for θ straight between its values; θ itself for τ = 0.
[[nodiscard]] Eigen::VectorXd delayed(const std::vector<double> &temperatures, double step, double tau);

/// Least squares of x = a + b·t + k·y (+ c·e^(−t/τ)) for any given τ. Rows without a deviation are left out.
class ResponseFit {
public:
    explicit ResponseFit(const ResponseRecord &record);

    /// The fit for one τ.
    struct At {
        double tau = 0;
        double squares = 0; ///< S
        double without = 0; ///< S without y
        double k = 0;
        double left = 0; ///< C: squares of y left by the other columns
        double ofY = 0;  ///< Σ(y − ȳ)²
    };
    [[nodiscard]] At at(double tau) const;

    /// Orthonormal columns of the fit at τ and of ∂x/∂τ, and what each parameter weighs in their
    /// coefficients; zeros in rows without a deviation.
    struct Linear {
        Eigen::MatrixXd basis;
        Eigen::VectorXd residual;
        Eigen::VectorXd ofSlope; ///< weights of b
        Eigen::VectorXd ofK;
        Eigen::VectorXd ofTau;
        double slope = 0; ///< b, per s
        Eigen::VectorXd fitted;
        Eigen::VectorXd response; ///< y
        double descent = 0;       ///< −½·dS/dτ: residual times ∂x/∂τ
    };
    [[nodiscard]] Linear linearAt(const At &fit) const;

    [[nodiscard]] Eigen::Index used() const { return m_used; } ///< rows with a deviation
    [[nodiscard]] int parameters(double tau) const { return hasStart(tau) ? 5 : 4; } ///< τ among them

private:
    [[nodiscard]] bool hasStart(double tau) const { return !m_record.settled && tau > 0; }
    [[nodiscard]] Eigen::VectorXd startOf(double tau) const;
    [[nodiscard]] Eigen::VectorXd masked(const Eigen::VectorXd &column) const;

    const ResponseRecord &m_record;
    Eigen::VectorXd m_mask; ///< 1 or 0
    Eigen::VectorXd m_times;
    Eigen::VectorXd m_x;        ///< 0 in rows without a deviation
    Eigen::MatrixXd m_straight; ///< orthonormal: 1, t
    Eigen::VectorXd m_xLeft;    ///< what they leave of x
    Eigen::Index m_used = 0;
};

} // namespace palmer
