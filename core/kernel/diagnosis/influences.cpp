// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/diagnosis/influences.h"

#include "kernel/numerics/angles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

namespace palmer {

namespace {

// Signs and factors: the radial deviation is dx·cos θ + dy·sin θ with (dx, dy) the actual minus the commanded
// position; the axes move with vx = −s·F·sin θ, vy = s·F·cos θ.

double cosTwo(const PathPosition &p) {
    return (p.cosine - p.sine) * (p.cosine + p.sine);
}

double sinTwo(const PathPosition &p) {
    return 2 * p.sine * p.cosine;
}

bool isFirst(PlaneAxis axis) {
    return axis == PlaneAxis::first;
}

/// a·cos θ + b·sin θ
double centre(const PathPosition &p, PlaneAxis axis, double) {
    return isFirst(axis) ? p.cosine : p.sine;
}

double radius(const PathPosition &, PlaneAxis, double) {
    return 1;
}

/// k_first − k_second
double scaleMismatch(const PathPosition &p, PlaneAxis, double) {
    return p.radius / 2 * cosTwo(p);
}

/// β = angle(+first, +second) − 90°
double squareness(const PathPosition &p, PlaneAxis, double) {
    return -p.radius / 2 * sinTwo(p);
}

/// Δτ = τ_first − τ_second, positive: the first axis lags
double servoMismatch(const PathPosition &p, PlaneAxis, double) {
    return p.sense * p.feed / 2 * sinTwo(p);
}

double signOf(double value) {
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/// B > 0: lost motion, a step outwards
double backlash(const PathPosition &p, PlaneAxis axis, double) {
    return isFirst(axis) ? p.sense / 2 * signOf(p.sine) * p.cosine : -p.sense / 2 * signOf(p.cosine) * p.sine;
}

/// L > 0: the carriage is offset towards + of the other axis while its own axis moves towards +
double lateralPlay(const PathPosition &p, PlaneAxis axis, double) {
    return isFirst(axis) ? -p.sense / 2 * std::abs(p.sine) : p.sense / 2 * std::abs(p.cosine);
}

/// σ, peak to valley of a bow over the diameter; σ > 0: both ends towards + of the other axis. Its first
/// harmonic is a shift of the centre.
double straightness(const PathPosition &p, PlaneAxis axis, double) {
    const double sinThree = p.sine * (3 - 4 * p.sine * p.sine);
    const double cosThree = p.cosine * (4 * p.cosine * p.cosine - 3);
    return isFirst(axis) ? sinThree / 4 : -cosThree / 4;
}

/// S > 0: outwards, decaying with the width
double spike(const PathPosition &p, PlaneAxis axis, double width) {
    return std::exp(-sinceReversal(p, axis) / width);
}

/// Change of a spike with its width, per degree
double spikeByWidth(const PathPosition &p, PlaneAxis axis, double width) {
    const double since = sinceReversal(p, axis);
    return since / (width * width) * std::exp(-since / width);
}

/// Phase 0 at the centre of the circle: C·sin(2πx/p + φ) has C·cos φ here and C·sin φ in the next column
double cyclic(const PathPosition &p, PlaneAxis axis, double pitch) {
    const double along = isFirst(axis) ? p.cosine : p.sine;
    return std::sin(2 * std::numbers::pi * p.radius * along / pitch) * along;
}

double cyclicAcross(const PathPosition &p, PlaneAxis axis, double pitch) {
    const double along = isFirst(axis) ? p.cosine : p.sine;
    return std::cos(2 * std::numbers::pi * p.radius * along / pitch) * along;
}

/// q, mean of both axes: a following axis with that lag travels 1 − q·ω²/2 of its stroke
double commonLag(const PathPosition &p, PlaneAxis, double) {
    return -p.feed * p.feed / (2 * p.radius);
}

/// q_first − q_second
double lagMismatch(const PathPosition &p, PlaneAxis, double) {
    return -p.feed * p.feed / (4 * p.radius) * cosTwo(p);
}

double radiusDrift(const PathPosition &p, PlaneAxis, double) {
    return p.turns;
}

/// A step of the radius between the senses, halved: effect of the drift during a pause of unknown length
double stepBetweenSenses(const PathPosition &p, PlaneAxis, double) {
    return p.sense / 2;
}

constexpr double micro = 1e6;
constexpr double milli = 1e3;

// clang-format off
const std::array influenceRows{
    Influence{InfluenceId::centre, "centre", REPORT_TEXT("report", "Centre %1"), true, "µm", milli, centre},
    Influence{InfluenceId::radius, "radius", REPORT_TEXT("report", "Radius, mean scale"), false, "µm", milli,
              radius},
    Influence{InfluenceId::scaleMismatch, "scaleMismatch", REPORT_TEXT("report", "Scale mismatch %1"), false,
              "µm/m", micro, scaleMismatch},
    Influence{InfluenceId::squareness, "squareness", REPORT_TEXT("report", "Squareness %1"), false, "µrad",
              micro, squareness},
    Influence{InfluenceId::servoMismatch, "servoMismatch", REPORT_TEXT("report", "Servo mismatch %1"), false,
              "ms", milli, servoMismatch},
    Influence{InfluenceId::backlash, "backlash", REPORT_TEXT("report", "Backlash %1"), true, "µm", milli,
              backlash},
    Influence{InfluenceId::lateralPlay, "lateralPlay", REPORT_TEXT("report", "Lateral play %1"), true, "µm",
              milli, lateralPlay},
    Influence{InfluenceId::straightness, "straightness", REPORT_TEXT("report", "Straightness %1"), true, "µm",
              milli, straightness},
    Influence{InfluenceId::reversalSpike, "reversalSpike", REPORT_TEXT("report", "Reversal spike %1"), true,
              "µm", milli, spike, spikeByWidth},
    Influence{InfluenceId::cyclic, "cyclic", REPORT_TEXT("report", "Periodic deviation %1"), true, "µm",
              milli, cyclic, cyclicAcross},
    Influence{InfluenceId::commonLag, "commonLag", REPORT_TEXT("report", "Common lag %1"), false, "ms", milli,
              commonLag},
    Influence{InfluenceId::lagMismatch, "lagMismatch", REPORT_TEXT("report", "Mismatch of the lags %1"),
              false, "ms²", micro, lagMismatch},
    Influence{InfluenceId::radiusDrift, "radiusDrift", REPORT_TEXT("report", "Drift of the radius"), false,
              "µm/turn", milli, radiusDrift, stepBetweenSenses},
};
// clang-format on

} // namespace

std::span<const Influence> influences() {
    return influenceRows;
}

const Influence &influence(InfluenceId id) {
    return influenceRows[static_cast<std::size_t>(id)];
}

const Influence *findInfluence(const char *word) {
    const auto *const found = std::ranges::find(influenceRows, std::string_view(word),
                                                [](const Influence &row) { return row.word; });
    return found == influenceRows.end() ? nullptr : &*found;
}

double sinceReversal(const PathPosition &position, PlaneAxis axis) {
    const double along = isFirst(axis) ? position.cosine : position.sine;
    const double across = isFirst(axis) ? position.sine : -position.cosine;
    const double angle = position.sense * std::atan2(across, along) / degree;
    return angle < 0 ? angle + 180 : angle >= 180 ? angle - 180 : angle;
}

double shownParameter(InfluenceId id, double value) {
    const double linear =
        id == InfluenceId::commonLag ? std::copysign(std::sqrt(std::abs(value)), value) : value;
    return linear * influence(id).unitsPerBase;
}

double baseParameter(InfluenceId id, double shown) {
    const double linear = shown / influence(id).unitsPerBase;
    return id == InfluenceId::commonLag ? linear * std::abs(linear) : linear;
}

} // namespace palmer
