// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "language/decimals.h"

#include "language/rounding.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace palmer {

namespace {

constexpr int mostOfPositions = 6;
constexpr int mostOfReadings = 4;
constexpr int mostOfAngularReadings = 2; ///< degrees have no short form in arc seconds: 0.01″ must do
constexpr int finest = 9;                ///< beyond it there are only rounding errors of conversions
constexpr std::size_t looked = 2000;     ///< readings inspected, enough to find their decimals

int mostDecimals(const Axis &axis) {
    return axis.motion == Motion::rotary ? mostOfAngularReadings : mostOfReadings;
}

} // namespace

int decimalsOf(double value, Quantity quantity) {
    const std::string digits = Decimal(value, quantity).rounded(finest);
    const auto last = digits.find_last_not_of('0');
    const auto point = digits.find('.');
    return point == std::string::npos || last <= point ? 0 : static_cast<int>(last - point);
}

int statedDecimals(double value, Quantity quantity, int least) {
    const int own = decimalsOf(value, quantity);
    return own < finest - 1 ? std::max(own, least) : least + 1;
}

double certain(double value) {
    constexpr int certainDigits = 15; // every 15-digit decimal survives conversion to double and back
    std::array<char, 32> buffer{};
    const auto written = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                       std::chars_format::scientific, certainDigits - 1);
    double result = value;
    std::from_chars(buffer.data(), written.ptr, result);
    return result;
}

int positionDecimals(const PositioningMeasurement &measurement) {
    int result = 0;
    for (auto target = measurement.targets.begin();
         target != measurement.targets.end() && result < mostOfPositions; ++target)
        result = std::max(result, decimalsOf(*target, positionQuantity(measurement.axis)));
    return std::min(result, mostOfPositions);
}

int readingDecimals(const PositioningMeasurement &measurement) {
    const int most = mostDecimals(measurement.axis);
    int result = 0;
    std::size_t seen = 0;
    for (const Run &run : measurement.runs) {
        for (const auto &deviation : run.deviations) {
            if (seen++ == looked)
                return result;
            if (deviation)
                result = std::min(
                    most, std::max(result, decimalsOf(*deviation, deviationQuantity(measurement.axis))));
        }
    }
    return result;
}

int feedDecimals(double feed) {
    constexpr double threeDigits = 100;
    int decimals = 0;
    for (double shown = std::abs(feed); shown > 0 && shown < threeDigits && decimals < finest; shown *= 10)
        ++decimals;
    return decimals;
}

int statisticDecimals(const PositioningMeasurement &measurement) {
    return std::min(readingDecimals(measurement) + 1, mostDecimals(measurement.axis));
}

} // namespace palmer
