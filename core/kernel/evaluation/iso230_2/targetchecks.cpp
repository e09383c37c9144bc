#include "kernel/evaluation/iso230_2/checks.h"
#include "kernel/evaluation/iso230_2/sentences.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palmer::iso230_2 {

namespace {

constexpr double longestElement = 250; ///< mm: interval of targets on a long axis

std::size_t targetCount(const PositioningCase &test) {
    return test.measurement.targets.size();
}

double zoneOfStandard(const PositioningCase &test) {
    return test.linear() ? 2000 : 360;
}

bool intervalsTooLong(const PositioningCase &test) {
    const std::size_t m = targetCount(test);
    return m < 2 ||
           measurementTravel(test.measurement) > longestElement * static_cast<double>(m - 1) * (1 + 1e-9);
}

double leftOut(const PositioningCase &test) {
    return test.travel() - measurementTravel(test.measurement);
}

/// Length of the agreed zone when it is another one than the standard's.
std::optional<double> otherZoneLength(const PositioningCase &test) {
    if (!test.measurement.zone)
        return std::nullopt;
    const double length = test.measurement.zone->to - test.measurement.zone->from;
    return std::abs(length - zoneOfStandard(test)) > 1e-6 * length ? std::optional(length) : std::nullopt;
}

/// Steps between neighbouring targets, mm or degrees.
std::vector<double> steps(const PositioningCase &test) {
    std::vector<double> result;
    const auto &targets = test.measurement.targets;
    for (std::size_t i = 1; i < targets.size(); ++i)
        result.push_back(targets[i] - targets[i - 1]);
    return result;
}

} // namespace

Sentence axisTravel(const PositioningCase &test) {
    if (test.measurement.axis.travel)
        return std::nullopt;
    return Message{
        REPORT_TEXT("report", "Axis travel not stated: the measurement travel of %1 takes its place."),
        {along(test, measurementTravel(test.measurement))}};
}

Sentence targetsPerMetre(const PositioningCase &test) {
    const double needed = 5 * test.judgedTravel() / 1000;
    if (static_cast<double>(targetCount(test)) >= needed - 1e-9)
        return std::nullopt;
    return Message{REPORT_TEXT("report", "%1 targets over %2: at least 5 per metre are required, %3 here."),
                   {count(targetCount(test)), along(test, test.judgedTravel()),
                    count(static_cast<std::size_t>(std::ceil(needed - 1e-9)))}};
}

Sentence fiveTargets(const PositioningCase &test) {
    if (targetCount(test) >= 5)
        return std::nullopt;
    return Message{REPORT_TEXT("report", "Number of targets: %1; at least 5 are required."),
                   {count(targetCount(test))}};
}

Sentence meanInterval(const PositioningCase &test) {
    if (!intervalsTooLong(test))
        return std::nullopt;
    return Message{
        REPORT_TEXT("report", "%1 targets over %2: a long axis has a target in each element of its measuring "
                              "system or every 250 mm."),
        {count(targetCount(test)), along(test, measurementTravel(test.measurement))}};
}

Sentence meanIntervalInPractice(const PositioningCase &test) {
    if (!intervalsTooLong(test))
        return std::nullopt;
    return Message{
        REPORT_TEXT("report",
                    "%1 targets over %2: practice asks for a mean interval of 250 mm and a target in "
                    "each segment of the scale (not verified against the text of the edition)."),
        {count(targetCount(test)), along(test, measurementTravel(test.measurement))}};
}

Sentence wholeLength(const PositioningCase &test) {
    if (leftOut(test) <= 2 * longestElement)
        return std::nullopt;
    return Message{REPORT_TEXT("report",
                               "The targets leave out %1 of the axis travel of %2: neither the whole travel "
                               "nor a test inside the agreed zone."),
                   {along(test, leftOut(test)), along(test, test.travel())}};
}

Sentence wholeLengthInPractice(const PositioningCase &test) {
    if (leftOut(test) <= 2 * longestElement)
        return std::nullopt;
    return Message{
        REPORT_TEXT("report",
                    "The targets leave out %1 of the axis travel of %2: practice asks for the whole travel "
                    "(not verified against the text of the edition)."),
        {along(test, leftOut(test)), along(test, test.travel())}};
}

Sentence quarterTurns(const PositioningCase &test) {
    if (test.measurement.targetChoice.kind == TargetChoiceKind::polygon)
        return std::nullopt;
    const auto &targets = test.measurement.targets;
    Interval reach{0, 359.999};
    if (test.measurement.axis.range)
        reach = *test.measurement.axis.range;
    else if (test.travel() < 270 && !targets.empty())
        reach = {targets.front(), targets.back()};
    NameList missing;
    for (const double quarter : {0.0, 90.0, 180.0, 270.0}) {
        const auto atQuarter = [quarter](double position) {
            return std::abs(std::remainder(position - quarter, 360.0)) < 1e-3;
        };
        // A tilting axis cannot go everywhere: only the quarters within its reach are asked for.
        const double first = quarter + 360 * std::ceil((reach.from - quarter) / 360);
        if (first <= reach.to && std::ranges::none_of(targets, atQuarter))
            missing.add(std::to_string(static_cast<int>(quarter)) + "°");
    }
    if (missing.empty())
        return std::nullopt;
    return Message{REPORT_TEXT("report",
                               "A rotary axis is tested at 0°, 90°, 180° and 270° or at the faces of the "
                               "polygon; missing: %1."),
                   {missing.text()}};
}

