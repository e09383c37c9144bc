// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/diagnosis/synthesize.h"

#include "kernel/measurement/conditions.h"
#include "kernel/numerics/angles.h"
#include "kernel/numerics/points.h"
#include "kernel/simulation/randomdraws.h"

#include <cmath>
#include <numbers>

namespace palmer {

namespace {

/// Readings in chronological order, one stream per test.
class Noise {
public:
    explicit Noise(const SynthesizedNoise &asked)
        : m_asked(asked)
        , m_draws(asked.seed) {}

    /// Returns noise correlated between consecutive readings; a new record starts afresh.
    double next() {
        if (m_asked.deviation == 0)
            return 0;
        const double drawn = RandomDraws::normal(word());
        const double phi = m_asked.correlation;
        m_last = m_started ? phi * m_last + std::sqrt(1 - phi * phi) * drawn : drawn;
        m_started = true;
        return m_asked.deviation * m_last;
    }
    void startRecord() { m_started = false; }

    [[nodiscard]] double rounded(double reading) const {
        if (!(m_asked.resolution > 0))
            return reading;
        // 1e-5 is not exact as a double, 1e5 is: dividing gives the short decimals of the display.
        const double perUnit = 1 / m_asked.resolution;
        const double whole = std::nearbyint(perUnit);
        if (std::abs(perUnit - whole) <= 1e-9 * perUnit)
            return std::nearbyint(reading * whole) / whole;
        return std::nearbyint(reading / m_asked.resolution) * m_asked.resolution;
    }

private:
    std::uint32_t word() {
        constexpr std::uint32_t wordsOfDraw = 4;
        const std::uint32_t place = m_count / wordsOfDraw;
        return m_draws.words(0, place)[m_count++ % wordsOfDraw];
    }

