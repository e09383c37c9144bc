#include "kernel/measurement/conditions.h"

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

std::optional<double> meanTemperature(const Conditions &conditions, SensorMeasures what) {
    double sum = 0;
    int count = 0;
    for (const Sensor &sensor : conditions.sensors) {
        if (sensor.measures != what)
            continue;
        const auto start = startTemperature(sensor);
        const auto end = endTemperature(sensor);
        if (!start || !end)
            return std::nullopt;
        sum += (*start + *end) / 2;
        ++count;
    }
    return count ? std::optional(sum / count) : std::nullopt;
}

} // namespace palmer
