// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/comparison/comparisontrials.h"

#include "kernel/numerics/runinbackground.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>

namespace palmer {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// Counters of the random numbers of a trial: errors that both share, those of either test, then its cycles,
/// four to a counter.
constexpr std::uint32_t sharedPlace = 0;
constexpr std::array<std::uint32_t, 2> ownPlace{2, 4};
constexpr std::array<std::uint32_t, 2> cyclePlace{0x100, 0x10000};

double widthOf(const PositioningBudget &budget, std::string_view id) {
    const Contribution *contribution = budget.find(id);
    return contribution ? contribution->expanded.value_or(0) / rectangularFactor : 0;
}

} // namespace

ComparisonTrials::ComparisonTrials(const TrialsOfTest &before, const TrialsOfTest &after,
                                   const Edition &edition, DeviationMethod method,
                                   std::vector<decltype(ParameterFormula::four)> formulas,
                                   std::span<const SharedError> shared, int cycles, bool pooled)
    : m_edition(edition)
    , m_method(method)
    , m_formulas(std::move(formulas))
    , m_shared(shared.begin(), shared.end())
    , m_cycles(cycles)
    , m_pooled(pooled)
    , m_targets(before.readings.targets)
    , m_directions{!before.readings.positive.empty(), !before.readings.negative.empty()} {
    m_sides = {sideOf(before), sideOf(after)};
    for (std::size_t side = 0; side < m_sides.size(); ++side)
        m_sides[side].drawn = drawnOf(side);
}

ComparisonTrials::Side ComparisonTrials::sideOf(const TrialsOfTest &test) const {
    Side side;
    side.of = &test;
    addTable(side, test.readings.positive);
    addTable(side, test.readings.negative);
    const PositioningMeasurement &measurement = *test.measurement;
    const PositioningBudget &budget = test.budget;
    side.length = budget.length.value_or(0);
    side.normalDevice = measurement.uncertainty.device.kind == DeviceKind::certificate;
    const Contribution *device = budget.find(deviceId);
    side.device =
        side.normalDevice ? (device ? device->expanded.value_or(0) / 2 : 0) : widthOf(budget, deviceId) / 2;
    // The signs matter for what both share: α errs the other way on the other side of 20 °C.
    side.thermal = {widthOf(budget, "temperatureMachine") / 2,
                    test.awayFrom20[0] * widthOf(budget, "expansionMachine") / 2,
                    -widthOf(budget, "temperatureInstrument") / 2,
                    -test.awayFrom20[1] * widthOf(budget, "expansionInstrument") / 2};
    side.misalignment = widthOf(budget, misalignmentId);
    if (measurement.uncertainty.driftModel == DriftModel::linear)
        side.drift = widthOf(budget, environmentalVariationId);
    for (const double target : measurement.targets)
        side.distance.push_back(target - measurement.targets.front());
    side.time = timesOf(test.readings.positive.size(), side.means.size());
    return side;
}

/// Appends the means and residuals of one direction.
void ComparisonTrials::addTable(Side &side, const std::vector<double> &table) const {
    const auto n = static_cast<std::size_t>(m_cycles);
    const double scale =
        m_cycles > 1 ? smallSampleFactor(m_cycles) * std::sqrt(m_cycles / (m_cycles - 1.0)) : 0;
    const std::size_t begin = side.means.size();
    side.means.resize(begin + table.size(), nothing);
    side.residuals.resize(begin + table.size(), nothing);
    for (std::size_t target = 0; target < m_targets && !table.empty(); ++target) {
        double sum = 0;
        int count = 0;
        for (std::size_t j = 0; j < n; ++j) {
            const double value = table[j * m_targets + target];
            sum += std::isnan(value) ? 0 : value;
            count += std::isnan(value) ? 0 : 1;
        }
        for (std::size_t j = 0; j < n; ++j) {
            const double value = table[j * m_targets + target];
            if (std::isnan(value))
                continue; // stays a gap
            side.means[begin + j * m_targets + target] = sum / count;
            side.residuals[begin + j * m_targets + target] = scale * (value - sum / count);
        }
    }
}

