// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/comparison/comparetests.h"

#include "kernel/comparison/comparisontrials.h"
#include "kernel/evaluation/evaluatetest.h"
#include "kernel/evaluation/resultsof.h"
#include "kernel/measurement/testfacts.h"
#include "kernel/numerics/studentt.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace palmer {

namespace {

constexpr double tail = 0.02275; ///< beyond + 2 of a normal distribution
constexpr double covered = 1 - 2 * tail;
constexpr long long fewestTrials = 10'000;
constexpr long long partTrials = 20'000; ///< for what is only shown, and for bands
constexpr double mostDraws = 1e8;        ///< some seconds
constexpr double mostKept = 4e6;         ///< values of curves

using Targets = std::vector<std::size_t>;

/// Pairs of indices of common targets.
std::pair<Targets, Targets> commonTargets(const PositioningMeasurement &a, const PositioningMeasurement &b) {
    std::pair<Targets, Targets> common;
    std::size_t j = 0;
    for (std::size_t i = 0; i < a.targets.size(); ++i) {
        while (j < b.targets.size() && b.targets[j] < a.targets[i] - sameTarget)
            ++j;
        if (j < b.targets.size() && std::abs(b.targets[j] - a.targets[i]) <= sameTarget) {
            common.first.push_back(i);
            common.second.push_back(j);
        }
    }
    return common;
}

int runsOf(const PositioningMeasurement &m, Direction direction) {
    return static_cast<int>(std::ranges::count(m.runs, direction, &Run::approach));
}

int cyclesOf(const PositioningMeasurement &m) {
    const int up = runsOf(m, Direction::positive);
    const int down = runsOf(m, Direction::negative);
    return up > 0 && down > 0 ? std::min(up, down) : std::max(up, down);
}

/// The test with the first cycles at some of its targets.
Test part(const Test &test, const Targets &targets, int cycles) {
    Test result = test;
    auto &m = std::get<PositioningMeasurement>(result.measurement);
    const PositioningMeasurement whole = m;
    m.targets.clear();
    m.runs.clear();
    m.excluded.clear();
    for (const std::size_t i : targets)
        m.targets.push_back(whole.targets[i]);
    std::array<int, 2> taken{};
    for (const Run &run : whole.runs) {
        if (taken.at(static_cast<std::size_t>(run.approach))++ >= cycles)
            continue;
        Run &kept = m.runs.emplace_back();
        kept.approach = run.approach;
        for (const std::size_t i : targets)
            kept.deviations.push_back(i < run.deviations.size() ? run.deviations[i] : std::nullopt);
    }
    return result;
}

/// The serial numbers and certificates of the instruments; empty unless all are stated.
std::set<std::pair<std::string, std::string>> devicesOf(const Surroundings &surroundings) {
    std::set<std::pair<std::string, std::string>> devices;
    for (const Instrument *instrument : surroundings.instruments) {
        if (instrument->serialNumber.empty() || instrument->certificate.empty())
            return {};
        devices.emplace(instrument->serialNumber, instrument->certificate);
    }
    return devices;
}

bool isSameInstrument(const Surroundings &a, const Surroundings &b) {
    const auto devices = devicesOf(a);
    return !devices.empty() && devices == devicesOf(b);
}

bool sharesAnInstrument(const Surroundings &a, const Surroundings &b) {
    return std::ranges::any_of(a.instruments, [&](const Instrument *one) {
        return std::ranges::any_of(b.instruments, [&](const Instrument *other) {
            return one == other || (!one->serialNumber.empty() && one->serialNumber == other->serialNumber &&
                                    one->manufacturer == other->manufacturer);
        });
    });
}

bool isSameMachine(const Surroundings &a, const Surroundings &b) {
    if (a.machine == b.machine)
        return true;
    return a.machine && b.machine && !a.machine->serialNumber.empty() &&
           a.machine->serialNumber == b.machine->serialNumber &&
           a.machine->manufacturer == b.machine->manufacturer;
}

/// Positions of the sensors of a kind; empty unless all are stated.
std::vector<std::string> sensorPlaces(const Conditions &conditions, SensorMeasures what) {
    std::vector<std::string> places;
    for (const Sensor &sensor : conditions.sensors) {
        if (sensor.measures != what)
            continue;
        if (sensor.position.empty())
            return {};
        places.push_back(sensor.position);
    }
    return places;
}

std::vector<SharedError> sharedErrors(const PairedTest &a, const PairedTest &b,
                                      const ComparisonOptions &options) {
    const auto conditions = [](const PairedTest &t) -> const Conditions & { return *conditionsOf(*t.test); };
    const Expansion &before = conditions(a).expansion;
    const Expansion &after = conditions(b).expansion;
    const bool laboratories = options.role == ComparisonRole::laboratories;
    std::vector<SharedError> shared;
    if ((laboratories || isSameMachine(a.surroundings, b.surroundings)) && before.machine &&
        before.machine == after.machine)
        shared.push_back(SharedError::machineExpansion);
    if (laboratories)
        return shared;
    const bool sameInstrument = isSameInstrument(a.surroundings, b.surroundings);
    if (sameInstrument)
        shared.push_back(SharedError::device);
    if (before.instrument && before.instrument == after.instrument)
        shared.push_back(SharedError::instrumentExpansion);
    for (const auto &[what, error] :
         {std::pair{SensorMeasures::machine, SharedError::machineTemperature},
          std::pair{SensorMeasures::instrument, SharedError::instrumentTemperature}}) {
        const auto places = sensorPlaces(conditions(a), what);
        if (sameInstrument && !places.empty() && places == sensorPlaces(conditions(b), what))
            shared.push_back(error);
    }
    if (options.setUpUntouched)
        shared.push_back(SharedError::misalignment);
    return shared;
}

/// +1 above 20 °C, −1 below: at start or end, whichever is farther, as in the budget.
double sideOf20(const Conditions &conditions, SensorMeasures what) {
    const auto away = [&](std::optional<double> (*at)(const Sensor &)) {
        return meanTemperature(conditions, what, at).value_or(referenceTemperature) - referenceTemperature;
    };
    const double start = away(startTemperature);
    const double end = away(endTemperature);
    return (std::abs(start) >= std::abs(end) ? start : end) < 0 ? -1 : 1;
}

TrialsOfTest trialsOf(const Test &test, const Surroundings &surroundings, const PositioningResults &results) {
    const auto &measurement = std::get<PositioningMeasurement>(test.measurement);
    const Conditions &conditions = measurement.conditions.common;
    return {
        readings(measurement, results.corrections),
        &measurement,
        positioningBudget(measurement, surroundings.environmentalVariation),
        {sideOf20(conditions, SensorMeasures::machine), sideOf20(conditions, SensorMeasures::instrument)}};
}

/// Mean and 95.45 % quantile of the distances from it.
struct Spread {
    double mean = 0;
    double expanded = 0;
};

Spread spreadOf(std::span<double> values) {
    Spread spread;
    if (values.empty())
        return spread;
    const double first = values.front(); // summed from here, values that are all equal have this mean exactly
    double sum = 0;
    for (const double value : values)
        sum += value - first;
    spread.mean = first + sum / static_cast<double>(values.size());
    for (double &value : values)
        value = std::abs(value - spread.mean);
    const auto place =
        static_cast<std::ptrdiff_t>(std::ceil(covered * static_cast<double>(values.size()))) - 1;
    std::ranges::nth_element(values, values.begin() + place);
    spread.expanded = values[static_cast<std::size_t>(place)];
    return spread;
}

std::vector<Spread> spreadsOf(std::vector<double> all, std::size_t values) {
    const std::size_t trials = values > 0 ? all.size() / values : 0;
    std::vector<Spread> spreads;
    for (std::size_t v = 0; v < values; ++v)
        spreads.push_back(spreadOf(std::span(all).subspan(v * trials, trials)));
    return spreads;
}

std::optional<double> known(double value) {
    return std::isnan(value) ? std::nullopt : std::optional(value);
}

std::vector<std::optional<double>> meansOf(std::span<const TargetStatistics> targets,
                                           std::optional<Direction> direction) {
    std::vector<std::optional<double>> means;
    for (const TargetStatistics &target : targets)
        means.push_back(known(!direction                          ? target.mean()
                              : *direction == Direction::positive ? target.positive.mean
                                                                  : target.negative.mean));
    return means;
}

/// Takes the mean of the differences ↑ and ↓ off all curves: the zero is arbitrary.
void removeMean(std::vector<ComparedCurve> &curves) {
    double sum = 0;
    int count = 0;
    for (const ComparedCurve &curve : curves) {
        for (const std::optional<double> &value : curve.values) {
            if (curve.direction && value) {
                sum += *value;
                ++count;
            }
        }
    }
    for (ComparedCurve &curve : curves) {
        for (std::optional<double> &value : curve.values) {
            if (value)
                *value -= sum / count;
        }
    }
}

class Comparer {
public:
    Comparer(const PairedTest &before, const PairedTest &after, const ComparisonOptions &options)
        : m_before(before)
        , m_after(after)
        , m_options(options) {}

