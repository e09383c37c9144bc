// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/numerics/columnfit.h"

#include <Eigen/Dense>

#include <cassert>

namespace palmer {

ColumnFit columnFit(const Eigen::MatrixXd &columns, const Eigen::VectorXd &b, double rankTolerance) {
    assert(columns.rows() == b.size());
    ColumnFit fit;
    const Eigen::Index p = columns.cols();
    if (p == 0 || columns.rows() < p)
        return fit;
    fit.lengths = columns.colwise().norm();
    fit.lengths = (fit.lengths.array() > 0).select(fit.lengths, 1);
    Eigen::MatrixXd scaled = columns * fit.lengths.cwiseInverse().asDiagonal();

    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(scaled);
    const Eigen::MatrixXd triangle = qr.matrixQR().topRows(p).triangularView<Eigen::Upper>();
    const Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::NoQRPreconditioner> svd(triangle, Eigen::ComputeFullU |
                                                                                         Eigen::ComputeFullV);
    const Eigen::VectorXd &singular = svd.singularValues();
    Eigen::Index rank = 0;
    while (rank < p && singular[rank] > rankTolerance * singular[0] && singular[rank] > 0)
        ++rank;
    fit.rank = static_cast<int>(rank);
    fit.condition = rank > 0 ? singular[0] / singular[rank - 1] : 0;
    fit.toScaled = svd.matrixV().leftCols(rank) * singular.head(rank).cwiseInverse().asDiagonal();
    fit.hidden = svd.matrixV().rightCols(p - rank);
    // Compute Q·b from the reflections: exact even if the basis, made of ill-conditioned columns, is not.
    const Eigen::VectorXd turned = (qr.householderQ().adjoint() * b).head(p);
    fit.scaled = fit.toScaled * (svd.matrixU().leftCols(rank).adjoint() * turned);
    fit.basis = scaled * fit.toScaled;
    fit.residual = b - scaled * fit.scaled;
    return fit;
}

} // namespace palmer
