// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/numerics/columnfit.h"

#include "kernel/numerics/correlatednoise.h"

#include <QTest>

#include <array>
#include <cmath>
#include <random>

using namespace palmer;

/// The linear fit, and what its residuals say about the noise.
class ColumnFitTest : public QObject {
    Q_OBJECT

private slots:
    void straightLineAsByHand();
    void scaleOfColumnsDoesNotCount();
    void dependentColumnsAreTold();
    void longColumnsAgainstShortOnes();
    void badInput();
    void uncertaintiesAreThoseOfRepetition_data();
    void uncertaintiesAreThoseOfRepetition();
    void noiseWithoutResidual();
};

namespace {

bool near(double value, double expected, double tolerance = 1e-13) {
    return std::abs(value - expected) <= tolerance;
}

} // namespace

void ColumnFitTest::straightLineAsByHand() {
    // b = 1 + 2t with residuals +1, −2, +1 (orthogonal to both columns) of three points.
    Eigen::MatrixXd columns(3, 2);
    columns << 1, 0, 1, 1, 1, 2;
    const ColumnFit fit = columnFit(columns, Eigen::Vector3d(2, 1, 6));
    QCOMPARE(fit.rank, 2);
    QVERIFY(near(fit.coefficient(0), 1) && near(fit.coefficient(1), 2));
    QVERIFY(near(fit.residual[0], 1) && near(fit.residual[1], -2) && near(fit.residual[2], 1));
    // Unit columns with the cosine 3/√15: √((1 + cos)/(1 − cos)).
    const double cosine = 3 / std::sqrt(15);
    QVERIFY(near(fit.condition, std::sqrt((1 + cosine) / (1 - cosine))));
    // (AᵀA)⁻¹ = [5 −3; −3 3]/6
    QVERIFY(near(fit.inflation(0) / fit.lengths[0], std::sqrt(5.0 / 6)));
    QVERIFY(near(fit.inflation(1) / fit.lengths[1], std::sqrt(3.0 / 6)));
    QVERIFY(near(fit.toScaled.row(0).dot(fit.toScaled.row(1)) / fit.lengths[0] / fit.lengths[1], -0.5));
    QVERIFY((fit.basis.transpose() * fit.basis - Eigen::Matrix2d::Identity()).norm() < 1e-14);
}

void ColumnFitTest::scaleOfColumnsDoesNotCount() {
    Eigen::MatrixXd columns(4, 2);
    columns << 1, 0, 1, 1, 1, 2, 1, 4;
    Eigen::MatrixXd scaled = columns;
    scaled.col(1) *= 1e-12;
    const Eigen::Vector4d b(2, 1, 6, 9);
    const ColumnFit fit = columnFit(columns, b);
    const ColumnFit other = columnFit(scaled, b);
    QCOMPARE(other.rank, 2);
    QVERIFY(near(other.condition / fit.condition, 1));
    QVERIFY(near(other.coefficient(0), fit.coefficient(0)));
    QVERIFY(near(1e-12 * other.coefficient(1), fit.coefficient(1)));
}

void ColumnFitTest::dependentColumnsAreTold() {
    // The third is the first and twice the second; the fourth stands alone.
    Eigen::MatrixXd columns(5, 4);
    columns << 1, 0, 1, 0, 1, 1, 3, 0, 1, 2, 5, 0, 1, 3, 7, 1, 1, 4, 9, -1;
    Eigen::VectorXd truth(4);
    truth << 1, 2, 3, 4;
    const ColumnFit fit = columnFit(columns, columns * truth);
    QCOMPARE(fit.rank, 3);
    QVERIFY(fit.residual.norm() < 1e-12);
    QVERIFY(fit.hiddenPart(0) > 0.1 && fit.hiddenPart(1) > 0.1 && fit.hiddenPart(2) > 0.1);
    QVERIFY(fit.hiddenPart(3) < 1e-12);
    QVERIFY(near(fit.coefficient(3), 4, 1e-12));
    // What can be told of the others: first + third, second + 2·third.
    QVERIFY(near(fit.coefficient(0) + fit.coefficient(2), 4, 1e-12));
    QVERIFY(near(fit.coefficient(1) + 2 * fit.coefficient(2), 8, 1e-12));
    Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(4, 2);
    zero.col(0).setOnes();
    const ColumnFit nothing = columnFit(zero, Eigen::Vector4d(1, 2, 3, 4));
    QCOMPARE(nothing.rank, 1);
    QVERIFY(near(nothing.coefficient(0), 2.5) && nothing.coefficient(1) == 0 && nothing.hiddenPart(1) > 0.99);
}

