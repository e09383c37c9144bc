// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/diagnosis/remarks.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace palmer {

namespace {

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
