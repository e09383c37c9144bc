// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/diagnosis/residualtest.h"

#include "kernel/numerics/angles.h"
#include "kernel/numerics/studentt.h"

#include <array>
#include <cmath>
#include <numbers>

namespace palmer {

namespace {

constexpr double share = 0.01 / 5; ///< of each test

double angleOf(const PathPosition &p) {
    const double angle = std::atan2(p.sine, p.cosine) / degree;
    return angle < 0 ? angle + fullTurn : angle;
}

/// Sums over the whitened residual.
struct WhiteSums {
    WhiteSums(const PathRows &rows, const Eigen::VectorXd &white) {
        double last = 0;
        for (Eigen::Index i = 0; i < white.size(); ++i) {
            // Beside omitted readings nothing takes off what neighbours have in common.
            if (i == 0 || i + 1 == white.size() || !rows.counts(i - 1) || !rows.counts(i) ||
                !rows.counts(i + 1))
                continue;
            const PathPosition &p = rows.positions()[std::size_t(i)];
            const auto sector = std::size_t(angleOf(p) / fullTurn * sectors) % sectors;
            const double square = white[i] * white[i];
            squares[sector + (p.sense < 0 ? sectors : 0)] += square;
            ++counts[sector + (p.sense < 0 ? sectors : 0)];
            mean += square;
            ++count;
            // Small values have the sign of what the resolution leaves of the fit.
            if (std::abs(white[i]) > 0.5) {
                changes += white[i] * last < 0;
                last = white[i];
                ++signs;
            }
            if (std::abs(white[i]) > std::abs(white[largest]))
                largest = i;
        }
        mean /= count;
    }

    /// Returns the probability that equal variances differ as much: χ² of their logarithms.
    [[nodiscard]] double ofVariances() const {
        constexpr double fewest = 8;
        double sum = 0;
        double freedom = -1;
        for (std::size_t k = 0; k < counts.size(); ++k) {
            if (counts[k] < fewest)
                continue;
            const double ratio = std::log(std::max(squares[k] / counts[k] / mean, 1e-9));
            sum += counts[k] / 2 * ratio * ratio / (1 + 1 / counts[k]);
            ++freedom;
        }
        return chiSquareExceeded(sum, freedom);
    }

    static constexpr std::size_t sectors = 24; ///< in each sense
    std::array<double, 2 * sectors> squares{};
    std::array<double, 2 * sectors> counts{};
    double mean = 0; ///< square
    double count = 0;
    double signs = 0;
    double changes = 0; ///< of sign
    Eigen::Index largest = 0;
};

} // namespace

std::vector<Message> misfits(const PathRows &rows, const InfluenceFit &fit) {
    std::vector<Message> result;
    if (!(fit.residual > leastAmplitude))
        return result;
    const CorrelatedNoise::Judgement &spectrum = fit.noise.judgement();
    const Eigen::VectorXd white = fit.noise.whitened(fit.fit.residual, rows.records());
    const WhiteSums sums(rows, white);
    const auto see = [&](bool seen, const Text &text, std::vector<Argument> arguments = {}) {
        if (seen)
            result.push_back({text, std::move(arguments)});
    };
    see(sums.count * normalExceeded(white[sums.largest] / std::sqrt(sums.mean)) < share,
        REPORT_TEXT("report", "an outlier at %1"),
        {Number{angleOf(rows.positions()[std::size_t(sums.largest)]), Quantity::angle, 1}});
    see(spectrum.line < share, REPORT_TEXT("report", "a wave of %1 periods per turn"),
        {Number{spectrum.frequency * 2 * std::numbers::pi / rows.step(), Quantity::number, 1}});
    see(spectrum.flicker, REPORT_TEXT("report", "noise that grows towards slow waves (1/f)"));
    see(spectrum.slow, REPORT_TEXT("report", "a slow wave or drift"));
    see(sums.ofVariances() < share, REPORT_TEXT("report", "noise that differs between angles or senses"));
    const double changes = (sums.changes - (sums.signs - 1) / 2) / (std::sqrt(sums.signs - 1) / 2);
    see(result.empty() && (spectrum.bands < share || normalExceeded(changes) < share),
        REPORT_TEXT("report", "noise of another kind than white with a short memory"));
    return result;
}

} // namespace palmer
