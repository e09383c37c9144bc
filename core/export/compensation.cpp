// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/compensation.h"

#include "document/documenterror.h"
#include "kernel/evaluation/correctionto20.h"
#include "kernel/evaluation/resultsof.h"
#include "kernel/measurement/testfacts.h"
#include "kernel/numerics/angles.h"
#include "kernel/words/characters.h"

#include <algorithm>
#include <cmath>

namespace palmer {

namespace {

constexpr std::size_t mostPoints = 100'000;
constexpr double largest = 1e9; ///< mm, degrees

// Positions and values are rounded to this fraction of a mm or degree.
double fineness(Motion motion) {
    return motion == Motion::linear ? 1e4 : 1e5;
}

/// Position as an integer multiple of 1e-6 mm or degrees, so that sums are exact.
long long steps(double position) {
    return std::llround(position * positionFineness);
}

double positionOf(long long steps) {
    return static_cast<double>(steps) / positionFineness;
}

[[noreturn]] void refuseCompensation(Text text, std::vector<Argument> arguments = {}) {
    throw Error(Error::Kind::content, {text, std::move(arguments)});
}

Number count(std::size_t number) {
    return {static_cast<double>(number), Quantity::count};
}

[[noreturn]] void refuseInterval() {
    refuseCompensation(
        REPORT_TEXT("report", "the interval of a compensation is positive and gives at most 100 000 points"));
}

void requirePossible(const PositioningMeasurement &measurement, CompensationFormat format,
                     const CompensationOptions &options) {
    const bool csv = format == CompensationFormat::csv;
    if ((options.incremental && !csv) ||
        (options.deviations && !csv && format != CompensationFormat::weihong))
        refuseCompensation(REPORT_TEXT(
            "report", "this format knows absolute values of one sign only; choose compensation-csv"));
    if (format == CompensationFormat::siemens && options.perDirection)
        refuseCompensation(REPORT_TEXT("report",
                                       "this format has one value a point; combine the directions, and "
                                       "state the reversal value as backlash"));
    if (format == CompensationFormat::siemens && !options.reference)
        refuseCompensation(
            REPORT_TEXT("report", "the compensation of a SINUMERIK is 0 at the reference point of the axis: "
                                  "say where that is"));
    if (format == CompensationFormat::weihong && measurement.axis.motion == Motion::rotary)
        refuseCompensation(REPORT_TEXT("report", "axeserr.dat knows mm only; this axis is rotary"));
}

/// True if the axis is rotary and its targets or its stated travel cover one full turn: the table closes.
bool isFullTurn(const PositioningMeasurement &measurement, const CompensationOptions &options) {
    constexpr double same = 1e-6;
    const auto turns = [](double travel) { return std::abs(travel - fullTurn) < same; };
    const Axis &axis = measurement.axis;
    const bool wanted = !options.to || turns(*options.to - options.from.value_or(0));
    return axis.motion == Motion::rotary && wanted &&
           measurement.targets.back() - measurement.targets.front() < fullTurn + same &&
           (turns(measurement.targets.back() - measurement.targets.front()) ||
            (axis.travel && turns(*axis.travel)) || (axis.range && turns(axis.range->to - axis.range->from)));
}

/// Equally spaced positions `low + i · step`, the last not beyond `high`.
std::vector<double> evenPositions(long long low, long long high, long long step) {
    if (step <= 0 || high <= low || (high - low) / step > static_cast<long long>(mostPoints))
        refuseInterval();
    std::vector<double> positions;
    for (long long at = low; at <= high; at += step)
        positions.push_back(positionOf(at));
    return positions;
}

std::vector<double> positionsOfTurn(const PositioningMeasurement &measurement,
                                    const CompensationOptions &options) {
    const bool turned = measurementTravel(measurement) > fullTurn - 1e-6;
    const long long low = steps(options.from.value_or(turned ? measurement.targets.front() : 0));
    const long long turn = steps(fullTurn);
    if (options.interval) {
        const long long step = steps(*options.interval);
        if (step <= 0 || turn % step != 0)
            refuseCompensation(REPORT_TEXT("report", "the interval of a table of a full turn divides 360°"));
        return evenPositions(low, low + turn, step);
    }
    const double mean = measurementTravel(measurement) / static_cast<double>(measurement.targets.size() - 1);
    auto parts = std::max(1LL, std::llround(fullTurn / mean));
    while (turn % parts != 0)
        ++parts;
    return evenPositions(low, low + turn, turn / parts);
}

std::vector<double> positionsOf(const PositioningMeasurement &measurement, CompensationFormat format,
                                const CompensationOptions &options, bool closes) {
    const double from = options.from.value_or(measurement.targets.front());
    const double to = options.to.value_or(measurement.targets.back());
    const auto possible = [](double position) { return std::abs(position) <= largest; };
    if (closes) {
        if (!possible(options.from.value_or(0)))
            refuseCompensation(REPORT_TEXT("report", "the range of a compensation begins before it ends"));
        return positionsOfTurn(measurement, options);
    }
    if (!(from < to) || !possible(from) || !possible(to))
        refuseCompensation(REPORT_TEXT("report", "the range of a compensation begins before it ends"));
    if (options.interval && !(*options.interval > 0 && *options.interval <= largest))
        refuseInterval();
    if (format == CompensationFormat::siemens) {
        const auto intervals = static_cast<long long>(measurement.targets.size()) - 1;
        const long long step = options.interval ? steps(*options.interval)
                                                : (steps(to) - steps(from) + intervals - 1) / intervals;
        // If the steps do not end at `to`, add one beyond it, with the last correction, to cover the measured
        // range.
        std::vector<double> positions = evenPositions(steps(from), steps(to), step);
        if (steps(positions.back()) < steps(to))
            positions.push_back(positionOf(steps(positions.back()) + step));
        return positions;
    }
    if (options.interval) {
        std::vector<double> positions = evenPositions(steps(from), steps(to), steps(*options.interval));
        if (steps(positions.back()) < steps(to))
            positions.push_back(positionOf(steps(to)));
        return positions;
    }
    if (!options.from && !options.to)
        return measurement.targets;
    std::vector<double> positions{from};
    for (const double target : measurement.targets) {
        if (target > from && target < to)
            positions.push_back(target);
    }
    positions.push_back(to);
    return positions;
}

CompensationTable correctionsOfTargets(const PositioningMeasurement &measurement,
                                       const PositioningResults &results, bool perDirection) {
    CompensationTable curve;
    curve.positions = measurement.targets;
    for (std::size_t i = 0; i < measurement.targets.size(); ++i) {
        const TargetStatistics &target = results.targets[i];
        const double up = results.upward ? target.positive.mean : target.negative.mean;
        const double down = results.downward ? target.negative.mean : target.positive.mean;
        if (!std::isfinite(up) || !std::isfinite(down))
            refuseCompensation(
                REPORT_TEXT("report", "target %1 has no mean; a compensation needs one at every target"),
                {count(i + 1)});
        curve.forward.push_back(-(perDirection ? up : (up + down) / 2));
        curve.reverse.push_back(-(perDirection ? down : (up + down) / 2));
    }
    return curve;
}

/// The table over the full turn: 0° and 360° are the same position, with the mean of both.
CompensationTable closed(const CompensationTable &curve, double low) {
    constexpr double same = 1e-6;
    struct Point {
        double position, forward, reverse;
        int readings = 0;
    };
    std::vector<Point> points;
    for (std::size_t i = 0; i < curve.positions.size(); ++i) {
        double position = std::fmod(curve.positions[i] - low, fullTurn);
        position += position < 0 ? fullTurn : 0;
        if (fullTurn - position < same)
            position = 0;
        points.push_back({position, curve.forward[i], curve.reverse[i], 1});
    }
    std::ranges::sort(points, {}, &Point::position);
    std::vector<Point> places;
    for (const Point &point : points) {
        if (places.empty() || point.position - places.back().position > same) {
            places.push_back(point);
        } else {
            places.back().forward += point.forward;
            places.back().reverse += point.reverse;
            ++places.back().readings;
        }
    }
    for (Point &place : places) {
        place.forward /= place.readings;
        place.reverse /= place.readings;
    }
    CompensationTable result;
    const auto add = [&](const Point &place, double turns) {
        result.positions.push_back(low + place.position + turns * fullTurn);
        result.forward.push_back(place.forward);
        result.reverse.push_back(place.reverse);
    };
    add(places.back(), -1);
    for (const Point &place : places)
        add(place, 0);
    add(places.front(), 1);
    return result;
}

/// Makes the table 0 at the reference point; otherwise the axis jumps when the compensation becomes active.
void shiftToReference(CompensationTable &table, double reference) {
    const double there = table.correction(reference, Direction::positive);
    for (double &value : table.forward)
        value -= there;
    table.reverse = table.forward;
}

void requireLoadable(const CompensationTable &table, CompensationFormat format,
                     const PositioningMeasurement &of) {
    if (table.positions.size() < 2)
        refuseInterval();
    if (std::ranges::adjacent_find(table.positions, std::ranges::greater_equal()) != table.positions.end())
        refuseCompensation(REPORT_TEXT("report", "the positions of a compensation table ascend"));
    if (format == CompensationFormat::linuxcnc && table.positions.size() > mostLinuxcncPoints) {
        const double least =
            (table.positions.back() - table.positions.front()) / static_cast<double>(mostLinuxcncPoints - 2);
        refuseCompensation(
            REPORT_TEXT("report",
                        "LinuxCNC loads 256 points at most, this table has %1; choose an interval of "
                        "%2 or more"),
            {count(table.positions.size()),
             Number{std::ceil(least * 1e3) / 1e3,
                    of.axis.motion == Motion::linear ? Quantity::position : Quantity::angle}});
    }
}

} // namespace

const ImportedFile *fileOfAssumedSign(const Test &test) {
    const auto found = std::ranges::find(test.imports, std::optional(true), &ImportedFile::signAssumed);
    return found == test.imports.end() ? nullptr : &*found;
}

CompensationTable compensationTable(const Test &test, const TestEvaluation &evaluation,
                                    CompensationFormat format, const CompensationOptions &options) {
    const auto *measurement = std::get_if<PositioningMeasurement>(&test.measurement);
    if (!measurement)
        refuseCompensation(
            REPORT_TEXT("report", "a compensation is made of a positioning test; this test is none"));
    if (measurement->targets.size() < 2)
        refuseCompensation(REPORT_TEXT("report", "a compensation needs two targets at least"));
    if (const ImportedFile *file = fileOfAssumedSign(test); file && !options.signConfirmed)
        refuseCompensation(
            REPORT_TEXT("report",
                        "“%1” does not say the sign of its deviations, and a table of the wrong sign "
                        "doubles them: confirm that they are actual − target, or import it with "
                        "the other sign"),
            {file->fileName});
    requirePossible(*measurement, format, options);
    const PositioningResults &results = resultsOf(*measurement, evaluation);
    const bool bothWays = measuredBothWays(evaluation);
    if (options.perDirection && !bothWays)
        refuseCompensation(REPORT_TEXT("report", "only one direction was measured: there is no compensation "
                                                 "of each direction"));
    CompensationTable curve = correctionsOfTargets(*measurement, results, options.perDirection);
    const bool closes = format == CompensationFormat::siemens && isFullTurn(*measurement, options);
    CompensationTable table;
    table.axis = measurement->axis.name;
    table.motion = measurement->axis.motion;
    table.perDirection = options.perDirection;
    if (!bothWays)
        table.only = results.upward ? Direction::positive : Direction::negative;
    table.measured = Interval{measurement->targets.front(), measurement->targets.back()};
    for (const double position : positionsOf(*measurement, format, options, closes))
        table.positions.push_back(rounded(position, positionFineness));
    requireLoadable(table, format, *measurement);
    if (closes) {
        table.period = fullTurn;
        table.measured.reset(); // the whole turn is covered
        curve = closed(curve, table.positions.front());
    }
    for (const double position : table.positions) {
        table.forward.push_back(curve.correction(position, Direction::positive));
        table.reverse.push_back(curve.correction(position, Direction::negative));
    }
    if (format == CompensationFormat::siemens)
        shiftToReference(table, *options.reference);
    const double parts = fineness(table.motion);
    for (auto *values : {&table.forward, &table.reverse})
        std::ranges::transform(*values, values->begin(),
                               [parts](double value) { return rounded(value, parts); });
    return table;
}

bool measuredBothWays(const TestEvaluation &evaluation) {
    const auto *results = std::get_if<PositioningResults>(&evaluation.results);
    return results && results->upward && results->downward;
}

namespace {

/// Under what the test was made, as far as its table and the prediction hold only so.
std::vector<Message> conditionRemarks(const Conditions &conditions, Motion motion) {
    std::vector<Message> remarks;
    if (!isBlank(conditions.compensation))
        remarks.push_back(
            {REPORT_TEXT("report", "Compensation in the test: “%1”. Table and prediction hold on top of "
                                   "what was active then: add the two, do not replace it."),
             {conditions.compensation}});
    if (motion != Motion::linear || isCorrectedTo20(conditions))
        return remarks;
    constexpr double reference = 20; // °C
    constexpr double same = 0.05;
    const auto machine = meanTemperature(conditions, SensorMeasures::machine);
    if (machine && std::abs(*machine - reference) > same)
        remarks.push_back(
            {REPORT_TEXT("report", "The readings are not stated to be corrected to 20 °C: table "
                                   "and prediction hold for the machine at %1, expansion "
                                   "included."),
             {Number{*machine, Quantity::temperature}}});
    else if (!machine)
        remarks.push_back(
            {REPORT_TEXT("report", "The readings are not stated to be corrected to 20 °C: table "
                                   "and prediction hold for the temperature of the test.")});
    return remarks;
}

} // namespace

std::vector<Message> compensationRemarks(const Test &test, const CompensationTable &table,
                                         CompensationFormat format, const CompensationOptions &options) {
    const Conditions *conditions = conditionsOf(test);
    std::vector<Message> remarks =
        conditions ? conditionRemarks(*conditions, table.motion) : std::vector<Message>();
    const Quantity position = table.motion == Motion::linear ? Quantity::position : Quantity::angle;
    constexpr double same = 1e-6;
    const auto outside = [&](double at) {
        return table.measured && (at < table.measured->from - same || at > table.measured->to + same);
    };
    if (outside(table.positions.front()) || outside(table.positions.back()))
        remarks.push_back(
            {REPORT_TEXT("report", "Nothing was measured outside %1 … %2: the values at these ends "
                                   "hold there."),
             {Number{table.measured->from, position}, Number{table.measured->to, position}}});
    if (table.only)
        remarks.push_back({*table.only == Direction::positive
                               ? REPORT_TEXT("report", "Only the positive direction was measured: its values "
                                                       "stand for the negative one, too.")
                               : REPORT_TEXT("report", "Only the negative direction was measured: its values "
                                                       "stand for the positive one, too.")});
    switch (format) {
    case CompensationFormat::linuxcnc:
        remarks.push_back(
            {table.motion == Motion::linear
                 ? REPORT_TEXT("report",
                               "Set COMP_FILE_TYPE = 0; the joint counts in mm; BACKLASH has no effect "
                               "beside a COMP_FILE.")
                 : REPORT_TEXT("report",
                               "Set COMP_FILE_TYPE = 0; the joint counts in degrees; BACKLASH has no "
                               "effect beside a COMP_FILE.")});
        break;
    case CompensationFormat::siemens:
        remarks.push_back(
            {REPORT_TEXT("report", "MD38000 has to be %1 at least; MD32700 is 0 while the table is "
                                   "loaded."),
             {count(table.positions.size())}});
        if (options.reference && outside(*options.reference))
            remarks.push_back(
                {REPORT_TEXT("report", "The reference point %1 lies where nothing was measured; the "
                                       "value at the nearest end was taken for it."),
                 {Number{*options.reference, position}}});
        break;
    case CompensationFormat::weihong:
        if (!options.deviations)
            remarks.push_back({REPORT_TEXT(
                "report",
                "The values are nominal − actual, the formula of the maker's manual. Its example of a "
                "backlash has the other sign: check one point at the machine.")});
        break;
    case CompensationFormat::csv:
        break;
    }
    return remarks;
}

TableDifference largestDifference(const CompensationTable &first, const CompensationTable &second) {
    TableDifference largest;
    for (const CompensationTable *table : {&first, &second}) {
        for (const double position : table->positions) {
            for (const Direction direction : {Direction::positive, Direction::negative}) {
                const double value =
                    second.correction(position, direction) - first.correction(position, direction);
                if (std::abs(value) > std::abs(largest.value))
                    largest = {value, position, direction};
            }
        }
    }
    return largest;
}

Test compensated(const Test &test, const CompensationTable &table) {
    Test result = test;
    if (auto *measurement = std::get_if<PositioningMeasurement>(&result.measurement)) {
        for (Run &run : measurement->runs) {
            for (std::size_t i = 0; i < run.deviations.size(); ++i) {
                if (run.deviations[i])
                    *run.deviations[i] += table.correction(measurement->targets[i], run.approach);
            }
        }
    }
    return result;
}

} // namespace palmer
