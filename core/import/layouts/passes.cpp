// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/passes.h"

#include "kernel/numerics/runinbackground.h"
#include "tables/contenterror.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <optional>
#include <utility>

namespace palmer {

namespace {

constexpr double finest = 1e10; ///< differences are rounded to this fraction of a mm or degree

/// Computes once what is common to all readings, as there are millions.
struct DeviationForm : PassForm {
    explicit DeviationForm(const PassForm &form)
        : PassForm(form) {}

    bool arePositions = content == "positions";
    bool isReversed = sign == "targetMinusActual";
};

double deviation(double position, double value, const DeviationForm &form) {
    double result = 0;
    if (form.arePositions) {
        // If both units are the same, subtracts in the file's units, to keep its decimals.
        result = form.unit == form.positionUnit
                     ? std::round((value - position) * finest) / finest
                     : std::round((form.unit->toBase(value) - form.positionUnit->toBase(position)) * finest) /
                           finest;
        if (form.unit == form.positionUnit)
            result = form.unit->toBase(result);
    } else {
        result = form.unit->toBase(value);
    }
    return form.isReversed ? 0 - result : result;
}

void remarkGaps(const PositioningMeasurement &measurement, Remarks &remarks) {
    std::size_t missing = 0;
    for (const Run &run : measurement.runs)
        missing += static_cast<std::size_t>(
            std::ranges::count_if(run.deviations, [](const auto &value) { return !value; }));
    const std::size_t all = measurement.runs.size() * measurement.targets.size();
    if (2 * missing > all)
        remarks.problem("layout",
                        REPORT_TEXT("report", "Layout: readings missing: "
                                              "%1 of %2; are these runs and targets those of one test?"),
                        counted(missing), counted(all));
    else if (missing > 0)
        remarks.note({}, REPORT_TEXT("report", "Readings missing: %1."), counted(missing));
    const auto upward =
        static_cast<std::size_t>(std::ranges::count(measurement.runs, Direction::positive, &Run::approach));
    const std::size_t downward = measurement.runs.size() - upward;
    if (upward != downward && upward > 0 && downward > 0)
        remarks.problem("unequalRuns",
                        REPORT_TEXT("report", "The directions have unequal numbers of runs: %1 ↑ and %2 ↓."),
                        counted(upward), counted(downward));
    remarks.note({}, REPORT_TEXT("report", "Understood: targets: %1; runs ↑: %2; runs ↓: %3."),
                 counted(measurement.targets.size()), counted(upward), counted(downward));
}

/// All positions of the passes, ascending without repetition. Most files repeat the same ones in order.
std::vector<double> positionsOf(const std::vector<Pass> &passes) {
    std::vector<double> positions;
    if (!passes.empty())
        positions.reserve(passes.front().readings.size());
    for (const Pass &pass : passes) {
        if (&pass != &passes.front() && std::ranges::equal(pass.readings, passes.front().readings, {},
                                                           &PassReading::position, &PassReading::position))
            continue;
        for (const PassReading &reading : pass.readings)
            positions.push_back(reading.position + 0.0); // −0 is 0
    }
    if (!std::ranges::is_sorted(positions))
        std::ranges::sort(positions);
    positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
    return positions;
}

/// Index of a position; tries `next` first.
std::size_t placeOf(double position, const std::vector<double> &positions, std::size_t next) {
    if (next < positions.size() && positions[next] == position)
        return next;
    return static_cast<std::size_t>(std::ranges::lower_bound(positions, position) - positions.begin());
}

/// A run with its readings at the positions of all passes.
struct SortedPass {
    Run run;
    /// Repeated readings at a place.
    struct Repeated {
        std::size_t times = 0;
        std::size_t line = 0; ///< of the first one