    TestComparison compare() {
        const Test &a = *m_before.test;
        const Test &b = *m_after.test;
        if (kindOf(a) != kindOf(b))
            return refuse(NotComparable::otherKind);
        m_result.edition = editionFor(b, nullptr);
        if (!m_result.edition)
            return refuse(NotComparable::noEdition);
        m_result.quantity = deviationQuantity(b);
        if (motionOf(a) != motionOf(b) || axesOf(a) != axesOf(b))
            return refuse(NotComparable::otherAxis);
        if (m_options.role == ComparisonRole::laboratories &&
            sharesAnInstrument(m_before.surroundings, m_after.surroundings))
            return refuse(NotComparable::sharedInstrument);
        if (const auto *axis = std::get_if<PositioningMeasurement>(&b.measurement))
            compareAxes(std::get<PositioningMeasurement>(a.measurement), *axis);
        else
            compareCircles(std::get<CircularMeasurement>(a.measurement),
                           std::get<CircularMeasurement>(b.measurement));
        return std::move(m_result);
    }

private:
    TestComparison refuse(NotComparable why) {
        m_result.refusal = why;
        return std::move(m_result);
    }

    [[nodiscard]] TestEvaluation evaluation(const Test &test, const Surroundings &surroundings) const {
        return evaluateTest(test, surroundings, m_result.edition);
    }

