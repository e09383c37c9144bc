// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/diagnosis/influences.h"
#include "kernel/evaluation/testevaluation.h"
#include "kernel/words/message.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace palmer {

/// One sense of a circle, as it was evaluated. Views: whoever fills them keeps the points.
struct DiagnosedArc {
    Sense sense = Sense::counterclockwise;
    PointsView points;          ///< mm about the programmed centre, in the order of time
    std::vector<double> angles; ///< of the points, unwrapped degrees
    bool commanded = false;     ///< the angles are those of the programmed path
};

/// One circular test, of which the diagnosis looks at the arcs that were evaluated.
struct DiagnosedCircle {
    std::string first; ///< axes of the plane
    std::string second;
    double nominalRadius = 0;   ///< mm
    std::optional<double> feed; ///< mm/s
    bool feedback = false;      ///< the position came from the scales of the machine
    std::vector<DiagnosedArc> arcs;
    std::optional<Point> centre; ///< of least squares, where it is known already
};

/// The evaluated arcs of a test. `results` has to outlive it.
[[nodiscard]] DiagnosedCircle diagnosedCircle(const CircularMeasurement &measurement,
                                              const CircularResults &results);

struct DiagnosisOptions {
    /// Pitch of the screw or scale of the first and second axis, mm: their cyclic error is fitted. Null: the
    /// plausible pitches are tried where `search` is set.
    std::array<std::optional<double>, 2> pitch;
    /// Width of the reversal spikes, degrees: they are fitted. Null: widths are tried where `search` is set.
    std::optional<double> spikeWidth;
    /// Look for reversal spikes, cyclic errors and a drift, and fit those that are significant.
    bool search = true;
    bool drift = false; ///< fit a drift of the radius in any case
    /// Between the end of one arc and the start of the next, in turns of the circle; null: unknown, then a
    /// drift comes with a free step between the arcs.
    std::optional<double> pause;
};

/// What the circle says about one influence. Values in base units (mm, rad, s, see Influence), µm and the
/// like by `shownParameter`.
struct SourceEstimate {
    InfluenceId id = InfluenceId::centre;
    PlaneAxis axis = PlaneAxis::none;
    std::string axisName; ///< letter of the axis, or "X–Y"
    bool separable = false;
    std::vector<std::size_t> with;      ///< if not: places of the sources it cannot be told from
    std::optional<double> value;        ///< null where it cannot be told, or the feed is not stated
    std::optional<double> u;            ///< standard uncertainty of the fit alone
    double degreesOfFreedom = 0;        ///< of u
    std::optional<double> contribution; ///< to G(b), alone, mm; null where it cannot be told
    std::optional<double> pitch;        ///< of a cyclic error, mm
    std::optional<double> phase;        ///< of a cyclic error in the centre of the circle, rad
    std::optional<double> width;        ///< of a reversal spike, degrees
    std::optional<double> step;         ///< of a drift: radius counterclockwise − clockwise, mm
    bool proposed = false;              ///< was looked for and found, not stated
    std::optional<double> significance; ///< if so: probability that noise alone looks as much like it
    double shape = 0;                   ///< of the columns
    std::array<double, 2> fitted{};     ///< factors of both columns: what the trace is made of

    /// The 95 % interval, base units; null without value.
    [[nodiscard]] std::optional<Interval> interval() const;
};

/// u of a source in the unit it is shown in; 0 without u. The time of a lag is the root of what was fitted:
/// near 0 its u is that of the root.
[[nodiscard]] double shownUncertainty(const SourceEstimate &source);

/// What is known of sources that cannot be told apart: Σ factor·value of them.
struct SourceSum {
    struct Part {
        std::size_t source = 0;
        double factor = 1; ///< of the values in shown units
    };
    std::vector<Part> of;
    double value = 0; ///< in the unit the first is shown in
    double u = 0;
    double contribution = 0; ///< of all of them together to G(b), mm
};

/// What a circle, or several of one plane at different feeds, says about the machine: an interpretation, not
/// a result of ISO 230-4 (its Annex B, and beyond).
struct Diagnosis {
    std::string first; ///< axes of the plane
    std::string second;
    int rank = 0;                        ///< parameters that the circle can tell
    int of = 0;                          ///< parameters that were fitted
    double condition = 0;                ///< of the scaled columns
    double residual = 0;                 ///< standard deviation of what no source explains, mm
    double readingsPerIndependent = 1;   ///< how many neighbouring readings are worth one
    std::size_t points = 0;              ///< that the fit used
    double lagAngle = 0;                 ///< of commanded angles: what the pattern lags behind them, degrees
    double pause = 0;                    ///< between the arcs, turns; as stated
    std::vector<SourceEstimate> sources; ///< those that count most first, centre and radius last
    std::vector<SourceSum> sums;
    std::vector<Message> remarks;

    [[nodiscard]] bool valid() const { return rank > 0; }
    [[nodiscard]] const SourceEstimate *find(InfluenceId id, PlaneAxis axis = PlaneAxis::none) const;
};

/// Fits the influences to a circle: one linear least-squares fit over both senses, of the rebuilt points
/// about the least squares centre. Readings within 0.1° (or the angle of the largest deviation) of a reversal
/// do not count: a step there belongs to one side or the other, nobody knows which.
/// What cannot be told apart (no part in the null space and at most ten times the uncertainty of its column
/// alone is asked for) has no value; the sum of it has.
/// Uncertainties count the correlation of neighbouring readings (numerics/correlatednoise.h).
/// Beyond 7 200 readings an arc, means of neighbours are fitted, columns and deviations alike.
/// Not valid (rank 0) without points enough: 30 that count.
[[nodiscard]] Diagnosis diagnose(const DiagnosedCircle &circle, const DiagnosisOptions &options = {});

/// The same of several circles of one plane and radius at different feeds: tells the lag, which grows with
/// the square of the feed, from radius and scales. The centres are those of each circle and not listed.
[[nodiscard]] Diagnosis diagnose(std::span<const DiagnosedCircle> circles,
                                 const DiagnosisOptions &options = {});

/// Whether the circles can be diagnosed together: one plane and radius, feeds known, two of them different.
[[nodiscard]] bool areSeveralFeeds(std::span<const DiagnosedCircle> circles);

} // namespace palmer