void ColumnFitTest::longColumnsAgainstShortOnes() {
    // Almost dependent, by 1e-7: still told, at its price.
    Eigen::MatrixXd columns(50, 2);
    for (int i = 0; i < 50; ++i)
        columns.row(i) << 1 + 0.1 * i, 1 + 0.1 * i + (i % 2 == 0 ? 1e-7 : -1e-7);
    const ColumnFit fit = columnFit(columns, columns * Eigen::Vector2d(2, 3));
    QCOMPARE(fit.rank, 2);
    QVERIFY(fit.condition > 1e7);
    QVERIFY(fit.inflation(0) > 1e6);
    QVERIFY(near(fit.coefficient(0), 2, 1e-6));
    QCOMPARE(columnFit(columns, columns * Eigen::Vector2d(2, 3), 1e-6).rank, 1);
}

void ColumnFitTest::badInput() {
    QCOMPARE(columnFit(Eigen::MatrixXd(3, 0), Eigen::Vector3d::Zero()).rank, 0);
    QCOMPARE(columnFit(Eigen::MatrixXd::Ones(1, 2), Eigen::VectorXd::Ones(1)).rank, 0);
    QCOMPARE(columnFit(Eigen::MatrixXd::Zero(3, 2), Eigen::Vector3d::Ones()).rank, 0);
}

void ColumnFitTest::uncertaintiesAreThoseOfRepetition_data() {
    QTest::addColumn<double>("correlation");
    QTest::newRow("white") << 0.0;
    QTest::newRow("neighbours alike") << 0.8;
    QTest::newRow("neighbours rather opposite") << -0.3;
}

void ColumnFitTest::uncertaintiesAreThoseOfRepetition() {
    QFETCH(double, correlation);
    constexpr int n = 240;
    std::mt19937_64 random(1);
    std::normal_distribution<double> noise(0, 0.5);
    Eigen::MatrixXd columns(n, 3);
    for (int i = 0; i < n; ++i)
        columns.row(i) << 1, std::cos(0.1 * i), std::sin(0.02 * i);
    const std::array records{Record{0, n / 2, n / 2}, Record{n / 2, n / 2, n / 2}};
    constexpr int repetitions = 1500;
    Eigen::Vector3d square = Eigen::Vector3d::Zero();
    Eigen::Vector3d stated = Eigen::Vector3d::Zero();
    for (int k = 0; k < repetitions; ++k) {
        Eigen::VectorXd b(n);
        double last = 0;
        for (int i = 0; i < n; ++i) {
            const bool begins = i == 0 || i == n / 2;
            last = begins ? noise(random)
                          : correlation * last + std::sqrt(1 - correlation * correlation) * noise(random);
            b[i] = last;
        }
        const ColumnFit fit = columnFit(columns, b);
        const CorrelatedNoise model(fit.basis, fit.residual, records);
        for (int j = 0; j < 3; ++j) {
            const Eigen::VectorXd weights = fit.toScaled.row(j).transpose() / fit.lengths[j];
            square[j] += std::pow(fit.coefficient(j), 2) / repetitions;
            stated[j] += std::pow(model.standardUncertainty(weights), 2) / repetitions;
            QVERIFY(model.degreesOfFreedom(weights) >= 1);
        }
        const double independent = model.readingsPerIndependent();
        QVERIFY(independent > 0);
    }
    // A variance of 1500 repetitions is known to 3.7 %, and the model of the noise is one of a few that fit.
    for (int j = 0; j < 3; ++j)
        QVERIFY2(std::abs(stated[j] / square[j] - 1) <= 0.25, QByteArray::number(stated[j] / square[j]));
}

void ColumnFitTest::noiseWithoutResidual() {
    const Eigen::MatrixXd columns = Eigen::VectorXd::LinSpaced(20, 1, 20);
    const ColumnFit fit = columnFit(columns, 2 * columns);
    const CorrelatedNoise model(fit.basis, Eigen::VectorXd::Zero(20), std::array{Record{0, 20, 20}});
    QCOMPARE(model.standardUncertainty(Eigen::VectorXd::Ones(1)), 0.0);
    QCOMPARE(model.degreesOfFreedom(Eigen::VectorXd::Ones(1)), 1.0);
    QCOMPARE(model.readingsPerIndependent(), 1.0);
}

QTEST_GUILESS_MAIN(ColumnFitTest)
#include "columnfit.moc"