    void compareAxes(const PositioningMeasurement &a, const PositioningMeasurement &b) {
        for (const Direction direction : {Direction::positive, Direction::negative}) {
            if ((runsOf(a, direction) > 0) != (runsOf(b, direction) > 0)) {
                m_result.refusal = NotComparable::otherDirections;
                return;
            }
        }
        const auto [ofA, ofB] = commonTargets(a, b);
        m_result.commonTargets = ofA.size();
        m_result.cyclesOf = {cyclesOf(a), cyclesOf(b)};
        m_result.cycles = std::min(m_result.cyclesOf[0], m_result.cyclesOf[1]);
        if (ofA.size() < fewestComparedTargets) {
            m_result.noWord = NoWord::fewTargets;
            interpolateCurves();
            return;
        }
        const Test before = part(*m_before.test, ofA, m_result.cycles);
        const Test after = part(*m_after.test, ofB, m_result.cycles);
        const TestEvaluation was = evaluation(before, m_before.surroundings);
        const TestEvaluation is = evaluation(after, m_after.surroundings);
        addParameters(was, is);
        m_result.targets = std::get<PositioningMeasurement>(after.measurement).targets;
        addCurves(std::get<PositioningResults>(was.results).targets,
                  std::get<PositioningResults>(is.results).targets);
        if (m_result.cycles < 2) {
            m_result.noWord = NoWord::oneRun;
            return;
        }
        simulate(before, after, was, is);
        addWords();
    }

    void addParameters(const TestEvaluation &was, const TestEvaluation &is) {
        for (const Parameter &after : is.parameters) {
            const auto before = std::ranges::find(was.parameters, parameterId(after), parameterId);
            if (before == was.parameters.end() || !before->value || !after.value)
                continue;
            ComparedParameter compared{after.term, after.index, *before->value, *after.value,
                                       *after.value - *before->value};
            if (before->expandedUncertainty && after.expandedUncertainty)
                compared.uncertainty = std::hypot(*before->expandedUncertainty, *after.expandedUncertainty);
            m_result.parameters.push_back(std::move(compared));
        }
    }

    void addCurves(std::span<const TargetStatistics> was, std::span<const TargetStatistics> is) {
        for (const std::optional<Direction> direction :
             {std::optional(Direction::positive), std::optional(Direction::negative),
              std::optional<Direction>()}) {
            ComparedCurve curve{direction, {}, {}};
            const auto before = meansOf(was, direction);
            const auto after = meansOf(is, direction);
            for (std::size_t i = 0; i < after.size(); ++i)
                curve.values.push_back(before[i] && after[i] ? std::optional(*after[i] - *before[i])
                                                             : std::nullopt);
            curve.band.resize(curve.values.size());
            m_result.curves.push_back(std::move(curve));
        }
        removeMean(m_result.curves);
    }

