// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/diagnosis/diagnosis.h"
#include "kernel/numerics/points.h"

namespace palmer {

/// The radial deviation, mm, that the chosen sources (places in `sources`) make at each point of each arc of
/// the circle. Sources without value belong to a sum: all of its members together make its trace.
[[nodiscard]] std::vector<std::vector<double>> syntheticTrace(const DiagnosedCircle &circle,
                                                              const Diagnosis &diagnosis,
                                                              std::span<const std::size_t> chosen);

/// What no source explains, mm, at each point of each arc: distance from the least squares centre minus
/// nominal radius and the trace of all sources. Of a diagnosis of this circle alone.
[[nodiscard]] std::vector<std::vector<double>> unexplained(const DiagnosedCircle &circle,
                                                           const Diagnosis &diagnosis);

/// The points that the chosen sources make, mm about the programmed centre: where each measured point would
/// lie in its direction from the least squares centre, on the fitted circle with no other deviation than that
/// of the chosen.
[[nodiscard]] std::vector<Points> syntheticPath(const DiagnosedCircle &circle, const Diagnosis &diagnosis,
                                                std::span<const std::size_t> chosen);

/// The circle of the fit: its centre, mm about the programmed one, and its radius, mm; of what the arcs do
/// not tell the least squares centre and the mean distance from it.
struct FittedCircle {
    Point centre;
    double radius = 0;
};
[[nodiscard]] FittedCircle fittedCircle(const DiagnosedCircle &circle, const Diagnosis &diagnosis);

/// What is told of a circle, one by one: a source, or those of which only a sum is known.
struct DiagnosedPart {
    std::vector<std::size_t> sources; ///< all that make its trace
    const SourceSum *sum = nullptr;
    double contribution = 0; ///< to G(b), alone, mm
};

/// The largest first; centre and radius, which have no part in G(b), are none of them, nor is what is not
/// told at all.
[[nodiscard]] std::vector<DiagnosedPart> rankedParts(const Diagnosis &diagnosis);

/// Widths of minimum zones of all arcs together, mm.
struct TracedWidths {
    double measured = 0; ///< G(b); of one sense G
    double chosen = 0;   ///< what the chosen sources make alone
    double without = 0;  ///< what is left of the measured without them
};
[[nodiscard]] TracedWidths tracedWidths(const DiagnosedCircle &circle, const Diagnosis &diagnosis,
                                        std::span<const std::size_t> chosen);

/// How many of `rankedParts`, from the first on, make most of the path: at least 80 % of the width that all
/// make together that stand out of three times their uncertainty; none behind one that does not. Looks at no
/// more than some thousand points of an arc.
[[nodiscard]] std::size_t prevailingParts(const DiagnosedCircle &circle, const Diagnosis &diagnosis);

/// A line of a spectrum.
struct SpectralLine {
    double perTurn = 0;              ///< waves a turn, n
    std::optional<double> frequency; ///< n·F/(2πR), Hz; null where the feed is not stated
    double amplitude = 0;            ///< mm
};

/// Amplitudes of a curve over an arc whose points follow each other at equal angles: 0 < n ≤ half the points
/// a turn. A vibration of frequency f stands out at n = 2πR·f/F. Empty for less than 16 points.
/// Of more than 4 096 points whose number has a large prime factor some of the last are left out.
[[nodiscard]] std::vector<SpectralLine> spectrum(const DiagnosedCircle &circle, std::size_t arc,
                                                 std::span<const double> curve);

} // namespace palmer
