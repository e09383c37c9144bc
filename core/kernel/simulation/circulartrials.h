// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/iso230_4/results.h"
#include "kernel/numerics/nearbycentring.h"
#include "kernel/numerics/nearbycircle.h"
#include "kernel/simulation/nearbyhysteresis.h"
#include "kernel/simulation/pointerrors.h"
#include "kernel/uncertainty/simulation.h"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace palmer {

/// The trials of a circular test: errors of measurement added to the radial deviations, then points, circles
/// and results as they are evaluated themselves.
///
/// Nearly all that a trial costs is saved by knowing the evaluation without errors: each trial is a little
/// apart from it. The points stay on their rays (`Rays`: which of them can touch a circle is known without
/// looking at all); minimum zones begin with its contacts, and are to the last bit those of the plain way;
/// least squares circles are two steps away (`NearbyCircle`); of a hysteresis only the points that can have
/// it are computed (`NearbyHysteresis`). Where a trial is too far off, or too close to a tie, the plain way
/// is taken: what it costs is time.
class CircularTrials {
public:
    /// `evaluation`: of the test; its parameters with a value and a U by the budget are simulated.
    CircularTrials(const Test &test, const CircularMeasurement &measurement, const Surroundings &surroundings,
                   const TestEvaluation &evaluation, long long seed);

    /// Id and evaluated value of each parameter.
    [[nodiscard]] const std::vector<SimulatedParameter> &parameters() const { return m_parameters; }
    /// Trials that are worked off in one go.
    [[nodiscard]] int chunk() const { return m_chunk; }

    /// What one thread works with.
    struct Workplace {
        std::shared_ptr<CircularMeasurement> measurement; ///< perturbed
        std::shared_ptr<CircularResults> results;
        std::vector<double> errors;                 ///< of the points of a path, mm
        std::vector<std::vector<double>> distances; ///< from the programmed centre, as read: of each path
        std::vector<Rays::Look> looks;              ///< the points of each path
        long long plain = 0;                        ///< circles and hystereses that took the plain way
    };
    [[nodiscard]] Workplace workplace() const;

    /// The parameters of the trials first … first + chunk() − 1: all of the first parameter, then all of the
    /// second, and so on. Stopped it leaves them as they are.
    void run(long long first, Workplace &place, std::span<double> values, const std::stop_token &stop) const;

    /// The measurement as trial number `trial` sees it: evaluating it gives the figures of that trial but for
    /// what is not in the readings (correction, repeatability).
    [[nodiscard]] CircularMeasurement perturbed(long long trial) const;

private:
    /// What is evaluated of an arc.
    struct Part {
        std::size_t arc = 0;
        std::vector<double> angles;
        std::vector<Point> directions;
        std::vector<double> deviations; ///< as measured, mm
        std::uint32_t place = 0;        ///< of the random numbers of its first points
        bool commanded = false;
        Rays rays; ///< of the points as evaluated without errors
    };
    /// A circle that the parameters look at.
    struct Circle {
        CircleOf of = CircleOf::both;
        ReferenceCircle kind = ReferenceCircle::leastSquares;
        bool radiusAlone = false;                           ///< no distance of a point is asked for
        std::vector<std::size_t> parts;                     ///< about whose points it is
        std::optional<std::array<std::size_t, 4>> contacts; ///< minimum zone: without errors
        std::optional<NearbyCircle> nearby;                 ///< least squares: about that without errors
    };
    /// What is drawn once a trial.
    struct Common {
        std::array<double, 2> drift{}; ///< of each path, mm
        double zero = 0;               ///< displacement and reference length, mm
        double scale = 0;              ///< displacement: error per deviation
        Point centring;                ///< mm
        double correction = 0;         ///< mm
    };

    [[nodiscard]] Common common(long long trial) const;
    void perturb(long long trial, std::size_t index, const Common &all, Workplace &place) const;
    void setReadings(std::size_t index, Workplace &place) const;
    void wantCircles(const Term &term);
    void addParts();
    /// `place`: of the random numbers of its first points.
    [[nodiscard]] Part partOf(const EvaluatedPath &path, std::uint32_t place) const;
    void addRepeated();
    void addReferences();
    /// The arcs of commanded angles in the order of time, as `paths` takes them.
    [[nodiscard]] std::vector<CommandedArc>
    inOrderOfTime(std::span<const std::vector<double>> distances) const;
    [[nodiscard]] std::optional<Point> centringErrorOf(const Workplace &place) const;
    void setPoints(Workplace &place) const;
    [[nodiscard]] std::optional<double> hysteresisOf(const Workplace &place) const;
    void fillPoints(const std::vector<std::size_t> &parts, Workplace &place) const;
    [[nodiscard]] bool evaluate(Workplace &place, const std::stop_token &stop) const;
    [[nodiscard]] std::optional<CircleResult> minimumZoneOf(const Circle &circle,
                                                            const Workplace &place) const;
    [[nodiscard]] std::optional<CircleResult> leastSquaresOf(const Circle &circle,
                                                             const Workplace &place) const;

    const Test &m_test;
    const CircularMeasurement &m_measurement;
    const Surroundings &m_surroundings;
    const Edition &m_edition;
    const CircularResults &m_results;
    RandomDraws m_draws;
    std::vector<SimulatedParameter> m_parameters;
    std::vector<std::size_t> m_listed;   ///< their places among the listed parameters
    std::vector<double> m_repeatability; ///< of each, standard deviation, mm
    std::vector<Part> m_parts;           ///< as the paths of the results
    std::vector<Part> m_repeated;        ///< of commanded angles: they too tell the centring error
    std::optional<NearbyCentring> m_nearbyCentring;
    std::vector<Circle> m_circles;           ///< that the parameters look at
    std::optional<std::size_t> m_hysteresis; ///< the parameter that looks at the points
    std::optional<NearbyHysteresis> m_nearbyHysteresis;
    bool m_readings = false; ///< a parameter looks at the readings
    int m_chunk = 1;
    double m_zero = 0; ///< standard deviations, mm
    double m_scale = 0;
    double m_length = 0;
    double m_correction = 0;
    double m_centring = 0;
    PointErrors m_errors;
    double m_drift = 0;  ///< E_VE, mm
    double m_middle = 0; ///< of the deviations, mm
};

} // namespace palmer
