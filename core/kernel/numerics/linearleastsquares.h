#pragma once

#include <span>
#include <vector>

namespace palmer {

struct LinearLeastSquaresOptions {
    /// The rank p is the number of |R_kk| > rankTolerance·max |R_ii| of the scaled matrix.
    double rankTolerance = 1e-10;
};

/// Linear least squares: the coefficients x that minimise Σ_i (b_i − Σ_j A_ij·x_j)², and how well they are
/// known.
///
/// Method: columns scaled to unit length, Householder QR with column pivoting. With the residuals
/// v = b − A·x of n rows and p columns
///     s² = Σ v²/(n − p),   C = s²·(AᵀA)⁻¹,   u(x_j) = √C_jj.
/// Validity: columns of any scale and unit. If some columns depend on others, no coefficient is given (which
/// ones could be told apart is for the caller to decide, by leaving columns out); the rank is.
///
/// Source: G. H. Golub, C. F. Van Loan, Matrix Computations, 4th ed. (2013), 5.3.8 (scaling), 5.4.2
/// (pivoting).
struct LinearLeastSquares {
    enum class Status {
        solved,
        rankDeficient, ///< Columns depend on each other, or one is zero.
        tooFewRows,    ///< Fewer rows than columns, or no column.
        notFinite,     ///< An element is not a finite number.
    };

    Status status = Status::tooFewRows;
    std::vector<double> coefficients;          ///< x, in units of b per unit of the column
    std::vector<double> standardUncertainties; ///< u(x); zeros where n = p
    std::vector<double> residuals;             ///< v, in units of b
    double residualDeviation = 0;              ///< s, in units of b; 0 where n = p
    int rank = 0;                              ///< p if solved
    double condition = 0;                      ///< Greatest by least singular value of the scaled columns.

    bool operator==(const LinearLeastSquares &) const = default;
};

/// `columns` of A, each with as many elements as `b`.
[[nodiscard]] LinearLeastSquares linearLeastSquares(std::span<const std::vector<double>> columns,
                                                    std::span<const double> b,
                                                    const LinearLeastSquaresOptions &options = {});

} // namespace palmer
