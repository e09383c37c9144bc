// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/diagnosis/diagnosis.h"
#include "kernel/numerics/points.h"

namespace palmer {

/// Returns the part not explained by any source, mm, at each point of each arc: distance from the least
/// squares centre minus nominal radius and the trace of all sources. For a diagnosis of this circle alone.
[[nodiscard]] std::vector<std::vector<double>> unexplained(const DiagnosedCircle &circle,
                                                           const Diagnosis &diagnosis);

/// Returns the points due to the chosen sources, mm about the programmed centre: each measured point moved
/// radially from the least squares centre onto the fitted circle with only the deviation of the chosen
/// sources.
[[nodiscard]] std::vector<Points> syntheticPath(const DiagnosedCircle &circle, const Diagnosis &diagnosis,
                                                std::span<const std::size_t> chosen);

/// The circle of the fit: centre, mm about the programmed one, and radius, mm. If the arcs do not determine
/// them: the least squares centre and the mean distance from it.
struct FittedCircle {
    Point centre;
    double radius = 0;
};
[[nodiscard]] FittedCircle fittedCircle(const DiagnosedCircle &circle, const Diagnosis &diagnosis);

/// An item of the diagnosis: one source, or several of which only a sum is known.
struct DiagnosedPart {
    std::vector<std::size_t> sources; ///< all sources of its trace
    const SourceSum *sum = nullptr;
    double contribution = 0; ///< to G(b), on its own, mm
};

/// Returns the parts, largest first, without centre and radius, which do not contribute to G(b), and without
/// completely undetermined sources.
[[nodiscard]] std::vector<DiagnosedPart> rankedParts(const Diagnosis &diagnosis);

/// Widths of minimum zones of all arcs together, mm.
struct TracedWidths {
    double measured = 0; ///< G(b); G for one sense
    double chosen = 0;   ///< of the chosen sources alone
    double without = 0;  ///< measured without the chosen sources
};
[[nodiscard]] TracedWidths tracedWidths(const DiagnosedCircle &circle, const Diagnosis &diagnosis,
                                        std::span<const std::size_t> chosen);

/// Returns how many of `rankedParts`, from the first, make up most of the path: at least 80 % of the width of
/// all parts larger than three times their uncertainty, none after the first that is not. Uses only some
/// thousand points per arc.
[[nodiscard]] std::size_t prevailingParts(const DiagnosedCircle &circle, const Diagnosis &diagnosis);

/// A line of a spectrum.
struct SpectralLine {
    double perTurn = 0;              ///< waves per turn, n
    std::optional<double> frequency; ///< n·F/(2πR), Hz; null if the feed is not stated
    double amplitude = 0;            ///< mm
};

/// Returns the amplitudes of a curve over an arc with equal angular steps: 0 < n ≤ half the points per turn.
/// A vibration of frequency f appears at n = 2πR·f/F. Empty for fewer than 16 points. Beyond 4 096 points,
/// some of the last are omitted if their number has a large prime factor.
[[nodiscard]] std::vector<SpectralLine> spectrum(const DiagnosedCircle &circle, std::size_t arc,
                                                 std::span<const double> curve);

} // namespace palmer
