// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/measurement/conditions.h"

#include <algorithm>
#include <deque>
#include <utility>

namespace palmer {

namespace {

double temperatureAt(const TemperatureSeries &series, std::vector<double>::const_iterator time) {
    return series.temperatures[static_cast<std::size_t>(time - series.times.begin())];
}

/// Returns the series sorted by time.
TemperatureSeries inOrder(const TemperatureSeries &series) {
    std::vector<std::pair<double, double>> both;
    for (std::size_t i = 0; i < series.times.size(); ++i)
        both.emplace_back(series.times[i], series.temperatures[i]);
    std::ranges::stable_sort(both, {}, &std::pair<double, double>::first);
    TemperatureSeries result;
    for (const auto &[time, temperature] : both) {
        result.times.push_back(time);
        result.temperatures.push_back(temperature);
    }
    return result;
}

} // namespace

std::optional<double> startTemperature(const Sensor &sensor) {
    if (sensor.start || !sensor.series || sensor.series->temperatures.empty())
        return sensor.start;
    return temperatureAt(*sensor.series, std::ranges::minmax_element(sensor.series->times).min);
}

std::optional<double> endTemperature(const Sensor &sensor) {
    if (sensor.end || !sensor.series || sensor.series->temperatures.empty())
        return sensor.end;
    return temperatureAt(*sensor.series, std::ranges::minmax_element(sensor.series->times).max);
}

std::optional<double> statedTemperature(const Conditions &conditions, SensorMeasures what,
                                        std::optional<double> (*temperature)(const Sensor &)) {
    double sum = 0;
    int count = 0;
    for (const Sensor &sensor : conditions.sensors) {
        const auto value = sensor.measures == what ? temperature(sensor) : std::nullopt;
        sum += value.value_or(0);
        count += value ? 1 : 0;
    }
    return count > 0 ? std::optional(sum / count) : std::nullopt;
}

std::optional<double> meanTemperature(const Conditions &conditions, SensorMeasures what,
                                      std::optional<double> (*temperature)(const Sensor &)) {
    const bool open = std::ranges::any_of(conditions.sensors, [&](const Sensor &sensor) {
        return sensor.measures == SensorMeasures::notStated || // it may measure `what`
               (sensor.measures == what && !temperature(sensor));
    });
    return open ? std::nullopt : statedTemperature(conditions, what, temperature);
}

std::optional<double> sensorTemperature(const Sensor &sensor) {
    const auto start = startTemperature(sensor);
    const auto end = endTemperature(sensor);
    return start && end ? std::optional((*start + *end) / 2) : start ? start : end;
}

std::optional<double> meanTemperature(const Conditions &conditions, SensorMeasures what) {
    return meanTemperature(conditions, what, sensorTemperature);
}

std::optional<double> TemperatureSpan::farthest() const {
    if (!lowest || !highest)
        return std::nullopt;
    return referenceTemperature - *lowest > *highest - referenceTemperature ? lowest : highest;
}

TemperatureSpan temperatureSpan(const Conditions &conditions, SensorMeasures what) {
    TemperatureSpan span;
    const auto take = [&span](double value) {
        span.lowest = std::min(span.lowest.value_or(value), value);
        span.highest = std::max(span.highest.value_or(value), value);
    };
    bool open = false;
    for (const Sensor &sensor : conditions.sensors) {
        open |= sensor.measures == SensorMeasures::notStated; // it may measure `what`
        if (sensor.measures != what)
            continue;
        for (const auto value : {sensor.start, sensor.end}) {
            if (value)
                take(*value);
        }
        if (sensor.series)
            std::ranges::for_each(sensor.series->temperatures, take);
        open |= !startTemperature(sensor) || !endTemperature(sensor);
    }
    span.complete = span.lowest && !open;
    return span;
}

std::optional<double> gradientPerHour(const TemperatureSeries &series) {
    if (!std::ranges::is_sorted(series.times))
        return gradientPerHour(inOrder(series));
    const std::vector<double> &t = series.times;
    const std::vector<double> &value = series.temperatures;
    constexpr double hour = 3600;
    if (t.empty() || t.back() - t.front() < hour)
        return std::nullopt;
    // Extremes in a sliding window: indices whose values fall (rise) from front to back.
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
