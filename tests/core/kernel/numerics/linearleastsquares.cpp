#include "kernel/numerics/linearleastsquares.h"

#include "referencecircles.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>

using namespace palmer;
using Status = LinearLeastSquares::Status;
using Columns = std::vector<std::vector<double>>;

class LinearLeastSquaresTest : public QObject {
    Q_OBJECT

private slots:
    void straightLineAsByHand();
    void scaleOfColumnsDoesNotCount();
    void uncertaintiesAreThoseOfRepetition();
    void circularPairWithKnownTruth();
    void dependentColumnsAreRefused();
    void badInput();
};

void LinearLeastSquaresTest::straightLineAsByHand() {
    // b = 1 + 2t with residuals +1, −2, +1 (orthogonal to both columns) of three points.
    const Columns columns{{1, 1, 1}, {0, 1, 2}};
    const std::vector<double> b{2, 1, 6};
    const LinearLeastSquares fit = linearLeastSquares(columns, b);
    QCOMPARE(fit.status, Status::solved);
    QCOMPARE(fit.rank, 2);
    const auto near = [](double value, double expected) { return std::abs(value - expected) <= 1e-14; };
    QVERIFY(near(fit.coefficients.at(0), 1));
    QVERIFY(near(fit.coefficients.at(1), 2));
    QVERIFY(near(fit.residuals.at(0), 1));
    QVERIFY(near(fit.residuals.at(1), -2));
    QVERIFY(near(fit.residuals.at(2), 1));
    // s² = 6/1; (AᵀA)⁻¹ = [5 −3; −3 3]/6.
    QVERIFY(near(fit.residualDeviation, std::sqrt(6)));
    QVERIFY(near(fit.standardUncertainties.at(0), std::sqrt(5)));
    QVERIFY(near(fit.standardUncertainties.at(1), std::sqrt(3)));
    // Unit columns with the cosine 3/√15: √((1 + cos)/(1 − cos)).
    const double cosine = 3 / std::sqrt(15);
    QVERIFY(std::abs(fit.condition - std::sqrt((1 + cosine) / (1 - cosine))) <= 1e-13);
}

void LinearLeastSquaresTest::scaleOfColumnsDoesNotCount() {
    const Columns columns{{1, 1, 1, 1}, {0, 1, 2, 4}};
    Columns scaled = columns;
    for (double &value : scaled[1])
        value *= 1e-12;
    const std::vector<double> b{2, 1, 6, 9};
    const LinearLeastSquares fit = linearLeastSquares(columns, b);
    const LinearLeastSquares other = linearLeastSquares(scaled, b);
    QCOMPARE(other.status, Status::solved);
    QVERIFY(std::abs(other.condition - fit.condition) <= 1e-13 * fit.condition);
    QVERIFY(std::abs(other.coefficients.at(0) - fit.coefficients.at(0)) <= 1e-13);
    QVERIFY(std::abs(1e-12 * other.coefficients.at(1) - fit.coefficients.at(1)) <= 1e-13);
    QVERIFY(std::abs(1e-12 * other.standardUncertainties.at(1) - fit.standardUncertainties.at(1)) <= 1e-13);
}

void LinearLeastSquaresTest::uncertaintiesAreThoseOfRepetition() {
    // The scatter of the coefficients over repetitions with noise is the uncertainty that each one states.
    std::mt19937_64 random(1);
    std::normal_distribution<double> noise(0, 0.5);
    Columns columns(3);
    for (int i = 0; i < 40; ++i) {
        columns[0].push_back(1);
        columns[1].push_back(i);
        columns[2].push_back(0.1 * i * i);
    }
    constexpr int repetitions = 4000;
    std::vector<double> square(3);
    std::vector<double> stated(3);
    for (int k = 0; k < repetitions; ++k) {
        std::vector<double> b;
        for (std::size_t i = 0; i < 40; ++i)
            b.push_back(3 * columns[0][i] - columns[1][i] + 2 * columns[2][i] + noise(random));
        const LinearLeastSquares fit = linearLeastSquares(columns, b);
        const double truth[]{3, -1, 2};
        for (std::size_t j = 0; j < 3; ++j) {
            square[j] += std::pow(fit.coefficients[j] - truth[j], 2) / repetitions;
            stated[j] += std::pow(fit.standardUncertainties[j], 2) / repetitions;
        }
    }
    for (std::size_t j = 0; j < 3; ++j) // a variance of 4000 repetitions is known to 2.2 %: four times that
        QVERIFY(std::abs(square[j] / stated[j] - 1) <= 0.09);
}

