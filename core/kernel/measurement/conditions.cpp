// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/measurement/conditions.h"

#include <algorithm>
#include <deque>

namespace palmer {

std::optional<double> startTemperature(const Sensor &sensor) {
    if (sensor.start)
        return sensor.start;
    if (sensor.series && !sensor.series->temperatures.empty())
        return sensor.series->temperatures.front();
    return std::nullopt;
}

std::optional<double> endTemperature(const Sensor &sensor) {
    if (sensor.end)
        return sensor.end;
    if (sensor.series && !sensor.series->temperatures.empty())
        return sensor.series->temperatures.back();
    return std::nullopt;
}

std::optional<double> meanTemperature(const Conditions &conditions, SensorMeasures what,
                                      std::optional<double> (*temperature)(const Sensor &)) {
    double sum = 0;
    int count = 0;
    for (const Sensor &sensor : conditions.sensors) {
        if (sensor.measures != what)
            continue;
        const auto value = temperature(sensor);
        if (!value)
            return std::nullopt;
        sum += *value;
        ++count;
    }
    return count > 0 ? std::optional(sum / count) : std::nullopt;
}

std::optional<double> meanTemperature(const Conditions &conditions, SensorMeasures what) {
    return meanTemperature(conditions, what, [](const Sensor &sensor) -> std::optional<double> {
        const auto start = startTemperature(sensor);
        const auto end = endTemperature(sensor);
        return start && end ? std::optional((*start + *end) / 2) : std::nullopt;
    });
}

std::optional<double> gradientPerHour(const TemperatureSeries &series) {
    const std::vector<double> &t = series.times;
    const std::vector<double> &value = series.temperatures;
    constexpr double hour = 3600;
    if (t.empty() || t.back() - t.front() < hour)
        return std::nullopt;
    // Extremes of a window that slides: indexes whose values fall (rise) from the front to the back.
    std::deque<std::size_t> highest;
    std::deque<std::size_t> lowest;
    double largest = 0;
    for (std::size_t i = 0; i < t.size(); ++i) {
        while (!highest.empty() && value[highest.back()] <= value[i])
            highest.pop_back();
        while (!lowest.empty() && value[lowest.back()] >= value[i])
            lowest.pop_back();
        highest.push_back(i);
        lowest.push_back(i);
        while (t[i] - t[highest.front()] > hour)
            highest.pop_front();
        while (t[i] - t[lowest.front()] > hour)
            lowest.pop_front();
        largest = std::max(largest, value[highest.front()] - value[lowest.front()]);
    }
    return largest;
}

} // namespace palmer