        void add(const Repeated &other) {
            line = times == 0 ? other.line : line;
            times += other.times;
        }
    };
    Repeated same = {};  ///< with the same number
    Repeated other = {}; ///< with another number, so that the true one is unknown
};

SortedPass sortedPass(Pass &pass, const std::vector<double> &positions, const DeviationForm &form) {
    SortedPass result{{pass.direction, std::vector<std::optional<double>>(positions.size())}};
    std::vector<bool> taken(positions.size());
    std::size_t next = 0;
    for (const PassReading &reading : pass.readings) {
        const std::size_t at = placeOf(reading.position, positions, next);
        next = at + 1;
        if (taken[at]) {
            const bool isOther = !reading.isMissing && result.run.deviations[at] !=
                                                           deviation(reading.position, reading.value, form);
            (isOther ? result.other : result.same).add({1, reading.line});
            continue;
        }
        taken[at] = true;
        if (!reading.isMissing)
            result.run.deviations[at] = deviation(reading.position, reading.value, form);
    }
    std::vector<PassReading>().swap(pass.readings); // frees its memory for the next run, as = {} does not
    return result;
}

} // namespace

PositioningMeasurement measurementOf(std::vector<Pass> passes, const PassForm &form, Remarks &remarks) {
    PositioningMeasurement result;
    std::vector<double> positions = positionsOf(passes);
    if (positions.empty() || passes.empty())
        refuseWithoutReadings();
    constexpr std::size_t readingLimit = 10'000'000;
    if (positions.size() > readingLimit / passes.size())
        refuseAs(Error::Kind::tooLarge,
                 REPORT_TEXT("report",
                             "targets: %1, runs: %2: that is no positioning test; look at the kind and "
                             "the columns"),
                 counted(positions.size()), counted(passes.size()));
    const DeviationForm deviations(form);
    SortedPass::Repeated same;
    SortedPass::Repeated other;
    const auto take = [&](SortedPass sorted) {
        same.add(sorted.same);
        other.add(sorted.other);
        result.runs.push_back(std::move(sorted.run));
    };
    // Handles two passes in parallel if they are long.
    constexpr std::size_t isLong = 100'000;
    for (std::size_t j = 0; j < passes.size(); j += 2) {
        std::future<SortedPass> second;
        if (j + 1 < passes.size())
            second = runInBackground(positions.size() > isLong,
                                     [&, j] { return sortedPass(passes[j + 1], positions, deviations); });
        take(sortedPass(passes[j], positions, deviations));
        if (second.valid())
            take(second.get());
    }
    for (double &position : positions)
        position = form.positionUnit->toBase(position);
    result.targets = std::move(positions);
    result.axis.motion = form.positionUnit->kind == UnitKind::angle ? Motion::rotary : Motion::linear;
    if (same.times > 0)
        remarks.problem(
            {"", same.line},
            REPORT_TEXT("report", "Readings that stand at a target twice in one run: %1; the first is kept."),
            counted(same.times));
    if (other.times > 0)
        remarks.problem({"unread", other.line},
                        REPORT_TEXT("report", "Readings that differ from another at the same target in the "
                                              "same run: %1; the first was read."),
                        counted(other.times));
    remarkGaps(result, remarks);
    return result;
}

Test testFrom(PositioningMeasurement measurement, std::string_view axis, Choices &choices,
              const Edition *stated) {
    Test test;
    measurement.axis.name = choices.resolve("axis", axis, Origin::recognised).value;
    test.edition = choices.resolveEdition(Kind::positioning, stated);
    test.measurement = std::move(measurement);
    return test;
}

void requireOneMotion(const PassForm &form) {
    if (form.unit->kind != form.positionUnit->kind)
        refuseContent(REPORT_TEXT("report", "%1 cannot be %2 here: the axis moves the other way"),
                      nameOfChoice("positionUnit"), nameOfWord("positionUnit", form.positionUnit->word));
}

void addMissing(Pass &pass, std::span<const double> targets) {
    std::vector<double> there;
    for (const PassReading &reading : pass.readings)
        there.push_back(reading.position);
    std::ranges::sort(there);
    for (const double target : targets) {
        if (!std::ranges::binary_search(there, target))
            pass.readings.push_back({target, 0, 0, true});
    }
}

bool isStrictlyMonotone(std::span<const double> values) {
    return std::ranges::adjacent_find(values, std::ranges::greater_equal()) == values.end() ||
           std::ranges::adjacent_find(values, std::ranges::less_equal()) == values.end();
}

std::vector<Pass> inCycles(std::vector<Pass> passes) {
    std::vector<Pass> upward;
    std::vector<Pass> downward;
    for (Pass &pass : passes)
        (pass.direction == Direction::positive ? upward : downward).push_back(std::move(pass));
    std::vector<Pass> result;
    for (std::size_t j = 0; j < std::max(upward.size(), downward.size()); ++j) {
        if (j < upward.size())
            result.push_back(std::move(upward[j]));
        if (j < downward.size())
            result.push_back(std::move(downward[j]));
    }
    return result;
}

} // namespace palmer
