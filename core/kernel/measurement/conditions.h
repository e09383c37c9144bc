// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace palmer {

enum class WarmUpKind { notStated, procedure, dryRun, setUpOnly };

/// By whom the warm-up was specified.
enum class SpecifiedBy { notStated, maker, agreement };

struct WarmUp {
    WarmUpKind kind = WarmUpKind::notStated;
    std::string text;
    SpecifiedBy specifiedBy = SpecifiedBy::notStated;

    bool operator==(const WarmUp &) const = default;
};

enum class SensorMeasures { machine, instrument, air, notStated };
inline constexpr std::size_t kindsOfSensors = static_cast<std::size_t>(SensorMeasures::notStated) + 1;

/// Temperatures of a sensor over the time of the test; both of the same length.
struct TemperatureSeries {
    std::vector<double> times;        ///< s
    std::vector<double> temperatures; ///< °C

    bool operator==(const TemperatureSeries &) const = default;
};

struct Sensor {
    SensorMeasures measures = SensorMeasures::notStated;
    std::string position;
    std::optional<double> start; ///< °C; null: not stated, or the first value of the series
    std::optional<double> end;   ///< °C; null: not stated, or the last value of the series
    std::optional<TemperatureSeries> series;

    bool operator==(const Sensor &) const = default;
};

/// Coefficients of thermal expansion α, µm/(m·°C).
struct Expansion {
    std::optional<double> machine;
    std::optional<double> instrument;

    bool operator==(const Expansion &) const = default;
};

/// Whether the results hold at 20 °C (nominal differential expansion). Asked for, never guessed.
enum class CorrectionTo20 { notStated, notApplied, appliedByInstrument, appliedHere };

using Point3 = std::array<std::optional<double>, 3>; ///< X, Y, Z in mm; null: not stated

/// The compensation of the instrument for the air and the temperature of the machine; none: it has none.
enum class InstrumentCompensation { notStated, on, off, none };

/// What positioning and circular tests state alike.
struct Conditions {
    WarmUp warmUp;
    std::string compensation;
    std::string otherAxes;
    std::string load;
    std::optional<bool> levelled;
    std::optional<bool> complete;
    std::optional<bool> unloaded;
    std::string soak;
    std::optional<bool> shielded;
    std::optional<bool> temperatureControlled; ///< the temperature of the room can be controlled
    std::optional<bool> stabilised;            ///< machine and instruments were thermally stable
    InstrumentCompensation instrumentCompensation = InstrumentCompensation::notStated;
    std::string thermalGuidelines;
    Point3 toolOffset;
    Point3 workpieceOffset;
    std::string instrumentPosition;
    std::vector<Sensor> sensors;
    Expansion expansion;
    CorrectionTo20 correctionTo20 = CorrectionTo20::notStated;

    bool operator==(const Conditions &) const = default;
};

enum class FeedMode { programmed, rapid };

struct PositioningConditions {
    Conditions common;
    std::optional<double> feed;                ///< mm/min, rotary °/min
    std::optional<FeedMode> feedMode;          ///< null: not stated
    std::optional<double> dwell;               ///< s
    std::optional<double> approachDistance;    ///< mm, rotary degrees
    std::optional<double> airPressure;         ///< hPa
    std::optional<double> airHumidity;         ///< %
    std::optional<double> gradientPerHour;     ///< °C/h
    std::optional<double> gradientHoursBefore; ///< hours before the test that the gradient covers
    std::optional<bool> continuousDevice; ///< rotary: a continuous scale of suitable accuracy was at hand
    std::optional<double>
        referencePosition; ///< mm: where the displacement was set to zero; null = first target

    bool operator==(const PositioningConditions &) const = default;
};

struct CircularConditions {
    Conditions common;
    Point3 centre; ///< of the circle, in machine coordinates
    std::string startPoint;
    std::string stopPoint;
    std::string smoothing;
    std::optional<bool> recentredBetweenRuns;

    bool operator==(const CircularConditions &) const = default;
};

/// θ: mean over all sensors that measure it, of each the mean of start and end, or the one that is known; °C.
/// Null unless each of them has one, and as long as a sensor may be one of them.
[[nodiscard]] std::optional<double> meanTemperature(const Conditions &conditions, SensorMeasures what);

/// Temperature at start or end of a sensor: stated, or that at the earliest or latest time of its series.
[[nodiscard]] std::optional<double> startTemperature(const Sensor &sensor);
[[nodiscard]] std::optional<double> endTemperature(const Sensor &sensor);

/// Mean at one time, startTemperature or endTemperature, over all sensors that measure it, °C. Null unless
/// each of them has it, and as long as a sensor may be one of them.
[[nodiscard]] std::optional<double> meanTemperature(const Conditions &conditions, SensorMeasures what,
                                                    std::optional<double> (*temperature)(const Sensor &));

/// Every temperature that is stated of machine, instrument or air, °C.
struct TemperatureSpan {
    std::optional<double> lowest;
    std::optional<double> highest;
    bool complete = false; ///< something measures it, each such sensor has start and end, and no other may

    [[nodiscard]] std::optional<double> farthest() const; ///< from 20 °C
};
[[nodiscard]] TemperatureSpan temperatureSpan(const Conditions &conditions, SensorMeasures what);

/// The largest change of temperature within an hour, °C/h: highest − lowest of any window of one hour, so
/// that noise is not magnified by short steps. Null for a series shorter than an hour.
[[nodiscard]] std::optional<double> gradientPerHour(const TemperatureSeries &series);

} // namespace palmer
