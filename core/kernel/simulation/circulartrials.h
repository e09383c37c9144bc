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

/// The trials of a circular test: measurement errors added to the radial deviations, then points, circles and
/// results as in the evaluation.
///
/// Trials differ little from the evaluation without errors, and most of their cost is saved by starting from
/// it. The points stay on their rays (`Rays` finds those that can touch a circle without visiting all);
/// minimum zones start from its contacts and equal the ordinary ones to the last bit; least squares circles
/// take two steps (`NearbyCircle`); for a hysteresis only points that can attain it are computed
/// (`NearbyHysteresis`). A trial too far off, or too close to a tie, is computed in the ordinary way, which
/// only costs time.
class CircularTrials {
public:
    /// `evaluation`: of the test; its parameters with a value and a budget U are simulated.
    CircularTrials(const Test &test, const CircularMeasurement &measurement, const Surroundings &surroundings,
                   const TestEvaluation &evaluation, long long seed);

    /// Returns id and evaluated value of each parameter.
    [[nodiscard]] const std::vector<SimulatedParameter> &parameters() const { return m_parameters; }
    /// Returns the number of trials processed in one run().
    [[nodiscard]] int chunk() const { return m_chunk; }

    /// Working memory of one thread.
    struct Buffers {
        std::shared_ptr<CircularMeasurement> measurement; ///< perturbed
        std::shared_ptr<CircularResults> results;
        std::vector<double> errors;                 ///< of the points of a path, mm
        std::vector<std::vector<double>> distances; ///< per path, from the programmed centre, as read
        std::vector<Rays::Look> looks;              ///< per path, its points
        long long plain = 0;                        ///< circles and hystereses computed in the ordinary way
    };
    [[nodiscard]] Buffers buffers() const;

    /// Computes the parameters of the trials first … first + chunk() − 1: all values of the first parameter,
    /// then of the second, and so on. Leaves the rest unchanged if stopped.
    void run(long long first, Buffers &buffers, std::span<double> values, const std::stop_token &stop) const;

    /// Returns the measurement of one trial: evaluating it gives the results of that trial, except for errors
    /// that are not in the readings (correction, repeatability).
    [[nodiscard]] CircularMeasurement perturbed(long long trial) const;

private:
    /// The evaluated part of an arc.
    struct Part {
        std::size_t arc = 0;
        std::vector<double> angles;
        std::vector<Point> directions;
        std::vector<double> deviations; ///< as measured, mm
        std::uint32_t place = 0;        ///< of the random numbers of its first points
        bool commanded = false;
        Rays rays; ///< of the points evaluated without errors
    };
    /// A circle needed by the parameters.
    struct Circle {
        CircleOf of = CircleOf::both;
        ReferenceCircle kind = ReferenceCircle::leastSquares;
        bool radiusAlone = false;                           ///< no point distance is needed
        std::vector<std::size_t> parts;                     ///< whose points it is fitted to
        std::optional<std::array<std::size_t, 4>> contacts; ///< minimum zone: contacts without errors
        std::optional<NearbyCircle> nearby;                 ///< least squares: near that without errors
    };
    /// Errors drawn once per trial.
    struct Common {
        std::array<double, 2> drift{}; ///< per path, mm
        double zero = 0;               ///< displacement and reference length, mm
        double scale = 0;              ///< displacement: error per unit of deviation
        Point centring;                ///< mm
        double correction = 0;         ///< mm
    };

    [[nodiscard]] Common common(long long trial) const;
    void perturb(long long trial, std::size_t index, const Common &all, Buffers &buffers) const;
    void setReadings(std::size_t index, Buffers &buffers) const;
    void wantCircles(const Term &term);
    void addParts();
    /// `place`: of the random numbers of its first points.
    [[nodiscard]] Part partOf(const EvaluatedPath &path, std::uint32_t place) const;
    void addRepeated();
    void addReferences();
    /// Returns the arcs with commanded angles in chronological order, as `paths` does.
    [[nodiscard]] std::vector<CommandedArc>
    inOrderOfTime(std::span<const std::vector<double>> distances) const;
    [[nodiscard]] std::optional<Point> centringErrorOf(const Buffers &buffers) const;
    void setPoints(Buffers &buffers) const;
    [[nodiscard]] std::optional<double> hysteresisOf(const Buffers &buffers) const;
    void fillPoints(const std::vector<std::size_t> &parts, Buffers &buffers) const;
    [[nodiscard]] bool evaluate(Buffers &buffers, const std::stop_token &stop) const;
    [[nodiscard]] std::optional<CircleResult> minimumZoneOf(const Circle &circle,
                                                            const Buffers &buffers) const;
    [[nodiscard]] std::optional<CircleResult> leastSquaresOf(const Circle &circle,
                                                             const Buffers &buffers) const;

    const Test &m_test;
    const CircularMeasurement &m_measurement;
    const Surroundings &m_surroundings;
    const Edition &m_edition;
    const CircularResults &m_results;
    RandomDraws m_draws;
    std::vector<SimulatedParameter> m_parameters;
    std::vector<std::size_t> m_listed;   ///< indices in the listed parameters
    std::vector<double> m_repeatability; ///< per parameter, standard deviation, mm
    std::vector<Part> m_parts;           ///< like the paths of the results
    std::vector<Part> m_repeated;        ///< with commanded angles: also used for the centring error
    std::optional<NearbyCentring> m_nearbyCentring;
    std::vector<Circle> m_circles;           ///< needed by the parameters
    std::optional<std::size_t> m_hysteresis; ///< the parameter that needs all points
    std::optional<NearbyHysteresis> m_nearbyHysteresis;
    bool m_readings = false; ///< a parameter needs the readings
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