/// Returns when each of `count` readings was taken, −0.5 … 0.5 from the first to the last; those from
/// `positive` on are of the negative direction.
std::vector<double> ComparisonTrials::timesOf(std::size_t positive, std::size_t count) const {
    const std::size_t perCycle = m_directions[0] && m_directions[1] ? 2 : 1;
    const std::size_t passes = static_cast<std::size_t>(m_cycles) * perCycle;
    const auto last = static_cast<double>(std::max<std::size_t>(passes * m_targets, 2) - 1);
    std::vector<double> times(count);
    for (std::size_t place = 0; place < count; ++place) {
        const bool down = place >= positive;
        const std::size_t inTable = down ? place - positive : place;
        const std::size_t target = inTable % m_targets;
        const std::size_t pass = perCycle * (inTable / m_targets) + (perCycle == 2 && down ? 1 : 0);
        const std::size_t step = down ? m_targets - 1 - target : target;
        times[place] = static_cast<double>(pass * m_targets + step) / last - 0.5;
    }
    return times;
}

bool ComparisonTrials::isShared(SharedError error) const {
    return std::ranges::find(m_shared, error) != m_shared.end();
}

/// Error per unit of length, and change by drift from the first to the last reading.
std::array<Lanes, 2> ComparisonTrials::errorsOf(long long first, int which) const {
    const auto side = static_cast<std::size_t>(which);
    const Side &test = m_sides.at(side);
    const auto sharedThermal = m_draws.lanes(first, sharedPlace);
    const auto sharedOther = m_draws.lanes(first, sharedPlace + 1);
    const auto ownThermal = m_draws.lanes(first, ownPlace.at(side));
    const auto ownOther = m_draws.lanes(first, ownPlace.at(side) + 1);
    constexpr std::array thermal{SharedError::machineTemperature, SharedError::machineExpansion,
                                 SharedError::instrumentTemperature, SharedError::instrumentExpansion};
    Lanes error = 0.0;
    for (std::size_t k = 0; k < thermal.size(); ++k)
        error +=
            test.thermal[k] * RandomDraws::symmetric(isShared(thermal[k]) ? sharedThermal[k] : ownThermal[k]);
    const auto &angle = isShared(SharedError::misalignment) ? sharedOther[0] : ownOther[0];
    error += -test.misalignment * ((RandomDraws::symmetric(angle) + 1) / 2);
    const auto &device = isShared(SharedError::device) ? sharedOther[2] : ownOther[2];
    error += test.device * (test.normalDevice ? RandomDraws::normal(device) : RandomDraws::symmetric(device));
    return {test.length > 0 ? error / test.length : Lanes(0.0),
            test.drift * RandomDraws::symmetric(ownOther[1])};
}

std::size_t ComparisonTrials::pool() const {
    return static_cast<std::size_t>(m_cycles) * (m_pooled ? 2 : 1);
}

/// `place`: of the target in the first cycle; `drawn`: the cycle, from m_cycles on of the other test. A gap
/// takes the next cycle.
double ComparisonTrials::residual(std::size_t side, std::size_t place, std::size_t drawn) const {
    const auto n = static_cast<std::size_t>(m_cycles);
    for (std::size_t k = 0; k < pool(); ++k) {
        const std::size_t cycle = (drawn + k) % pool();
        const Side &from = cycle < n ? m_sides[side] : m_sides[1 - side];
        const double value = from.residuals[place + (cycle % n) * m_targets];
        if (!std::isnan(value))
            return value;
    }
    return 0;
}

/// Looked up once for all trials.
std::vector<double> ComparisonTrials::drawnOf(std::size_t side) const {
    const std::size_t readings = static_cast<std::size_t>(m_cycles) * m_targets;
    std::vector<double> values;
    for (std::size_t begin = 0; begin < m_sides[side].residuals.size(); begin += readings) {
        for (std::size_t drawn = 0; drawn < pool(); ++drawn) {
            for (std::size_t target = 0; target < m_targets; ++target)
                values.push_back(residual(side, begin + target, drawn));
        }
    }
    return values;
}

/// Adds the residuals of the drawn cycles to the readings of a cycle.
void ComparisonTrials::addResiduals(std::size_t side, std::size_t cycle, const Drawn &drawn,
                                    std::vector<Lanes> &readings) const {
    const auto n = static_cast<std::size_t>(m_cycles);
    for (std::size_t direction = 0; direction < 2; ++direction) {
        if (!m_directions[direction])
            continue;
        const bool isSecond = direction == 1 && m_directions[0];
        const std::size_t begin = isSecond ? n * m_targets : 0;
        const double *const residuals = m_sides[side].drawn.data() + (isSecond ? pool() * m_targets : 0);
        for (std::size_t target = 0; target < m_targets; ++target) {
            std::array<double, Lanes::count> values{};
            for (std::size_t lane = 0; lane < values.size(); ++lane)
                values[lane] = residuals[drawn[lane] * m_targets + target];
            readings[begin + cycle * m_targets + target] += Lanes::from(values);
        }
    }
}