    /// Too few common targets: at those of the second test, between those of the first.
    void interpolateCurves() {
        const auto statisticsOf = [&](const PairedTest &t) {
            return std::get<PositioningResults>(evaluation(*t.test, t.surroundings).results).targets;
        };
        const auto &a = std::get<PositioningMeasurement>(m_before.test->measurement);
        const auto &b = std::get<PositioningMeasurement>(m_after.test->measurement);
        const auto was = statisticsOf(m_before);
        const auto is = statisticsOf(m_after);
        m_result.interpolated = true;
        m_result.targets = b.targets;
        for (const std::optional<Direction> direction :
             {std::optional(Direction::positive), std::optional(Direction::negative),
              std::optional<Direction>()}) {
            ComparedCurve curve{direction, {}, {}};
            const auto before = meansOf(was, direction);
            const auto after = meansOf(is, direction);
            for (std::size_t i = 0; i < after.size(); ++i) {
                const auto there = betweenTargets(a.targets, before, b.targets[i]);
                curve.values.push_back(there && after[i] ? std::optional(*after[i] - *there) : std::nullopt);
            }
            curve.band.resize(curve.values.size());
            m_result.curves.push_back(std::move(curve));
        }
        removeMean(m_result.curves);
    }

    void simulate(const Test &before, const Test &after, const TestEvaluation &was,
                  const TestEvaluation &is) {
        const auto &resultsBefore = std::get<PositioningResults>(was.results);
        const auto &resultsAfter = std::get<PositioningResults>(is.results);
        const TrialsOfTest a = trialsOf(before, m_before.surroundings, resultsBefore);
        const TrialsOfTest b = trialsOf(after, m_after.surroundings, resultsAfter);
        const auto drifts = [](const PositioningResults &r) { return r.drift && r.drift->significant(); };
        m_result.pooled = m_result.cycles == 2 || drifts(resultsBefore) || drifts(resultsAfter);
        m_result.simulated = a.budget.isComplete() && b.budget.isComplete();
        if (m_result.simulated)
            m_result.shared = sharedErrors(m_before, m_after, m_options);
        std::vector<decltype(ParameterFormula::four)> formulas;
        std::vector<ComparedParameter *> parameters;
        for (ComparedParameter &parameter : m_result.parameters) {
            const auto row = std::ranges::find(m_result.edition->rows, std::string_view(parameter.term.id),
                                               [](const Row &r) { return std::string_view(r.term.id); });
            if (row == m_result.edition->rows.end())
                continue;
            formulas.push_back(row->value->four);
            parameters.push_back(&parameter);
        }
        const std::size_t count = formulas.size();
        const ComparisonTrials trials(a, b, *m_result.edition, resultsAfter.standardDeviation,
                                      std::move(formulas), m_result.shared, m_result.cycles, m_result.pooled);
        const auto drawn = static_cast<double>(a.readings.positive.size() + a.readings.negative.size() +
                                               b.readings.positive.size() + b.readings.negative.size());
        const auto wanted = static_cast<long long>(mostDraws / std::max(drawn, 1.0));
        m_result.trials = std::clamp(wanted, fewestTrials, std::max(fewestTrials, m_options.trials)) /
                          Lanes::count * Lanes::count;
        const auto spreads = [&](long long number, DrawnParts parts) {
            return spreadsOf(trials.run(number, parts, count, m_options.threads), count);
        };
        const auto residuals = spreads(m_result.simulated ? partTrials : m_result.trials, {false, true});
        for (std::size_t p = 0; p < count; ++p)
            parameters[p]->repeatabilityAlone = residuals[p].expanded;
        if (m_result.simulated) {
            const auto whole = spreads(m_result.trials, {true, true});
            const auto errors = spreads(partTrials, {true, false});
            for (std::size_t p = 0; p < count; ++p) {
                parameters[p]->uncertainty = whole[p].expanded;
                parameters[p]->shift = whole[p].mean - parameters[p]->difference;
                parameters[p]->errorsAlone = errors[p].expanded;
            }
            addBands(trials, count);
            return;
        }
        for (std::size_t p = 0; p < count; ++p) {
            if (parameters[p]->uncertainty)
                parameters[p]->uncertainty = std::hypot(*parameters[p]->uncertainty, residuals[p].expanded);
        }
    }

