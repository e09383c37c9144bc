// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace palmer {

enum class WarmUpKind { notStated, procedure, dryRun, setUpOnly };

/// The party that specified the warm-up.
enum class SpecifiedBy { notStated, maker, agreement };

struct WarmUp {
    WarmUpKind kind = WarmUpKind::notStated;
    std::string text;
    SpecifiedBy specifiedBy = SpecifiedBy::notStated;

    bool operator==(const WarmUp &) const = default;
};

enum class SensorMeasures { machine, instrument, air, notStated };
inline constexpr std::size_t kindsOfSensors = static_cast<std::size_t>(SensorMeasures::notStated) + 1;

/// Temperatures of a sensor during the test; both vectors have the same length.
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

/// True if the results hold at 20 °C (nominal differential expansion). Stated by the user, never guessed.
enum class CorrectionTo20 { notStated, notApplied, appliedByInstrument, appliedHere };

using Point3 = std::array<std::optional<double>, 3>; ///< X, Y, Z in mm; null: not stated

/// Compensation of the instrument for air and machine temperature; none: the instrument has none.
enum class InstrumentCompensation { notStated, on, off, none };

/// Conditions stated for both positioning and circular tests.
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
    std::optional<bool> temperatureControlled; ///< the room temperature can be controlled
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
    std::optional<bool> continuousDevice; ///< rotary: a continuous scale of suitable accuracy was available
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

/// Returns θ in °C: the mean over all sensors that measure `what` of the mean of start and end, or of the
/// only one known. Null unless each of them has a value, or if a sensor does not state what it measures.
[[nodiscard]] std::optional<double> meanTemperature(const Conditions &conditions, SensorMeasures what);

/// Start or end temperature of a sensor: stated, or taken at the earliest or latest time of its series.
[[nodiscard]] std::optional<double> startTemperature(const Sensor &sensor);
[[nodiscard]] std::optional<double> endTemperature(const Sensor &sensor);

/// Mean of start and end of a sensor, or the only one known.
[[nodiscard]] std::optional<double> sensorTemperature(const Sensor &sensor);

/// Returns the mean of one of these over the sensors that state both `what` and the value, °C: for reports.
[[nodiscard]] std::optional<double> statedTemperature(const Conditions &conditions, SensorMeasures what,
                                                      std::optional<double> (*temperature)(const Sensor &));

/// The same to compute with. Null unless each of these sensors has a value, or if a sensor does not state
/// what it measures.
[[nodiscard]] std::optional<double> meanTemperature(const Conditions &conditions, SensorMeasures what,
                                                    std::optional<double> (*temperature)(const Sensor &));

/// Extremes of all temperatures stated for machine, instrument or air, °C.
struct TemperatureSpan {
    std::optional<double> lowest;
    std::optional<double> highest;
    bool complete = false; ///< at least one sensor, each with start and end, and none of unknown subject

    [[nodiscard]] std::optional<double> farthest() const; ///< from 20 °C
};
[[nodiscard]] TemperatureSpan temperatureSpan(const Conditions &conditions, SensorMeasures what);

/// Returns the largest change of temperature within an hour, °C/h: highest − lowest in any one-hour window,
/// so that short steps do not magnify noise. Null for a series shorter than an hour.
[[nodiscard]] std::optional<double> gradientPerHour(const TemperatureSeries &series);

/// The temperature at which lengths are stated, °C.
inline constexpr double referenceTemperature = 20;

} // namespace palmer
