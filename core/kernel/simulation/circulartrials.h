#pragma once

#include "kernel/evaluation/iso230_4/results.h"
#include "kernel/simulation/randomdraws.h"
#include "kernel/uncertainty/simulation.h"

#include <memory>
#include <span>
#include <stop_token>
#include <vector>

namespace palmer {

/// The trials of a circular test: errors of measurement added to the radial deviations, then points, circles
/// and results as they are evaluated themselves.
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
        std::vector<double> errors; ///< of the points of a path, mm
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
        std::size_t arc;
        std::vector<double> angles;
        std::vector<Point> directions;
        std::vector<double> deviations; ///< as measured, mm
        std::uint32_t place;            ///< of the random numbers of its first points
    };
    /// What is drawn once a trial.
    struct Common {
        std::array<double, 2> drift; ///< of each path, mm
        double zero;                 ///< displacement and reference length, mm
        double scale;                ///< displacement: error per deviation
        Point centring;              ///< mm
        double correction;           ///< mm
    };

    [[nodiscard]] Common common(long long trial) const;
    void perturb(long long trial, std::size_t part, const Common &all, Workplace &place) const;
    [[nodiscard]] bool evaluate(Workplace &place, const std::stop_token &stop) const;
    [[nodiscard]] bool wanted(CircleOf of, ReferenceCircle kind) const;

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
    std::vector<std::pair<CircleOf, ReferenceCircle>> m_circles; ///< that the parameters look at
    int m_chunk = 1;
    double m_zero = 0; ///< standard deviations, mm
    double m_scale = 0;
    double m_length = 0;
    double m_correction = 0;
    double m_centring = 0;
    double m_noise = 0;
    double m_resolution = 0; ///< step, mm
    double m_drift = 0;      ///< E_VE, mm
    double m_middle = 0;     ///< of the deviations, mm
};

} // namespace palmer
