// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace palmer {

/// Linear least squares whose columns need not be independent: the coefficients x that minimise |b − A·x|²,
/// and which combinations of them the rows can tell.
///
/// Method: columns scaled to unit length, z_j = x_j·|A_j|; Householder QR; singular values of the triangle,
/// R = U·S·Vᵀ. Those below rankTolerance times the greatest count as zero: their combinations V of the z
/// cannot be told and get no part of the solution (that of least |z|).
/// Validity: columns of any scale and unit, finite numbers; at least as many rows as columns, else rank 0. A
/// column of zeros costs a rank.
///
/// Source: G. H. Golub, C. F. Van Loan, Matrix Computations, 4th ed. (2013), 5.3.8 (scaling), 5.4 (rank).
struct ColumnFit {
    int rank = 0;
    double condition = 0;    ///< greatest by least of the singular values that count
    Eigen::VectorXd lengths; ///< |A_j|, of columns of zeros 1
    Eigen::VectorXd scaled;  ///< z
    Eigen::MatrixXd toScaled; ///< M, columns × rank: z = M·t, t = basisᵀ·b, so that cov(z) = M·cov(t)·Mᵀ
    Eigen::MatrixXd hidden;   ///< columns × (columns − rank): the combinations of z that cannot be told
    Eigen::MatrixXd basis;    ///< rows × rank, orthonormal: what the columns can reach
    Eigen::VectorXd residual; ///< b − A·x

    [[nodiscard]] double coefficient(Eigen::Index j) const { return scaled[j] / lengths[j]; }
    /// How much larger the standard uncertainty of a coefficient is than it would be with its column alone.
    [[nodiscard]] double inflation(Eigen::Index j) const { return toScaled.row(j).norm(); }
    /// Part of the scaled coefficient that cannot be told, 0 … 1.
    [[nodiscard]] double hiddenPart(Eigen::Index j) const { return hidden.row(j).norm(); }
};

[[nodiscard]] ColumnFit columnFit(const Eigen::MatrixXd &columns, const Eigen::VectorXd &b,
                                  double rankTolerance = 1e-9);

} // namespace palmer
