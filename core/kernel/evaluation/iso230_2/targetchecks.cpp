// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/agreedpoints.h"
#include "kernel/evaluation/iso230_2/checks.h"
#include "kernel/evaluation/iso230_2/sentences.h"
#include "kernel/evaluation/iso230_2/targetrules.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palmer::iso230_2 {

namespace {

std::size_t targetCount(const PositioningCase &test) {
    return test.measurement.targets.size();
}

/// The same as int, for a counted sentence.
int numberOfTargets(const PositioningCase &test) {
    return static_cast<int>(targetCount(test));
}

double zoneOfStandard(const PositioningCase &test) {
    return longestShort(test.measurement.axis.motion);
}

bool intervalsTooLong(const PositioningCase &test) {
    const std::size_t m = targetCount(test);
    return m < 2 ||
           measurementTravel(test.measurement) > longestInterval * static_cast<double>(m - 1) * (1 + 1e-9);
}

double leftOut(const PositioningCase &test) {
    return test.travel() - measurementTravel(test.measurement);
}

/// Returns the length of the agreed zone if it differs from that of the standard.
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

/// True if each whole element between the ends of the axis (or the outer targets) contains a target. Elements
/// count from the lower end, as their true start is unknown.
bool everyElementHasTarget(const PositioningCase &test, double element) {
    const auto &targets = test.measurement.targets;
    if (targets.empty())
        return false;
    const auto &range = test.measurement.axis.range;
    const double from = range ? range->from : targets.front();
    const double to = range ? range->to : targets.back();
    const double count = std::floor((to - from) / element + 1e-9);
    if (count > static_cast<double>(targets.size()))
        return false;
    double next = 0; // first element without a target so far
    for (const double target : targets) {
        const double index = std::floor((target - from) / element + 1e-9);
        if (index > next)
            return next >= count;
        if (index == next)
            ++next;
    }
    return next >= count;
}

Sentence meanIntervalWhere(const PositioningCase &test, bool tooLong) {
    if (!tooLong)
        return std::nullopt;
    return Message{
        REPORT_TEXT_COUNTED("report", "%n target(s) over %1: a long axis has a target in each element of its "
                                      "measuring system or every 250 mm."),
        {along(test, measurementTravel(test.measurement))},
        numberOfTargets(test)};
}

/// True if the ends are stated, or equal those of a measurement travel that covers the stated axis travel.
bool endsKnown(const PositioningCase &test) {
    const Axis &axis = test.measurement.axis;
    return axis.range || (axis.travel && std::abs(measurementTravel(test.measurement) - *axis.travel) <=
                                             1e-9 * *axis.travel);
}

Judgement endsNotDeclared() {
    return {State::undeclared, {}, REPORT_TEXT("report", "ends of the axis")};
}

/// Returns the quarter turns within `reach` that have no target.
NameList quartersWithoutTarget(const std::vector<double> &targets, const Interval &reach) {
    NameList missing;
    for (const double quarter : {0.0, 90.0, 180.0, 270.0}) {
        const auto atQuarter = [quarter](double position) { return isAtQuarter(position, quarter); };
        const double first = quarter + 360 * std::ceil((reach.from - quarter) / 360);
        if (first <= reach.to && std::ranges::none_of(targets, atQuarter))
            missing.add(std::to_string(static_cast<int>(quarter)) + "°");
    }
    return missing;
}

/// Undeclared if the choice of targets or the cyclic pitch is not stated.
Judgement choiceMissing(const TargetChoice &choice) {
    static constexpr std::array<Text, 3> names{Text{}, REPORT_TEXT("report", "choice of targets"),
                                               REPORT_TEXT("report", "cyclic pitch")};
    return Judgement::lacking(
        State::undeclared,
        missingOf(choice.kind != TargetChoiceKind::notStated, choice.period && *choice.period > 0), names);
}

/// Returns the interval whose multiples fit the targets best: the spread is convex in it.
double bestInterval(std::span<const double> targets) {
    double low = 0;
    double high = targets.back() - targets.front();
    for (int step = 0; step < 200; ++step) {
        const double a = low + (high - low) / 3;
        const double b = high - (high - low) / 3;
        const bool below = spreadAbout(targets, a) <= spreadAbout(targets, b);
        (below ? high : low) = below ? b : a;
    }
    return (low + high) / 2;
}

} // namespace

