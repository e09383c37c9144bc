// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/simulation/positioningtrials.h"

#include "kernel/evaluation/testevaluation.h"

#include <algorithm>
#include <limits>

namespace palmer {

namespace {

constexpr double coverage = 2; ///< k of the contributions

constexpr std::array thermalIds{"temperatureMachine", "expansionMachine", "temperatureInstrument",
                                "expansionInstrument"};

double expanded(const PositioningBudget &budget, std::string_view id) {
    const Contribution *contribution = budget.find(id);
    return contribution ? contribution->expanded.value_or(0) : 0;
}

/// Returns the full width of a quantity whose U was taken as 0.6 times its width.
double width(double expanded) {
    return expanded / rectangularFactor;
}

/// Counters of the random numbers of a trial: two for errors drawn once, then the readings.
enum Place : std::uint32_t { thermalPlace = 0, otherPlace = 1, firstReadingPlace = 2 };

} // namespace

PositioningTrials::PositioningTrials(const PositioningMeasurement &measurement,
                                     const TestEvaluation &evaluation, const PositioningBudget &budget,
                                     long long seed)
    : m_measurement(measurement)
    , m_draws(seed)
    , m_targets(measurement.targets.size())
    , m_c(evaluation.edition->c)
    , m_length(budget.length.value_or(0))
    , m_normalDevice(measurement.uncertainty.device.kind == DeviceKind::certificate)
    , m_misalignment(width(expanded(budget, misalignmentId)))
    , m_drift(width(expanded(budget, environmentalVariationId)))
    , m_linearDrift(measurement.uncertainty.driftModel == DriftModel::linear) {
    const auto &results = std::get<PositioningResults>(evaluation.results);
    m_method = results.standardDeviation;
    const double device = expanded(budget, deviceId);
    m_device = m_normalDevice ? device / coverage : width(device) / 2;
    for (std::size_t k = 0; k < thermalIds.size(); ++k)
        m_thermal[k] = width(expanded(budget, thermalIds[k])) / 2;
    addReadings(measurement);
    if (!results.corrections.empty()) {
        m_corrections.resize(m_readings.size());
        for (const Reading &reading : m_readings)
            m_corrections[reading.place] = results.corrections[reading.target];
    }
    for (const Parameter &parameter : evaluation.parameters) {
        const auto row = std::ranges::find_if(evaluation.edition->rows, [&](const Row &r) {
            return std::string_view(r.term.id) == parameter.term.id;
        });
        if (!parameter.value || row == evaluation.edition->rows.end())
            continue;
        m_parameters.push_back({parameterId(parameter), *parameter.value, 0, 0, 0, 0, {}});
        m_formulas.push_back(row->value->four);
    }
}

void PositioningTrials::addReadings(const PositioningMeasurement &measurement) {
    std::array<std::size_t, 2> runs{};
    for (std::size_t run = 0; run < measurement.runs.size(); ++run) {
        const Run &pass = measurement.runs[run];
        const bool up = pass.approach == Direction::positive;
        const std::size_t row = runs[up ? 0 : 1]++;
        for (std::size_t k = 0; k < m_targets; ++k) {
            const std::size_t target = up ? k : m_targets - 1 - k; // ↓ starts at the last target
            const auto value =
                target < pass.deviations.size() ? pass.deviations[target] : std::optional<double>();
            m_readings.push_back({run, target, row * m_targets + target,
                                  value.value_or(std::numeric_limits<double>::quiet_NaN()),
                                  measurement.targets[target] - measurement.targets.front(), 0});
        }
    }
    m_positive = runs[0] * m_targets;
    for (Reading &reading : m_readings) {
        if (measurement.runs[reading.run].approach == Direction::negative)
            reading.place += m_positive;
    }
    if (measurement.cycle == Cycle::step) {
        // All runs at one target precede the next target.
        std::ranges::stable_sort(m_readings, {}, &Reading::target);
    }
    const double last = static_cast<double>(std::max<std::size_t>(m_readings.size(), 2) - 1);
    for (std::size_t k = 0; k < m_readings.size(); ++k)
        m_readings[k].time = static_cast<double>(k) / last - 0.5;
}

PositioningTrials::Buffers PositioningTrials::buffers() const {
    Buffers result;
    result.readings.resize(m_readings.size());
    result.targets.resize(m_targets);
    constexpr std::size_t block = RandomDraws::blockSize;
    result.numbers.resize((m_readings.size() * Lanes::count + block - 1) / block * block);
    return result;
}

PositioningTrials::Common PositioningTrials::common(long long first) const {
    const auto thermal = m_draws.lanes(first, thermalPlace);
    const auto other = m_draws.lanes(first, otherPlace);
    Lanes error = 0.0;
    for (std::size_t k = 0; k < m_thermal.size(); ++k)
        error += m_thermal[k] * RandomDraws::symmetric(thermal[k]);
    error += -m_misalignment * ((RandomDraws::symmetric(other[0]) + 1) / 2);
    if (m_device > 0 && m_normalDevice) {
        error += m_device * RandomDraws::normal(other[2]);
    } else if (m_device > 0) {
        error += m_device * RandomDraws::symmetric(other[2]);
    }
    return {m_length > 0 ? error / m_length : Lanes(0.0), m_drift * RandomDraws::symmetric(other[1])};
}

template <class Put>
void PositioningTrials::eachError(long long first, std::vector<double> &numbers, Put put) const {
    const Common all = common(first);
    if (m_linearDrift || m_drift == 0) {
        for (const Reading &reading : m_readings)
            put(reading, reading.distance * all.perLength + reading.time * all.drift);
        return;
    }
    m_draws.symmetric(first, firstReadingPlace, numbers);
    const double half = m_drift / 2;
    const double *number = numbers.data();
    for (const Reading &reading : m_readings) {
        put(reading, reading.distance * all.perLength + half * Lanes::from(number));
        number += Lanes::count;
    }
}

void PositioningTrials::run(long long first, Buffers &buffers, std::span<double> values,
                            const std::stop_token &) const {
    const auto trials = static_cast<std::size_t>(chunk());
    const std::span<const Lanes> readings(buffers.readings);
    for (std::size_t trial = 0; trial < trials; trial += Lanes::count) {
        eachError(first + static_cast<long long>(trial), buffers.numbers,
                  [&](const Reading &reading, const Lanes &error) {
                      buffers.readings[reading.place] = reading.value + error;
                  });
        for (std::size_t k = 0; k < m_corrections.size(); ++k)
            buffers.readings[k] += m_corrections[k];
        statistics(readings.first(m_positive), readings.subspan(m_positive), m_targets, m_method,
                   buffers.targets);
        for (std::size_t p = 0; p < m_formulas.size(); ++p) {
            const auto lanes = m_formulas[p](buffers.targets, m_c).values();
            std::ranges::copy(lanes, values.begin() + static_cast<std::ptrdiff_t>(p * trials + trial));
        }
    }
}

PositioningMeasurement PositioningTrials::perturbed(long long trial) const {
    PositioningMeasurement result = m_measurement;
    const long long first = trial - trial % Lanes::count;
    std::vector<double> numbers = buffers().numbers;
    eachError(first, numbers, [&](const Reading &reading, const Lanes &error) {
        if (auto &deviations = result.runs[reading.run].deviations; reading.target < deviations.size()) {
            auto &deviation = deviations[reading.target];
            if (deviation)
                *deviation = reading.value + error[static_cast<int>(trial - first)];
        }
    });
    return result;
}

} // namespace palmer
