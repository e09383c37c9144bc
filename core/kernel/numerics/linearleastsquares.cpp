#include "kernel/numerics/linearleastsquares.h"

#include <Eigen/Dense>

#include <cassert>
#include <cmath>

namespace palmer {

LinearLeastSquares linearLeastSquares(std::span<const std::vector<double>> columns, std::span<const double> b,
                                      const LinearLeastSquaresOptions &options) {
    using Status = LinearLeastSquares::Status;
    LinearLeastSquares result;
    const auto n = static_cast<Eigen::Index>(b.size());
    const auto p = static_cast<Eigen::Index>(columns.size());
    if (p == 0 || n < p)
        return result;

    const Eigen::Map<const Eigen::VectorXd> right(b.data(), n);
    if (!right.allFinite()) {
        result.status = Status::notFinite;
        return result;
    }
    Eigen::MatrixXd scaled(n, p);
    Eigen::VectorXd lengths(p);
    for (Eigen::Index j = 0; j < p; ++j) {
        const std::vector<double> &column = columns[static_cast<std::size_t>(j)];
        assert(column.size() == b.size());
        const Eigen::Map<const Eigen::VectorXd> values(column.data(), n);
        if (!values.allFinite()) {
            result.status = Status::notFinite;
            return result;
        }
        const double length = values.stableNorm();
        // A column of zeros stays one and costs a rank.
        lengths[j] = length > 0 ? length : 1;
        scaled.col(j) = values / lengths[j];
    }

    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
    qr.setThreshold(options.rankTolerance);
    qr.compute(scaled);
    result.rank = static_cast<int>(qr.rank());
    if (result.rank < p) {
        result.status = Status::rankDeficient;
        return result;
    }
    const Eigen::MatrixXd r = qr.matrixQR().topRows(p).triangularView<Eigen::Upper>();
    const Eigen::VectorXd singular = r.jacobiSvd().singularValues();
    result.condition = singular[0] / singular[p - 1];

    const Eigen::VectorXd x = qr.solve(right);
    const Eigen::VectorXd residuals = right - scaled * x;
    if (n > p)
        result.residualDeviation = residuals.norm() / std::sqrt(static_cast<double>(n - p));
    // (AᵀA)⁻¹ = P·R⁻¹·R⁻ᵀ·Pᵀ: its diagonal is that of the squared lengths of the rows of P·R⁻¹.
    const Eigen::MatrixXd inverse =
        qr.colsPermutation() *
        Eigen::MatrixXd(r.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(p, p)));
    for (Eigen::Index j = 0; j < p; ++j) {
        result.coefficients.push_back(x[j] / lengths[j]);
        result.standardUncertainties.push_back(result.residualDeviation * inverse.row(j).norm() / lengths[j]);
    }
    result.residuals.assign(residuals.data(), residuals.data() + n);
    result.status = Status::solved;
    return result;
}

} // namespace palmer