void LinearLeastSquaresTest::circularPairWithKnownTruth() {
    // Truth: ballbar_pair_truth.txt; feed 1000 mm/min, radius 150 mm. Each column is the radial deviation
    // that one source makes: centre, radius, mismatch of scales, squareness, lag, lost motion, play,
    // straightness.
    constexpr double radius = 150;
    constexpr double feed = 1000.0 / 60;
    Columns columns(12);
    std::vector<double> b;
    for (const double sense : {1.0, -1.0}) {
        const reference::Path path =
            reference::ballbarPath(sense > 0 ? QStringLiteral("ccw") : QStringLiteral("cw"));
        for (std::size_t i = 0; i < path.angles.size(); ++i) {
            const Point one = direction(path.angles[i]);
            const Point two = direction(2 * path.angles[i]);
            const Point three = direction(3 * path.angles[i]);
            const double c = one.x;
            const double s = one.y;
            const double row[]{c,
                               s,
                               1,
                               radius * two.x,
                               -radius / 2 * two.y,
                               sense * feed / 2 * two.y,
                               sense / 2 * std::copysign(1, s) * c,
                               -sense / 2 * std::copysign(1, c) * s,
                               -sense / 2 * std::abs(s),
                               sense / 2 * std::abs(c),
                               (s + three.y) / 4,
                               (c - three.x) / 4};
            for (std::size_t j = 0; j < 12; ++j)
                columns[j].push_back(row[j]);
            b.push_back(path.radii[i] - radius);
        }
    }
    const LinearLeastSquares fit = linearLeastSquares(columns, b);
    QCOMPARE(fit.status, Status::solved);
    QCOMPARE(fit.rank, 12);
    QVERIFY(fit.condition > 5 && fit.condition < 7);
    // The centre is that of the instrument, e = (0.012, −0.008). (The a and b of the file are the whole first
    // harmonic, straightness included: a + σ_y/4 and b + σ_x/4.)
    const double truth[]{-0.012, 0.008, 1.125e-3, 3.25e-5, 3e-5, 6e-4,
                         6e-3,   -4e-3, 3e-3,     1.5e-3,  8e-3, -5e-3};
    // 2e-3 µm, 0.01 µrad (of the mismatch, half of it), 1e-4 ms.
    const double tolerance[]{2e-6, 2e-6, 2e-6, 5e-9, 1e-8, 1e-7, 2e-6, 2e-6, 2e-6, 2e-6, 2e-6, 2e-6};
    for (std::size_t j = 0; j < 12; ++j)
        QVERIFY2(std::abs(fit.coefficients[j] - truth[j]) <= tolerance[j], QByteArray::number(int(j)));
    QVERIFY(std::abs(fit.coefficients[0] + fit.coefficients[11] / 4 + 1.325e-2) <= 2e-6);
    QVERIFY(std::abs(fit.coefficients[1] + fit.coefficients[10] / 4 - 1e-2) <= 2e-6);
    // One sense alone cannot tell squareness from lag.
    for (std::vector<double> &column : columns)
        column.resize(1800);
    b.resize(1800);
    QCOMPARE(linearLeastSquares(columns, b).status, Status::rankDeficient);
}

void LinearLeastSquaresTest::dependentColumnsAreRefused() {
    const std::vector<double> b{1, 2, 3, 5};
    const Columns dependent{{1, 1, 1, 1}, {0, 1, 2, 3}, {1, 3, 5, 7}};
    const LinearLeastSquares fit = linearLeastSquares(dependent, b);
    QCOMPARE(fit.status, Status::rankDeficient);
    QCOMPARE(fit.rank, 2);
    QVERIFY(fit.coefficients.empty());
    const Columns zero{{1, 1, 1, 1}, {0, 0, 0, 0}};
    QCOMPARE(linearLeastSquares(zero, b).status, Status::rankDeficient);
    QCOMPARE(linearLeastSquares(zero, b).rank, 1);
}

void LinearLeastSquaresTest::badInput() {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    QCOMPARE(linearLeastSquares({}, {}).status, Status::tooFewRows);
    QCOMPARE(linearLeastSquares({}, std::vector<double>{1, 2}).status, Status::tooFewRows);
    QCOMPARE(linearLeastSquares(Columns{{1}, {2}}, std::vector<double>{1}).status, Status::tooFewRows);
    QCOMPARE(linearLeastSquares(Columns{{1, nan}}, std::vector<double>{1, 2}).status, Status::notFinite);
    QCOMPARE(linearLeastSquares(Columns{{1, 2}}, std::vector<double>{1, nan}).status, Status::notFinite);
    // As many rows as columns: an exact solution, of which nothing tells the uncertainty.
    const LinearLeastSquares fit = linearLeastSquares(Columns{{1, 1}, {0, 1}}, std::vector<double>{1, 3});
    QCOMPARE(fit.status, Status::solved);
    QVERIFY(std::abs(fit.coefficients.at(1) - 2) <= 1e-15);
    QCOMPARE(fit.standardUncertainties, (std::vector<double>{0, 0}));
}

QTEST_GUILESS_MAIN(LinearLeastSquaresTest)
#include "linearleastsquares.moc"
