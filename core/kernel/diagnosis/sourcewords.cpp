// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/diagnosis/sourcewords.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>

namespace palmer {

namespace {

/// %1 is the axis (for the plane: the first), %2 the other one.
struct Words {
    InfluenceId id = InfluenceId::centre;
    Text positive;
    Text negative;
    Text advice;
    Text negativeAdvice = {}; ///< empty: the same
};

const std::array words{
    Words{InfluenceId::scaleMismatch,
          REPORT_TEXT("report", "%1 travels farther than %2: %1 is long or %2 short."),
          REPORT_TEXT("report", "%1 travels less far than %2: %1 is short or %2 long."),
          REPORT_TEXT("report", "Compare the scales, the pitch compensation and the temperatures of %1 and "
                                "%2.")},
    Words{InfluenceId::squareness, REPORT_TEXT("report", "The angle from +%1 to +%2 is larger than 90°."),
          REPORT_TEXT("report", "The angle from +%1 to +%2 is smaller than 90°."),
          REPORT_TEXT("report", "Check guideways and levelling, then the squareness compensation.")},
    Words{InfluenceId::servoMismatch, REPORT_TEXT("report", "%1 follows later than %2."),
          REPORT_TEXT("report", "%2 follows later than %1."),
          REPORT_TEXT("report", "Match the position gains (Kv) of %1 and %2; the effect grows with the "
                                "feed.")},
    Words{InfluenceId::backlash, REPORT_TEXT("report", "%1 loses motion at each reversal."),
          REPORT_TEXT("report", "%1 moves too far at each reversal: its backlash is compensated too much."),
          REPORT_TEXT("report", "Check screw, bearings and coupling of %1, then its backlash compensation."),
          REPORT_TEXT("report", "Reduce the backlash compensation of %1.")},
    Words{InfluenceId::lateralPlay,
          REPORT_TEXT("report", "%1 steps aside at each reversal: towards +%2 while it moves towards +."),
          REPORT_TEXT("report", "%1 steps aside at each reversal: towards −%2 while it moves towards +."),
          REPORT_TEXT("report", "Check gibs, guide shoes and preload of %1.")},
    Words{InfluenceId::straightness, REPORT_TEXT("report", "%1 runs on a bow: its ends lie towards +%2."),
          REPORT_TEXT("report", "%1 runs on a bow: its ends lie towards −%2."),
          REPORT_TEXT("report", "Check guideway, supports and levelling of %1.")},
    Words{InfluenceId::reversalSpike,
          REPORT_TEXT("report", "%1 sticks when it reverses: the path bulges outwards and comes back."),
          REPORT_TEXT("report", "%1 jumps when it reverses: the path dents inwards and comes back."),
          REPORT_TEXT("report", "Check lubrication and friction of %1, then its friction compensation."),
          REPORT_TEXT("report", "Reduce the friction compensation of %1.")},
    Words{InfluenceId::cyclic,
          REPORT_TEXT("report", "%1 deviates periodically along its travel."),
          {},
          REPORT_TEXT("report",
                      "The pitch tells whether the screw, the rack or the measuring system of %1 is "
                      "at fault.")},
    Words{InfluenceId::commonLag, REPORT_TEXT("report", "%1 and %2 lag: the circle shrinks with the feed."),
          REPORT_TEXT("report", "%1 and %2 overshoot: the circle grows with the feed."),
          REPORT_TEXT("report", "Check the feed-forward and the position gains of %1 and %2.")},
    Words{InfluenceId::lagMismatch,
          REPORT_TEXT("report", "%1 loses more of its stroke with the feed than %2."),
          REPORT_TEXT("report", "%2 loses more of its stroke with the feed than %1."),
          REPORT_TEXT("report", "Check the feed-forward and the position gains of %1 and %2.")},
    Words{InfluenceId::radiusDrift, REPORT_TEXT("report", "The circle grows during the test."),
          REPORT_TEXT("report", "The circle shrinks during the test."),
          REPORT_TEXT("report", "Check warm-up and temperatures of machine and instrument.")},
};

const Words *wordsOf(InfluenceId id) {
    const auto *const found = std::ranges::find(words, id, &Words::id);
    return found == words.end() ? nullptr : &*found;
}

/// Returns the axis and the other one; for the plane both in order.
std::vector<Argument> axesOf(const std::string &first, const std::string &second, PlaneAxis axis) {
    if (axis == PlaneAxis::second)
        return {second, first};
    return {first, second};
}

bool isKnown(const SourceEstimate *source) {
    return source && source->value && source->u && std::abs(*source->value) > 5 * *source->u;
}

/// True for opposite and equal lateral play of both axes, like a radius that changed between the arcs.
bool looksLikeStep(const Diagnosis &diagnosis) {
    const SourceEstimate *first = diagnosis.find(InfluenceId::lateralPlay, PlaneAxis::first);
    const SourceEstimate *second = diagnosis.find(InfluenceId::lateralPlay, PlaneAxis::second);
    const SourceEstimate *drift = diagnosis.find(InfluenceId::radiusDrift);
    if (!isKnown(first) || !isKnown(second) || (drift && drift->step))
        return false;
    constexpr double alike = 0.2;
    return std::abs(*first->value + *second->value) < alike * std::abs(*first->value);
}

bool isOneSense(const DiagnosedCircle &circle) {
    return std::ranges::all_of(
        circle.arcs, [&](const DiagnosedArc &arc) { return arc.sense == circle.arcs.front().sense; });
}

} // namespace

Message sourceName(const SourceEstimate &source) {
    return {influence(source.id).name, {source.axisName}};
}

Message summandName(const Diagnosis &diagnosis, const SourceSum::Part &part) {
    const SourceEstimate &source = diagnosis.sources[part.source];
    if (part.unit == std::string_view(influence(source.id).unit))
        return sourceName(source);
    return {source.id == InfluenceId::commonLag
                ? REPORT_TEXT("report", "(Common lag %1)²")
                : REPORT_TEXT("report", "Difference of following errors %1, in µm"),
            {source.axisName}};
}

Message sourceMeaning(const Diagnosis &diagnosis, const SourceEstimate &source) {
    if (!source.separable)
        return source.with.empty()
                   ? Message{REPORT_TEXT("report", "These arcs hardly tell it.")}
                   : Message{REPORT_TEXT("report", "These arcs do not tell it from other sources.")};
    const Words *row = wordsOf(source.id);
    if (!row)
        return {REPORT_TEXT("report", "Taken out before any deviation is stated.")};
    const auto interval = source.interval();
    if (interval && interval->from <= 0 && interval->to >= 0)
        return {REPORT_TEXT("report", "Not seen: its 95 % interval contains zero.")};
    if (interval && !source.isSeen())
        return {REPORT_TEXT("report", "Not certain: its 99.9 % interval contains zero.")};
    if (source.indication && !isKnown(&source))
        return {REPORT_TEXT("report", "Not seen: too small to be told from the rest.")};
    const bool negative = source.fitted[0] < 0 && !row->negative.empty();
    return {negative ? row->negative : row->positive, axesOf(diagnosis.first, diagnosis.second, source.axis)};
}

Message positiveMeaning(const Diagnosis &diagnosis, const SourceEstimate &source) {
    const Words *row = wordsOf(source.id);
    if (!row)
        return {};
    return {row->positive, axesOf(diagnosis.first, diagnosis.second, source.axis)};
}

Message sourceAdvice(const Diagnosis &diagnosis, const SourceEstimate &source) {
    const Words *row = wordsOf(source.id);
    if (!row)
        return {};
    const bool negative = source.fitted[0] < 0 && !row->negativeAdvice.empty();
    return {negative ? row->negativeAdvice : row->advice,
            axesOf(diagnosis.first, diagnosis.second, source.axis)};
}

std::string sourceId(const SourceEstimate &source) {
    return std::string(influence(source.id).word) +
           (source.axis == PlaneAxis::none ? std::string() : ":" + source.axisName);
}

std::optional<Message> rotationStatement(const Rotation &rotation) {
    if (!rotation.isStated())
        return std::nullopt;
    return Message{
        rotation.commanded
            ? REPORT_TEXT("report",
                          "The reversal steps lie %1 ± %2 off the axes: check the start angle. Spikes "
                          "and periodic deviations are not shown until this is settled.")
            : REPORT_TEXT("report",
                          "The reversal steps lie %1 ± %2 off the axes: the measuring system is turned "
                          "against them. Spikes and periodic deviations are not shown until this is "
                          "settled."),
        {Number{*rotation.angle, Quantity::angle, 2}, Number{rotation.bound, Quantity::angle, 2}}};
}

std::vector<Message> diagnosisRemarks(std::span<const DiagnosedCircle> circles,
                                      const DiagnosisOptions &options, const Diagnosis &diagnosis) {
    std::vector<Message> result;
    if (std::ranges::all_of(circles, isOneSense))
        result.push_back(
            {REPORT_TEXT("report", "One sense only: squareness and servo mismatch cannot be told "
                                   "apart.")});
    if (circles.front().feedback)
        result.push_back({REPORT_TEXT("report", "Feedback signal: what the machine does beyond its scales is "
                                                "not seen.")});
    if (!circles.front().feed)
        result.push_back(
            {REPORT_TEXT("report", "The contouring feed is not stated: the servo mismatch has no "
                                   "value.")});
    if (diagnosis.lagAngle != 0)
        result.push_back({REPORT_TEXT("report", "The path lies %1 behind the commanded angles."),
                          {Number{diagnosis.lagAngle, Quantity::angle, 2}}});
    const SourceEstimate *drift = diagnosis.find(InfluenceId::radiusDrift);
    if (drift && drift->step && !options.pause)
        result.push_back(
            {REPORT_TEXT("report", "The pause between the arcs is not known: with the drift a "
                                   "step of the radius between the senses is fitted, and lateral "
                                   "play is less certain for it.")});
    if (looksLikeStep(diagnosis))
        result.push_back(
            {REPORT_TEXT("report", "Lateral play of both axes, opposite and alike: a radius that "
                                   "differs by δ between the senses looks the same (−0.78 δ and "
                                   "+0.78 δ).")});
    if (circles.size() > 1) {
        std::set<double> feeds;
        for (const DiagnosedCircle &circle : circles)
            feeds.insert(std::round(circle.feed.value_or(0) * 1e3));
        if (feeds.size() == 2)
            result.push_back({REPORT_TEXT("report", "Two feeds: nothing checks that the lag grows with the "
                                                    "square of the feed; a third one would.")});
    }
    return result;
}

} // namespace palmer
