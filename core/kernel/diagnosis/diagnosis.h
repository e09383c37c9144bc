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

/// One sense of a circle, as evaluated. A view: the caller owns the points.
struct DiagnosedArc {
    Sense sense = Sense::counterclockwise;
    PointsView points;          ///< mm about the programmed centre, in chronological order
    std::vector<double> angles; ///< of the points, unwrapped degrees
    bool commanded = false;     ///< angles are those of the programmed path
};

/// A circular test with its evaluated arcs.
struct DiagnosedCircle {
    std::string first; ///< axes of the plane
    std::string second;
    double nominalRadius = 0;   ///< mm
    std::optional<double> feed; ///< mm/s
    bool feedback = false;      ///< the position was read from the scales of the machine
    double resolution = 0;      ///< of the readings, mm; 0: finer than can be told
    std::vector<DiagnosedArc> arcs;
    std::optional<Point> centre; ///< least squares centre, if already known
    Point setUp;                 ///< already taken out of the points: centre as the instrument saw it, mm
};

/// Returns the evaluated arcs of a test. `results` must outlive it.
[[nodiscard]] DiagnosedCircle diagnosedCircle(const CircularMeasurement &measurement,
                                              const CircularResults &results);

struct DiagnosisOptions {
    /// Pitch of the screw or scale of the first and second axis, mm: their cyclic error is fitted. Null:
    /// plausible pitches are tried if `search` is set.
    std::array<std::optional<double>, 2> pitch;
    /// Width of the reversal spikes, degrees: they are fitted. Null: widths are tried if `search` is set.
    std::optional<double> spikeWidth;
    /// Search for reversal spikes, cyclic errors and a drift, and fit the significant ones.
    bool search = true;
    bool drift = false; ///< always fit a drift of the radius
    /// Between the end of one arc and the start of the next, in turns of the circle; null: unknown, so a
    /// drift is fitted with a free step between the arcs.
    std::optional<double> pause;
};

/// Result for one influence. Values in base units (mm, rad, s, see Influence); use `shownParameter` for µm
/// and the like.
struct SourceEstimate {
    InfluenceId id = InfluenceId::centre;
    PlaneAxis axis = PlaneAxis::none;
    std::string axisName; ///< letter of the axis, or "X–Y"
    bool separable = false;
    std::vector<std::size_t> with;      ///< if not separable: indices of the sources it is mixed with
    std::optional<double> value;        ///< null if inseparable, or if the feed is not stated
    std::optional<double> u;            ///< standard uncertainty from the fit only
    double degreesOfFreedom = 0;        ///< of u
    std::optional<double> contribution; ///< to G(b), on its own, mm; null if inseparable
    std::optional<double> pitch;        ///< for a cyclic error, mm
    std::optional<double> phase;        ///< for a cyclic error at the centre of the circle, rad
    std::optional<double> width;        ///< for a reversal spike, degrees
    std::optional<double> step;         ///< for a drift: radius counterclockwise − clockwise, mm
    bool proposed = false;              ///< found by the search, not stated
    std::optional<double> significance; ///< if so: probability that noise alone looks as much like it
    double shape = 0;                   ///< of the columns
    std::array<double, 2> fitted{};     ///< factors of both columns, which give the trace
    bool indication = false;            ///< u is not valid, so there is no interval
    std::vector<Message> reasons;       ///< what speaks against this source

    /// Returns the 95 % interval (Student), base units; null without value and for an indication.
    [[nodiscard]] std::optional<Interval> interval() const;
    /// True if the interval of 99.9 % excludes zero: one circle in a hundred shows one of ten by chance.
    [[nodiscard]] bool isSeen() const;
};

/// Returns u of a source in the unit shown; 0 without u. A lag is shown as the root of the fitted parameter:
/// near 0 its u is the root of u.
[[nodiscard]] double shownUncertainty(const SourceEstimate &source);

/// Returns half the 95 % interval in the unit shown; null without interval.
[[nodiscard]] std::optional<double> shownExpanded(const SourceEstimate &source);

