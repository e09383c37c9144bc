#pragma once

#include "kernel/diagnosis/diagnosis.h"

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

/// A line of a spectrum.
struct SpectralLine {
    double perTurn = 0;              ///< waves a turn, n
    std::optional<double> frequency; ///< n·F/(2πR), Hz; null where the feed is not stated
    double amplitude = 0;            ///< mm
};

/// Amplitudes of a curve over an arc whose points follow each other at equal angles: 0 < n ≤ half the points
/// a turn. A vibration of frequency f stands out at n = 2πR·f/F. Empty for less than 16 points.
[[nodiscard]] std::vector<SpectralLine> spectrum(const DiagnosedCircle &circle, std::size_t arc,
                                                 std::span<const double> curve);

} // namespace palmer