Sentence targetsOfTravel(const PositioningCase &test) {
    const double travel = test.judgedTravel();
    const std::size_t needed = travel <= 90 ? 3 : travel <= 180 ? 5 : 8;
    if (targetCount(test) >= needed)
        return std::nullopt;
    return Message{REPORT_TEXT("report",
                               "%1 targets over %2: practice asks for at least %3 (not verified against the "
                               "text of the edition)."),
                   {count(targetCount(test)), along(test, travel), count(needed)}};
}

Sentence targetsPerTurn(const PositioningCase &test) {
    const double turns = std::min(measurementTravel(test.measurement), 1800.0) / 360;
    if (targetCount(test) >= 2 && static_cast<double>(targetCount(test)) >= 8 * turns - 1e-9)
        return std::nullopt;
    return Message{REPORT_TEXT("report",
                               "%1 targets over %2: practice asks for at least 8 per turn, up to 1 800° (not "
                               "verified against the text of the edition)."),
                   {count(targetCount(test)), along(test, measurementTravel(test.measurement))}};
}

Sentence otherTest(const PositioningCase &test) {
    if (test.surroundings.otherTestOfLongAxis)
        return std::nullopt;
    if (test.zoneTest())
        return Message{REPORT_TEXT("report",
                                   "Only the zone of this long axis (%1) is tested: the test over the whole "
                                   "travel is missing in this file."),
                       {along(test, test.travel())}};
    return Message{REPORT_TEXT("report",
                               "Only the whole travel of this long axis (%1) is tested: the full test of an "
                               "agreed zone of %2 is missing in this file."),
                   {along(test, test.travel()), along(test, zoneOfStandard(test))}};
}

Sentence zoneLength(const PositioningCase &test) {
    const auto length = otherZoneLength(test);
    if (!length)
        return std::nullopt;
    return Message{REPORT_TEXT("report", "The zone is %1 long; the full test is made on an agreed %2."),
                   {along(test, *length), along(test, zoneOfStandard(test))}};
}

Sentence zoneLengthInPractice(const PositioningCase &test) {
    const auto length = otherZoneLength(test);
    if (!length)
        return std::nullopt;
    return Message{
        REPORT_TEXT("report",
                    "The zone is %1 long; practice asks for a full test on an agreed %2 (not verified "
                    "against the text of the edition)."),
        {along(test, *length), along(test, zoneOfStandard(test))}};
}

Sentence ends(const PositioningCase &test) {
    const auto &targets = test.measurement.targets;
    const auto &range = test.measurement.axis.range;
    if (!range || targets.empty())
        return std::nullopt;
    const double below = targets.front() - range->from;
    const double above = range->to - targets.back();
    const double needed = test.conditions().approachDistance.value_or(0);
    const auto enough = [needed](double room) { return needed > 0 ? room >= needed * (1 - 1e-9) : room > 0; };
    if (enough(below) && enough(above))
        return std::nullopt;
    if (needed > 0)
        return Message{REPORT_TEXT("report",
                                   "The first and the last target have to be approached from both sides; "
                                   "beyond them the axis has %1 and %2, the approach distance is %3."),
                       {along(test, below), along(test, above), along(test, needed)}};
    return Message{REPORT_TEXT("report",
                               "The first and the last target have to be approached from both sides; beyond "
                               "them the axis has %1 and %2."),
                   {along(test, below), along(test, above)}};
}

Sentence endsUnknown(const PositioningCase &test) {
    if (test.measurement.axis.range)
        return std::nullopt;
    return Message{
        REPORT_TEXT("report",
                    "The ends of the axis are not stated: whether the first and the last target can be "
                    "approached from both sides is not checked."),
        {}};
}

Sentence evenSpacing(const PositioningCase &test) {
    const TargetChoice &choice = test.measurement.targetChoice;
    const std::vector<double> all = steps(test);
    if (choice.kind != TargetChoiceKind::free || all.size() < 2)
        return std::nullopt;
    const double mean = measurementTravel(test.measurement) / static_cast<double>(all.size());
    if (std::ranges::all_of(all, [mean](double step) { return std::abs(step - mean) <= 0.01 * mean; }))
        return Message{
            REPORT_TEXT("report",
                        "The targets are evenly spaced (%1): with a new random part for every target "
                        "periodic errors do not stay hidden."),
            {along(test, mean, 2)}};
    if (!choice.period || *choice.period <= 0)
        return std::nullopt;
    const double period = *choice.period;
    const auto whole = [period](double step) {
        return std::abs(std::remainder(step, period)) <= 0.01 * period;
    };
    if (std::ranges::all_of(all, whole))
        return Message{
            REPORT_TEXT("report", "All intervals are whole multiples of the period of %1: its periodic error "
                                  "stays hidden."),
            {along(test, period)}};
    return std::nullopt;
}

Sentence randomPart(const PositioningCase &test) {
    const TargetChoice &choice = test.measurement.targetChoice;
    const auto &targets = test.measurement.targets;
    if (choice.kind != TargetChoiceKind::free || !choice.interval || targets.size() < 3)
        return std::nullopt;
    double low = targets.front();
    double high = low;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const double rest = targets[i] - static_cast<double>(i) * *choice.interval;
        low = std::min(low, rest);
        high = std::max(high, rest);
    }
    const double bound = choice.period ? *choice.period : 0.3 * *choice.interval;
    if (high - low <= 2 * bound * (1 + 1e-9))
        return std::nullopt;
    return Message{
        REPORT_TEXT("report",
                    "The targets leave their nominal interval of %1 by up to ± %2; the random part is "
                    "to stay within ± %3."),
        {along(test, *choice.interval), along(test, (high - low) / 2, 2), along(test, bound)}};
}

} // namespace palmer::iso230_2