Sentence targetsPerMetre(const PositioningCase &test) {
    const double needed = targetsOfAMetre * test.judgedTravel() / 1000;
    if (static_cast<double>(targetCount(test)) >= needed - 1e-9)
        return std::nullopt;
    return Message{
        REPORT_TEXT_COUNTED("report", "%n target(s) over %1: at least 5 per metre are required, %2 here."),
        {along(test, test.judgedTravel()), count(static_cast<std::size_t>(std::ceil(needed - 1e-9)))},
        numberOfTargets(test)};
}

Sentence fiveTargets(const PositioningCase &test) {
    if (static_cast<double>(targetCount(test)) >= fewestTargets)
        return std::nullopt;
    return Message{REPORT_TEXT("report", "Number of targets: %1; at least 5 are required."),
                   {count(targetCount(test))}};
}

Judgement elements(const PositioningCase &test) {
    const auto &element = test.measurement.axis.scaleElement;
    if (!element)
        return Judgement::undeclared();
    if (*element > 0 ? everyElementHasTarget(test, *element) : !intervalsTooLong(test))
        return *element > 0 && !endsKnown(test) ? endsNotDeclared() : Judgement::met();
    return Judgement::unmet(*meanIntervalWhere(test, true));
}

Sentence meanInterval(const PositioningCase &test) {
    return meanIntervalWhere(test, intervalsTooLong(test));
}

Sentence wholeLength(const PositioningCase &test) {
    if (leftOut(test) <= 2 * longestInterval)
        return std::nullopt;
    return Message{REPORT_TEXT("report",
                               "The targets leave out %1 of the axis travel of %2: neither the whole travel "
                               "nor a test inside the agreed zone."),
                   {along(test, leftOut(test)), along(test, test.travel())}};
}

Judgement quarterTurns(const PositioningCase &test) {
    constexpr Interval turn{0, 359.999};
    const auto &targets = test.measurement.targets;
    const auto &range = test.measurement.axis.range;
    // A tilting axis has limited reach: only quarters within it are required. If its ends are unknown, the
    // reach is at least the range of the targets.
    const bool wholeTurn = !range && test.measurement.axis.travel.value_or(0) >= turn.to;
    const Interval covered = targets.empty() ? turn : Interval{targets.front(), targets.back()};
    const NameList missing = quartersWithoutTarget(targets, range ? *range : wholeTurn ? turn : covered);
    if (missing.empty())
        return endsKnown(test) || quartersWithoutTarget(targets, turn).empty() ? Judgement::met()
                                                                               : endsNotDeclared();
    return Judgement::unmet(
        {REPORT_TEXT("report", "A rotary axis is tested at 0°, 90°, 180° and 270° or at the faces "
                               "of the polygon; missing: %1."),
         {missing.text()}});
}

Sentence targetsOfTravel(const PositioningCase &test) {
    const double travel = test.judgedTravel();
    const double needed = targetsWithinATurn(travel);
    if (static_cast<double>(targetCount(test)) >= needed)
        return std::nullopt;
    return Message{REPORT_TEXT_COUNTED("report", "%n target(s) over %1: practice asks for at least %2."),
                   {along(test, travel), Number{needed, Quantity::count, 0}},
                   numberOfTargets(test)};
}

