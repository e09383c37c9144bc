#include "import/passes.h"

#include "document/documenterror.h"

#include <algorithm>
#include <cmath>

namespace palmer {

namespace {

constexpr double finest = 1e10; ///< parts of a mm or degree that differences are rounded to

Number count(std::size_t n) {
    return {static_cast<double>(n), Quantity::count};
}

double deviation(double position, double value, const PassForm &form) {
    double result = 0;
    if (form.content == "positions") {
        // Subtracted in the file's units where they are the same: the decimals of the file stay.
        result = form.unit == form.positionUnit
                     ? std::round((value - position) * finest) / finest
                     : std::round((form.unit->toBase(value) - form.positionUnit->toBase(position)) * finest) /
                           finest;
        if (form.unit == form.positionUnit)
            result = form.unit->toBase(result);
    } else {
        result = form.unit->toBase(value);
    }
    return form.sign == "targetMinusActual" ? 0 - result : result;
}

void remarkZeros(const PositioningMeasurement &measurement, std::vector<Remark> &remarks) {
    for (std::size_t j = 0; j < measurement.runs.size(); ++j) {
        std::size_t zeros = 0;
        std::size_t readings = 0;
        for (const auto &value : measurement.runs[j].deviations) {
            readings += value ? 1 : 0;
            zeros += value && *value == 0 ? 1 : 0;
        }
        if (readings > 1 && zeros == readings)
            remarks.push_back(
                {RemarkGrade::problem,
                 {REPORT_TEXT("report", "All readings of run %1 are zero: was it measured at all?"),
                  {count(j + 1)}}});
    }
}

void remarkGaps(const PositioningMeasurement &measurement, std::vector<Remark> &remarks) {
    std::size_t missing = 0;
    for (const Run &run : measurement.runs)
        missing += static_cast<std::size_t>(
            std::ranges::count_if(run.deviations, [](const auto &value) { return !value; }));
    if (missing > 0)
        remarks.push_back(
            {RemarkGrade::note, {REPORT_TEXT("report", "Readings missing: %1."), {count(missing)}}});
    const auto upward =
        static_cast<std::size_t>(std::ranges::count(measurement.runs, Direction::positive, &Run::approach));
    const std::size_t downward = measurement.runs.size() - upward;
    if (upward != downward && upward > 0 && downward > 0)
        remarks.push_back(
            {RemarkGrade::problem,
             {REPORT_TEXT("report", "The directions have unequal numbers of runs: %1 ↑ and %2 ↓."),
              {count(upward), count(downward)}}});
    remarks.push_back({RemarkGrade::note,
                       {REPORT_TEXT("report", "Understood: targets: %1; runs ↑: %2; runs ↓: %3."),
                        {count(measurement.targets.size()), count(upward), count(downward)}}});
}

} // namespace

PositioningMeasurement measurementOf(const std::vector<Pass> &passes, const PassForm &form,
                                     std::vector<Remark> &remarks) {
    PositioningMeasurement result;
    std::vector<double> positions;
    for (const Pass &pass : passes) {
        for (const PassReading &reading : pass.readings)
            positions.push_back(reading.position + 0.0); // −0 is 0
    }
    std::ranges::sort(positions);
    positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
    if (positions.empty() || passes.empty())
        throw Error(
            Error::Kind::content,
            {REPORT_TEXT("report", "there are no readings in it; expected target positions and deviations")});
    constexpr std::size_t readingLimit = 10'000'000;
    if (positions.size() > readingLimit / passes.size())
        throw Error(Error::Kind::tooLarge,
                    {REPORT_TEXT("report", "more than 10 000 000 readings or points")});
    std::size_t repeated = 0;
    std::size_t firstRepeated = 0;
    for (const Pass &pass : passes) {
        Run run{pass.direction, std::vector<std::optional<double>>(positions.size())};
        std::vector<bool> taken(positions.size());
        for (const PassReading &reading : pass.readings) {
            const auto at = static_cast<std::size_t>(std::ranges::lower_bound(positions, reading.position) -
                                                     positions.begin());
            if (taken[at]) {
                firstRepeated = repeated++ == 0 ? reading.line : firstRepeated;
                continue;
            }
            taken[at] = true;
            if (reading.value)
                run.deviations[at] = deviation(reading.position, *reading.value, form);
        }
        result.runs.push_back(std::move(run));
    }
    for (double &position : positions)
        position = form.positionUnit->toBase(position);
    result.targets = std::move(positions);
    result.axis.motion = form.positionUnit->kind == UnitKind::angle ? Motion::rotary : Motion::linear;
    if (repeated > 0)
        remarks.push_back(
            {RemarkGrade::problem,
             {REPORT_TEXT("report",
                          "Readings that stand at a target twice in one run: %1; the first is kept."),
              {count(repeated)}},
             firstRepeated});
    remarkZeros(result, remarks);
    remarkGaps(result, remarks);
    return result;
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

bool arePositions(const std::vector<Pass> &passes) {
    double low = INFINITY;
    double high = -INFINITY;
    double largest = 0;    // of the values
    double difference = 0; // of value and position
    std::size_t n = 0;
    for (const Pass &pass : passes) {
        for (const PassReading &reading : pass.readings) {
            if (!reading.value)
                continue;
            ++n;
            low = std::min(low, reading.position);
            high = std::max(high, reading.position);
            largest = std::max(largest, std::abs(*reading.value));
            difference = std::max(difference, std::abs(*reading.value - reading.position));
        }
    }
    const double size = std::max(high - low, std::abs(high));
    return n > 1 && high > low && difference < 0.1 * size && largest > 0.5 * size;
}

PassForm settleForm(const std::vector<Pass> &passes, std::string_view content, const Unit *unit,
                    const Unit *positionUnit, Choices &choices, std::vector<Remark> &remarks) {
    PassForm form;
    double low = INFINITY;
    double high = -INFINITY;
    for (const Pass &pass : passes) {
        for (const PassReading &reading : pass.readings) {
            if (reading.value) {
                low = std::min(low, *reading.value);
                high = std::max(high, *reading.value);
            }
        }
    }
    const bool anyValue = low <= high;
    const bool looksLikePositions = arePositions(passes);
    const Choice<std::string> settled =
        choices.settle("content",
                       !content.empty()     ? content
                       : looksLikePositions ? "positions"
                                            : "deviations",
                       content.empty() && anyValue ? Origin::guessed : Origin::recognised);
    form.content = settled.value;
    const bool positions = form.content == "positions";
    if (settled.origin == Origin::guessed)
        remarks.push_back(
            {RemarkGrade::assumption,
             {positions
                  ? REPORT_TEXT("report", "Content: the values run from %1 to %2 as the targets do; they are "
                                          "read as positions, not as deviations.")
                  : REPORT_TEXT("report",
                                "Content: the values run from %1 to %2; they are read as deviations, not "
                                "as positions."),
              {Number{low, Quantity::number}, Number{high, Quantity::number}}},
             0,
             0,
             "content"});
    // The motion: what is chosen, else what the units say.
    const bool angular = choices.isChosen("motion")
                             ? choices.chosen("motion") == "rotary"
                             : (positionUnit && positionUnit->kind == UnitKind::angle) ||
                                   (!positionUnit && unit && unit->kind == UnitKind::angle);
    const bool knowsMotion = positionUnit || unit;
    choices.settle("motion", angular ? "rotary" : "linear",
                   knowsMotion ? Origin::recognised : Origin::guessed);
    const UnitKind kind = angular ? UnitKind::angle : UnitKind::length;
    const auto fits = [&](const Unit *candidate) {
        return candidate && candidate->kind == kind ? candidate : nullptr;
    };
    const auto settleUnit = [&](std::string_view key, const Unit *stated, const Unit *guess, Text remark) {
        const Unit *chosen = fits(unitOf(choices.chosen(key)));
        if (choices.isChosen(key) && !chosen)
            throw Error(Error::Kind::content,
                        {REPORT_TEXT("report", "%1 cannot be %2 here: the axis moves the other way"),
                         {std::string(key), std::string(choices.chosen(key))}});
        const Unit *found = fits(stated) ? stated : guess;
        const auto choice =
            choices.settle(key, found->word, fits(stated) ? Origin::recognised : Origin::guessed);
        const Unit *result = chosen ? chosen : found;
        if (choice.origin == Origin::guessed)
            remarks.push_back(
                {RemarkGrade::assumption, {remark, {std::string(result->sign)}}, 0, 0, std::string(key)});
        return result;
    };
    const Unit *base = unitOf(angular ? "deg" : "mm");
    form.positionUnit = settleUnit(
        "positionUnit",
        positionUnit ? positionUnit
        : positions  ? unit
                     : nullptr,
        base,
        REPORT_TEXT("report", "Unit of the target positions: nothing in the file says it; read as %1."));
    const double largest = anyValue ? std::max(std::abs(low), std::abs(high)) : 0;
    constexpr double finestGuess = 0.5; // a deviation of half a millimetre or degree is none
    const Unit *small = unitOf(angular ? "arcsec" : "um");
    const Unit *guess = positions ? form.positionUnit : largest < finestGuess ? base : small;
    form.unit = settleUnit(
        "unit", unit, guess,
        positions ? REPORT_TEXT("report", "Unit of the positions: nothing in the file says it; read as %1.")
                  : REPORT_TEXT("report", "Unit of the deviations: nothing in the file says it; read as %1 "
                                          "after their size."));
    if (positions) {
        form.sign = "actualMinusTarget";
    } else {
        const auto sign = choices.settle("sign", "actualMinusTarget", Origin::guessed);
        form.sign = sign.value;
        if (sign.origin == Origin::guessed)
            remarks.push_back(
                {RemarkGrade::assumption,
                 {REPORT_TEXT("report", "Sign: nothing in the file says it; read as actual − target.")},
                 0,
                 0,
                 "sign"});
    }
    return form;
}

} // namespace palmer