/// Known combination of inseparable sources: Σ factor·value.
struct SourceSum {
    struct Part {
        std::size_t source = 0;
        double factor = 1; ///< for values in the unit
        /// As the fit has the parameter: of a common lag the square, ms²; of a servo mismatch whose feed is
        /// not stated the product of both, the difference of the following errors, µm.
        const char *unit = nullptr;
    };
    std::vector<Part> of;
    double value = 0; ///< in the unit of the first part
    double u = 0;
    std::optional<Interval> interval; ///< 95 %; null if u is not valid
    double contribution = 0;          ///< to G(b), of all together, mm
};

/// How the angles of the file lie to the axes of the machine, as the steps at the reversals show it.
struct Rotation {
    std::optional<double> angle; ///< degrees, by which the angles are too large; null: there are no steps
    double u = 0;                ///< degrees
    double bound = 0;            ///< the angle cannot be off by more (99.7 %), degrees
    bool commanded = false; ///< angles of the program: their start is wrong; else the instrument is turned

    /// True if the angle counts: more than 0.05° and certain. Spikes and periodic deviations are not looked
    /// for then, and all else is fitted to corrected angles.
    [[nodiscard]] bool isStated() const;
    [[nodiscard]] double removed() const { return isStated() ? *angle : 0; }
};

/// Interpretation of one circle, or several in one plane at different feeds: findings about the machine, not
/// a result of ISO 230-4 (its Annex B, and beyond).
struct Diagnosis {
    std::string first; ///< axes of the plane
    std::string second;
    int rank = 0;                      ///< parameters that the circle determines
    int of = 0;                        ///< parameters fitted
    int toldApart = 0;                 ///< of them, not only in sums with others
    double condition = 0;              ///< of the scaled columns
    double residual = 0;               ///< standard deviation not explained by any source, mm
    double readingsPerIndependent = 1; ///< neighbouring readings worth one independent reading
    std::size_t points = 0;            ///< used by the fit
    bool modelFits = true;             ///< the residual is noise as modelled; otherwise no interval is valid
    std::vector<Message> reasons;      ///< why not: what was seen in the residual, parts of a sentence
    Rotation rotation;
    double lagAngle = 0;                 ///< with commanded angles: lag of the pattern behind them, degrees
    double pause = 0;                    ///< between the arcs, turns, as stated
    std::vector<SourceEstimate> sources; ///< by contribution, centre and radius last
    std::vector<SourceSum> sums;
    std::vector<Message> remarks;

    [[nodiscard]] bool valid() const { return rank > 0; }
    [[nodiscard]] const SourceEstimate *find(InfluenceId id, PlaneAxis axis = PlaneAxis::none) const;
};

/// Fits the influences to a circle: one linear least-squares fit over both senses, of the rebuilt points
/// about the least squares centre. Readings within 0.1° (or the angle of the largest deviation) of a
/// reversal are omitted, as it is unknown to which side a step there belongs. A source is separable if it
/// has no part in the null space and at most ten times the uncertainty of its column alone. Inseparable
/// sources have no value, only their sum has. Uncertainties allow for the correlation of neighbouring
/// readings (numerics/correlatednoise.h), for the resolution of the readings and for how well the reversals
/// show that angles and axes agree. The residual is tested (residualtest.h), and each source compared with
/// what parts of the circle say (agreement.h). Beyond 7 200 readings per arc, means of neighbours are
/// fitted, for columns and deviations alike. Not valid (rank 0) with fewer than 30 used points.
[[nodiscard]] Diagnosis diagnose(const DiagnosedCircle &circle, const DiagnosisOptions &options = {});

/// The same for several circles in one plane and radius at different feeds: separates the lag, which grows
/// with the square of the feed, from radius and scales. Each circle has its own centre, which is not listed.
[[nodiscard]] Diagnosis diagnose(std::span<const DiagnosedCircle> circles,
                                 const DiagnosisOptions &options = {});

/// True if the circles can be diagnosed together: same plane and radius, known feeds, at least two different.
[[nodiscard]] bool areSeveralFeeds(std::span<const DiagnosedCircle> circles);

} // namespace palmer
