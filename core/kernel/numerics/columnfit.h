// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace palmer {

/// Linear least squares with possibly dependent columns: the coefficients x that minimise |b − A·x|², and the
/// combinations of them that the rows determine.
///
/// Method: columns scaled to unit length, z_j = x_j·|A_j|; Householder QR; singular values of the triangle, R
/// = U·S·Vᵀ. Values below rankTolerance times the largest count as zero: their combinations V of the z are
/// undetermined and get no part of the solution (minimum |z|).
/// Validity: columns of any scale and unit, finite numbers; at least as many rows as columns, otherwise rank
/// 0. A column of zeros reduces the rank.
///
/// Source: G. H. Golub, C. F. Van Loan, Matrix Computations, 4th ed. (2013), 5.3.8 (scaling), 5.4 (rank).
struct ColumnFit {
    int rank = 0;
    double condition = 0;    ///< ratio of largest to smallest of the non-zero singular values
    Eigen::VectorXd lengths; ///< |A_j|, 1 for columns of zeros
    Eigen::VectorXd scaled;  ///< z
    Eigen::MatrixXd toScaled; ///< M, columns × rank: z = M·t, t = basisᵀ·b, so that cov(z) = M·cov(t)·Mᵀ
    Eigen::MatrixXd hidden;   ///< columns × (columns − rank): undetermined combinations of z
    Eigen::MatrixXd basis;    ///< rows × rank, orthonormal: span of the columns
    Eigen::VectorXd residual; ///< b − A·x

    [[nodiscard]] double coefficient(Eigen::Index j) const { return scaled[j] / lengths[j]; }
    /// Returns the standard uncertainty of a coefficient relative to that with its column alone.
    [[nodiscard]] double inflation(Eigen::Index j) const { return toScaled.row(j).norm(); }
    /// Returns the undetermined part of the scaled coefficient, 0 … 1.
    [[nodiscard]] double hiddenPart(Eigen::Index j) const { return hidden.row(j).norm(); }
};

[[nodiscard]] ColumnFit columnFit(const Eigen::MatrixXd &columns, const Eigen::VectorXd &b,
                                  double rankTolerance = 1e-9);

} // namespace palmer