    void addBands(const ComparisonTrials &trials, std::size_t parameters) {
        const std::size_t targets = m_result.targets.size();
        const auto number =
            std::clamp(static_cast<long long>(mostKept / (3.0 * static_cast<double>(targets))), 400LL,
                       partTrials) /
            Lanes::count * Lanes::count;
        const std::size_t values = trials.values();
        const auto spreads = spreadsOf(trials.run(number, {}, values, m_options.threads), values);
        std::size_t means = 0;
        for (const ComparedCurve &curve : m_result.curves)
            means += curve.direction ? static_cast<std::size_t>(std::ranges::count_if(
                                           curve.values, [](const auto &value) { return value.has_value(); }))
                                     : 0;
        const double factor = bandFactor(means, m_result.cycles);
        for (std::size_t c = 0; c < m_result.curves.size(); ++c) {
            ComparedCurve &curve = m_result.curves[c];
            for (std::size_t i = 0; i < targets; ++i) {
                if (curve.values[i])
                    curve.band[i] = factor * spreads[parameters + c * targets + i].expanded;
            }
        }
    }

    void addWords() {
        bool any = false;
        for (ComparedParameter &parameter : m_result.parameters) {
            if (!parameter.uncertainty)
                continue;
            any = true;
            if (m_options.role == ComparisonRole::laboratories) {
                if (!(*parameter.uncertainty > 0))
                    continue; // nothing to divide by
                parameter.enRatio = parameter.difference / *parameter.uncertainty;
                parameter.word = std::abs(*parameter.enRatio) <= 1 ? ChangeWord::agree : ChangeWord::disagree;
            } else {
                parameter.word = changeWord(parameter.before, parameter.after, parameter.term.bound,
                                            *parameter.uncertainty, m_options.tolerance);
            }
        }
        if (!any)
            m_result.noWord = NoWord::noUncertainty;
    }

    void compareCircles(const CircularMeasurement &a, const CircularMeasurement &b) {
        if (a.nominalRadius != b.nominalRadius || a.source != b.source) {
            m_result.refusal = NotComparable::otherRadius;
            return;
        }
        const TestEvaluation was = evaluation(*m_before.test, m_before.surroundings);
        const TestEvaluation is = evaluation(*m_after.test, m_after.surroundings);
        addParameters(was, is);
        const auto isRepeatable = [](const CircularMeasurement &m, const TestEvaluation &e) {
            return m.uncertainty.repeatability || !std::get<CircularResults>(e.results).repetitions.empty();
        };
        if (isRepeatable(a, was) && isRepeatable(b, is))
            addWords();
        else
            m_result.noWord = NoWord::noRepeatability;
    }

    const PairedTest &m_before;
    const PairedTest &m_after;
    const ComparisonOptions &m_options;
    TestComparison m_result;
};

} // namespace

TestComparison compareTwoTests(const PairedTest &before, const PairedTest &after,
                               const ComparisonOptions &options) {
    return Comparer(before, after, options).compare();
}

ChangeWord changeWord(double before, double after, Bound bound, double uncertainty,
                      std::optional<double> tolerance) {
    const double change = std::abs(after - before);
    if (tolerance && *tolerance > 0) {
        if (change + uncertainty <= *tolerance)
            return ChangeWord::unchangedWithin;
        return change - uncertainty > *tolerance ? ChangeWord::changedByMore : ChangeWord::notProven;
    }
    if (!(change > uncertainty))
        return ChangeWord::noChangeProven;
    const auto size = [bound](double value) {
        return bound == Bound::magnitude ? std::abs(value) : bound == Bound::lower ? -value : value;
    };
    const double more = size(after) - size(before);
    return more > 0 ? ChangeWord::worse : more < 0 ? ChangeWord::better : ChangeWord::changed;
}

double smallSampleFactor(int cycles) {
    return studentQuantile(1 - tail, 2 * cycles - 2) / 2;
}

double bandFactor(std::size_t means, int cycles) {
    const int degrees = 2 * cycles - 2;
    return studentQuantile(1 - tail / static_cast<double>(std::max<std::size_t>(means, 1)), degrees) /
           studentQuantile(1 - tail, degrees);
}

std::optional<double> betweenTargets(const std::vector<double> &targets,
                                     const std::vector<std::optional<double>> &values, double position) {
    const auto above = std::ranges::lower_bound(targets, position - sameTarget);
    if (above == targets.end())
        return std::nullopt;
    const auto k = static_cast<std::size_t>(above - targets.begin());
    if (std::abs(targets[k] - position) <= sameTarget)
        return values[k];
    if (k == 0 || !values[k] || !values[k - 1])
        return std::nullopt;
    return std::lerp(*values[k - 1], *values[k], (position - targets[k - 1]) / (targets[k] - targets[k - 1]));
}

} // namespace palmer