void ComparisonTrials::perturb(long long first, int which, DrawnParts parts,
                               std::vector<Lanes> &readings) const {
    const auto side = static_cast<std::size_t>(which);
    const Side &test = m_sides.at(side);
    const auto n = static_cast<std::size_t>(m_cycles);
    const std::array<Lanes, 2> errors =
        parts.errors ? errorsOf(first, which) : std::array<Lanes, 2>{Lanes(0.0), Lanes(0.0)};
    readings.resize(test.means.size());
    for (std::size_t place = 0; place < readings.size(); ++place)
        readings[place] =
            test.means[place] + test.distance[place % m_targets] * errors[0] + test.time[place] * errors[1];
    if (!parts.residuals)
        return;
    RandomDraws::WordLanes words{};
    std::array<RandomDraws::WordLanes, 4> four{};
    for (std::size_t j = 0; j < n; ++j) {
        if (j % 4 == 0)
            four = m_draws.lanes(first, cyclePlace.at(side) + static_cast<std::uint32_t>(j / 4));
        words = four[j % 4];
        Drawn drawn{};
        for (int lane = 0; lane < Lanes::count; ++lane)
            drawn[static_cast<std::size_t>(lane)] =
                static_cast<std::size_t>((static_cast<std::uint64_t>(words[lane]) * pool()) >> 32U);
        addResiduals(side, j, drawn, readings);
    }
}

void ComparisonTrials::runFour(long long first, DrawnParts parts, Buffers &buffers,
                               std::span<double> differences) const {
    for (int which = 0; which < 2; ++which) {
        perturb(first, which, parts, buffers.readings);
        const std::span<const Lanes> all(buffers.readings);
        const std::size_t positive = m_sides.at(static_cast<std::size_t>(which)).of->readings.positive.size();
        auto &targets = buffers.targets.at(static_cast<std::size_t>(which));
        targets.resize(m_targets);
        statistics(all.first(positive), all.subspan(positive), m_targets, m_method, targets);
    }
    auto to = differences.begin();
    for (const auto &formula : m_formulas) {
        const Lanes difference =
            formula(buffers.targets[1], m_edition.c) - formula(buffers.targets[0], m_edition.c);
        to = std::ranges::copy(difference.values(), to).out;
    }
    Lanes sum = 0.0;
    int count = 0;
    const auto meanOf = [&](std::size_t which, std::size_t target, std::size_t direction) {
        const auto &of = buffers.targets.at(which)[target];
        return direction == 0 ? of.positive.mean : of.negative.mean;
    };
    for (std::size_t direction = 0; direction < 2; ++direction) {
        for (std::size_t i = 0; i < m_targets; ++i) {
            const Lanes difference = meanOf(1, i, direction) - meanOf(0, i, direction);
            if (!m_directions[direction] || isMissing(difference))
                continue;
            sum += difference;
            ++count;
        }
    }
    const Lanes zero = count > 0 ? sum / static_cast<double>(count) : Lanes(0.0);
    for (std::size_t curve = 0; curve < 3; ++curve) {
        for (std::size_t i = 0; i < m_targets; ++i) {
            const Lanes difference = curve < 2 ? meanOf(1, i, curve) - meanOf(0, i, curve)
                                               : buffers.targets[1][i].mean() - buffers.targets[0][i].mean();
            to = std::ranges::copy((difference - zero).values(), to).out;
        }
    }
}

std::vector<double> ComparisonTrials::run(long long trials, DrawnParts parts, std::size_t values,
                                          int threads) const {
    const auto n = static_cast<std::size_t>(trials);
    std::vector<double> all(values * n);
    const auto most = threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency());
    const auto workers = static_cast<std::size_t>(std::clamp(most, 1, 64));
    const std::size_t fours = n / Lanes::count;
    const auto work = [&](std::size_t worker) {
        Buffers buffers;
        std::vector<double> differences(this->values() * Lanes::count);
        for (std::size_t four = worker * fours / workers; four < (worker + 1) * fours / workers; ++four) {
            runFour(static_cast<long long>(four) * Lanes::count, parts, buffers, differences);
            for (std::size_t v = 0; v < values; ++v)
                std::copy_n(differences.begin() + static_cast<std::ptrdiff_t>(v) * Lanes::count, Lanes::count,
                            all.begin() + static_cast<std::ptrdiff_t>(v * n + four * Lanes::count));
        }
    };
    std::vector<std::future<void>> others;
    for (std::size_t worker = 1; worker < workers; ++worker)
        others.push_back(runInBackground(true, [&work, worker] { work(worker); }));
    work(0);
    for (std::future<void> &other : others)
        other.get();
    return all;
}

} // namespace palmer