    SynthesizedNoise m_asked;
    RandomDraws m_draws;
    std::uint32_t m_count = 0;
    double m_last = 0;
    bool m_started = false;
};

double columnsOf(const CircularSource &source, const PathPosition &position) {
    const Influence &row = influence(source.id);
    if (source.id != InfluenceId::cyclic)
        return source.value * row.column(position, source.axis, source.shape);
    return source.value * (std::cos(source.phase) * row.column(position, source.axis, source.shape) +
                           std::sin(source.phase) * row.second(position, source.axis, source.shape));
}

/// The centre is applied as a position: a column would be exact to first order only.
Point centreOf(const std::vector<CircularSource> &sources) {
    Point centre;
    for (const CircularSource &source : sources) {
        if (source.id == InfluenceId::centre)
            (source.axis == PlaneAxis::first ? centre.x : centre.y) += source.value;
    }
    return centre;
}

} // namespace

CircularMeasurement synthesizeCircular(const CircularSynthesis &asked) {
    CircularMeasurement measurement;
    measurement.plane = asked.plane;
    measurement.nominalRadius = asked.radius;
    measurement.feed = asked.feed;
    measurement.referenceLength.calibrated = true;
    const Point centre = centreOf(asked.sources);
    Noise noise(asked.noise);
    constexpr double secondsPerMinute = 60;
    const double extent = asked.arc.to - asked.arc.from;
    const auto arcs = static_cast<double>(asked.senses.size());
    const double whole = arcs * extent / 360 + (arcs - 1) * asked.pause;
    double turns = -whole / 2;
    for (const Sense sense : asked.senses) {
        noise.startRecord();
        Arc arc;
        arc.sense = sense;
        const double sign = sense == Sense::counterclockwise ? 1 : -1;
        const double start = sign > 0 ? asked.arc.from : asked.arc.to;
        for (std::size_t i = 0; i < asked.points; ++i) {
            const double travelled =
                (static_cast<double>(i) + 0.5) * extent / static_cast<double>(asked.points);
            const double angle = start + sign * travelled;
            const Point u = direction(angle);
            const PathPosition position{
                u.x, u.y, sign, asked.radius, asked.feed / secondsPerMinute, turns + travelled / 360};
            double deviation = 0;
            for (const CircularSource &source : asked.sources) {
                if (source.id != InfluenceId::centre)
                    deviation += columnsOf(source, position);
            }
            const double time = travelled * degree * asked.radius * secondsPerMinute / asked.feed;
            deviation +=
                asked.vibration.amplitude * std::sin(2 * std::numbers::pi * asked.vibration.frequency * time);
            const double r = asked.radius + deviation;
            const Point p{centre.x + r * u.x, centre.y + r * u.y};
            // The angle seen from the programmed centre, close to the one about the machine's own.
            const double turned = std::atan2(u.x * p.y - u.y * p.x, u.x * p.x + u.y * p.y);
            const bool centred = centre == Point{};
            arc.angles.push_back(centred ? angle : angle + turned / degree);
            const double distance = centred ? r : std::hypot(p.x, p.y);
            arc.radialDeviations.push_back(noise.rounded(distance - asked.radius + noise.next()));
        }
        turns += extent / 360 + asked.pause;
        measurement.arcs.push_back(std::move(arc));
    }
    return measurement;
}

PositioningMeasurement synthesizePositioning(const PositioningSynthesis &asked) {
    PositioningMeasurement measurement;
    measurement.axis.name = asked.axis;
    measurement.targets = asked.targets;
    const std::size_t count = asked.targets.size();
    if (count == 0)
        return measurement;
    const double first = asked.targets.front();
    const double travel = asked.targets.back() - first;
    Noise noise(asked.noise);
    const std::size_t readings = count * 2 * static_cast<std::size_t>(asked.runs);
    std::size_t taken = 0;
    constexpr double perMetreAndDegree = 1e-6;
    for (int run = 0; run < asked.runs; ++run) {
        for (const Direction approach : {Direction::positive, Direction::negative}) {
            Run one{approach, std::vector<std::optional<double>>(count)};
            const bool upward = approach == Direction::positive;
            for (std::size_t k = 0; k < count; ++k) {
                const std::size_t i = upward ? k : count - 1 - k;
                const double along = asked.targets[i] - first;
                double deviation = (asked.scale + asked.expansion * perMetreAndDegree *
                                                      (asked.temperature - referenceTemperature)) *
                                   along;
                deviation +=
                    asked.cyclic * std::sin(2 * std::numbers::pi * along / asked.pitch + asked.phase);
                const double lost = asked.backlash + asked.reversal * (travel > 0 ? along / travel : 0);
                deviation += upward ? -lost / 2 : lost / 2;
                if (readings > 1)
                    deviation += asked.drift * static_cast<double>(taken) / static_cast<double>(readings - 1);
                ++taken;
                one.deviations[i] = noise.rounded(deviation + noise.next());
            }
            measurement.runs.push_back(std::move(one));
        }
    }
    if (asked.temperature != referenceTemperature) {
        measurement.conditions.common.sensors.push_back(
            {SensorMeasures::machine, {}, asked.temperature, asked.temperature, {}});
        measurement.conditions.common.expansion.machine = asked.expansion;
    }
    return measurement;
}

DriftMeasurement synthesizeDrift(const DriftSynthesis &asked) {
    DriftMeasurement drift;
    const auto rows = static_cast<std::size_t>(std::floor(asked.length / asked.step)) + 1;
    DriftTemperature air{"air", {}, {}};
    for (std::size_t i = 0; i < rows; ++i) {
        drift.times.push_back(static_cast<double>(i) * asked.step);
        air.values.emplace_back(referenceTemperature +
                                asked.swing *
                                    std::sin(2 * std::numbers::pi * drift.times.back() / asked.period));
    }
    SynthesizedNoise seeded = asked.noise;
    for (const DriftChannelSynthesis &of : asked.channels) {
        Noise noise(seeded);
        ++seeded.seed; // independent for every channel
        DriftChannel channel{of.name, ChannelQuantity::deviation, {}};
        // Exact between temperatures that change linearly.
        const double q = asked.step / of.tau;
        const double kept = std::exp(-q);
        const double w = (1 - kept) / q;
        double y = *air.values.front();
        for (std::size_t i = 0; i < rows; ++i) {
            if (i > 0)
                y = kept * y + (w - kept) * *air.values[i - 1] + (1 - w) * *air.values[i];
            const double deviation = of.perDegree * (y - *air.values.front()) + of.slope * drift.times[i];
            channel.values.emplace_back(noise.rounded(deviation + noise.next()));
        }
        drift.channels.push_back(std::move(channel));
    }
    drift.axis.name = asked.channels.empty() ? std::string() : asked.channels.front().name;
    drift.temperatures.push_back(std::move(air));
    drift.settled = true;
    return drift;
}

} // namespace palmer