Sentence targetsPerTurn(const PositioningCase &test) {
    const double turns = std::min(measurementTravel(test.measurement), 1800.0) / 360;
    if (targetCount(test) >= 2 && static_cast<double>(targetCount(test)) >= targetsOfATurn * turns - 1e-9)
        return std::nullopt;
    return Message{
        REPORT_TEXT_COUNTED("report",
                            "%n target(s) over %1: practice asks for at least 8 per turn, up to 1 800°."),
        {along(test, measurementTravel(test.measurement))},
        numberOfTargets(test)};
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

Judgement endsOf2006(const PositioningCase &test) {
    static constexpr std::array<Text, 3> names{Text{}, REPORT_TEXT("report", "ends of the axis"),
                                               REPORT_TEXT("report", "approach distance")};
    if (auto wrong = ends(test))
        return Judgement::unmet(std::move(*wrong));
    return Judgement::lacking(
        State::undeclared,
        missingOf(test.measurement.axis.range.has_value(), test.conditions().approachDistance.has_value()),
        names);
}

Sentence endsUnknown(const PositioningCase &test) {
    return sentenceIf(
        !test.measurement.axis.range,
        REPORT_TEXT("report",
                    "The ends of the axis are not stated: whether the first and the last target can be "
                    "approached from both sides is not checked."));
}

Judgement axisTravel(const PositioningCase &test) {
    const auto &stated = test.measurement.axis.travel;
    if (!stated)
        return Judgement::undeclared();
    const double measured = measurementTravel(test.measurement);
    if (measured > *stated * (1 + 1e-9))
        return Judgement::unmet(
            {REPORT_TEXT("report",
                         "The stated axis travel of %1 is contradicted by the targets, which lie over %2: "
                         "this is judged."),
             {along(test, *stated), along(test, measured)}});
    const auto &range = test.measurement.axis.range;
    if (!range || !test.linear())
        return Judgement::met();
    const double apart = range->to - range->from; // longer than the travel by what the axis can overrun
    if (*stated > apart * (1 + 1e-9))
        return Judgement::unmet({REPORT_TEXT("report", "The stated axis travel of %1 is contradicted by the "
                                                       "stated ends of the axis, which lie %2 apart."),
                                 {along(test, *stated), along(test, apart)}});
    const auto &targets = test.measurement.targets;
    const bool outside = !targets.empty() && (targets.front() < range->from || targets.back() > range->to);
    const bool oneWay = test.positiveRuns == 0 || test.negativeRuns == 0; // else `ends` finds them
    return Judgement::of(sentenceIf(
        outside && oneWay,
        REPORT_TEXT("report", "The stated ends of the axis are contradicted by targets beyond them.")));
}

Judgement zone(const PositioningCase &test) {
    if (auto wrong = zoneLength(test))
        return Judgement::unmet(std::move(*wrong));
    const AgreedPoint *agreed = agreedPoint(test.test, "zone");
    if (!agreed)
        return Judgement::undeclared();
    return agreed->state == AgreementState::agreed ? Judgement::met() : Judgement::unmet();
}

Judgement freeTargets(const PositioningCase &test) {
    if (!test.conditions().continuousDevice)
        return Judgement::undeclared();
    return furtherTargets(test.measurement.targets) >= fewestFurther ? Judgement::met() : Judgement::unmet();
}

Judgement polygonFaces(const PositioningCase &test) {
    const auto &faces = test.measurement.targetChoice.faces;
    if (!faces)
        return Judgement::undeclared();
    if (*faces == static_cast<int>(targetCount(test)))
        return Judgement::met();
    return Judgement::unmet({REPORT_TEXT_COUNTED("report", "%n target(s), %1 faces."),
                             {Number{static_cast<double>(*faces), Quantity::count, 0}},
                             numberOfTargets(test)});
}

Judgement choiceOf1988(const PositioningCase &test) {
    const TargetChoice &choice = test.measurement.targetChoice;
    const auto &targets = test.measurement.targets;
    if (Judgement missing = choiceMissing(choice); missing.state)
        return missing;
    if (!samePhase(targets, *choice.period))
        return Judgement::met();
    return Judgement::unmet({REPORT_TEXT("report", "All targets have the same phase of the pitch %1."),
                             {along(test, *choice.period)}});
}

namespace {

/// Returns the range to be covered: the agreed zone of a long axis, otherwise the whole axis.
std::optional<Interval> covered(const PositioningCase &test) {
    return test.longAxis() ? test.measurement.zone : test.measurement.axis.range;
}

/// First and last target within two mean steps of the ends of the axis; if the ends are not stated, only
/// their distance is known.
Judgement reachesEnds(const PositioningCase &test) {
    const auto &targets = test.measurement.targets;
    const double most = 2 * meanStep(targets) * (1 + 1e-9);
    if (const auto &reach = covered(test)) {
        const double before = targets.front() - reach->from;
        const double behind = reach->to - targets.back();
        if (before <= most && behind <= most)
            return Judgement::met();
        return Judgement::unmet(
            {REPORT_TEXT("report", "The axis goes on for %1 before the first target and %2 behind the last, "
                                   "more than two mean steps of %3."),
             {along(test, before), along(test, behind), along(test, meanStep(targets), 2)}});
    }
    const auto &travel = test.measurement.axis.travel;
    if (test.longAxis())
        return Judgement::met(); // the zone has its own row
    const double measured = measurementTravel(test.measurement);
    if (!travel || *travel < measured * (1 - 1e-9)) // contradicted by the targets
        return Judgement::undeclared();
    const double rest = *travel - measured;
    if (rest > 2 * most)
        return Judgement::unmet(
            {REPORT_TEXT("report", "The axis goes on for %1 beyond the first and the last target, more than "
                                   "four mean steps of %2."),
             {along(test, rest), along(test, meanStep(targets), 2)}});
    return rest > most ? Judgement::undeclared() : Judgement::met();
}

} // namespace

Judgement spacing(const PositioningCase &test) {
    const auto &targets = test.measurement.targets;
    if (targets.size() < 2)
        return Judgement::met();
    const auto &period = test.measurement.targetChoice.period;
    const std::vector<double> all = steps(test);
    if (!spacedAsOf1988(targets, period)) {
        const auto [least, largest] = std::ranges::minmax(all);
        return Judgement::unmet({REPORT_TEXT("report", "Steps between targets from %1 to %2."),
                                 {along(test, least), along(test, largest)}});
    }
    Judgement ends = reachesEnds(test);
    if (ends.state == State::unmet)
        return ends;
    // If the period is unknown, unequal steps may differ by more than two periods.
    const bool anyPeriod = (period && *period > 0) || evenlySpaced(targets);
    return anyPeriod ? ends : Judgement::undeclared();
}

Sentence coverage(const PositioningCase &test) {
    const Axis &axis = test.measurement.axis;
    std::optional<double> travel = axis.travel;
    if (!travel && axis.range)
        travel = axis.range->to - axis.range->from;
    if (!travel && !test.linear())
        travel = 360;
    constexpr double half = 0.5;
    if (!travel || test.measurement.zone || !(measurementTravel(test.measurement) < half * *travel))
        return std::nullopt;
    return Message{REPORT_TEXT("report", "The test covers %1 % of the travel of the axis."),
                   {Number{100 * measurementTravel(test.measurement) / *travel, Quantity::number, 0}}};
}

Judgement choiceOf2006(const PositioningCase &test) {
    const TargetChoice &choice = test.measurement.targetChoice;
    const auto &targets = test.measurement.targets;
    if (choice.kind == TargetChoiceKind::notStated)
        return choiceMissing(choice);
    const bool periodic = choice.period && *choice.period > 0;
    if (periodic && stepsOfWholePeriods(targets, *choice.period))
        return Judgement::unmet(
            {REPORT_TEXT("report",
                         "All intervals are whole multiples of the period of %1: its periodic error "
                         "stays hidden."),
             {along(test, *choice.period)}});
    if (targets.size() < 3)
        return Judgement::met();
    const double interval = choice.interval ? *choice.interval : bestInterval(targets);
    const double bound = boundOf2006(interval, choice.period);
    const double width = spreadAbout(targets, interval);
    if (staysWithin(width, bound, interval))
        return Judgement::met();
    return Judgement::unmet(
        {REPORT_TEXT("report",
                     "Target spacing differs from the nominal %1 by up to %2; the random part is to stay "
                     "within ± %3."),
         {along(test, interval, choice.interval ? -1 : 2), along(test, width / 2, 2),
          along(test, bound, periodic || choice.interval ? -1 : 2)}});
}

Sentence evenSpacing(const PositioningCase &test) {
    const TargetChoice &choice = test.measurement.targetChoice;
    const auto &targets = test.measurement.targets;
    if (choice.kind != TargetChoiceKind::free || (choice.period && *choice.period > 0) ||
        !evenlySpaced(targets))
        return std::nullopt;
    return Message{REPORT_TEXT("report",
                               "The targets are evenly spaced (%1): with a new random part for every target "
                               "periodic errors do not stay hidden."),
                   {along(test, meanStep(targets), 2)}};
}

} // namespace palmer::iso230_2
