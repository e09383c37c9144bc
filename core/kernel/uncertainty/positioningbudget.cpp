// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/uncertainty/positioningbudget.h"

#include "kernel/uncertainty/inputs.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palmer {

namespace {

constexpr double mmPerMetre = 1000; ///< L is in mm, certificates and α refer to metres
constexpr double arcSecondsPerDegree = 3600;

/// Returns the start or end temperature, whichever is farther from 20 °C; null unless both are known.
std::optional<double> fartherTemperature(const Conditions &conditions, SensorMeasures what) {
    const auto start = meanTemperature(conditions, what, startTemperature);
    const auto end = meanTemperature(conditions, what, endTemperature);
    if (!start || !end)
        return std::nullopt;
    const auto distance = [](double theta) { return std::abs(theta - referenceTemperature); };
    return distance(*end) > distance(*start) ? end : start;
}

/// Machine or instrument: the inputs of its two thermal contributions.
struct Body {
    const char *temperatureId = nullptr;
    Text temperatureName;
    const char *expansionId = nullptr;
    Text expansionName;
    SensorMeasures sensor = SensorMeasures::machine;
    std::optional<double> MachineAndInstrument::*range = nullptr;
    std::optional<double> Expansion::*alpha = nullptr;
    Text theta; ///< names of the inputs
    Text alphaName;
    Text temperatureRange;
    Text expansionRange;
};

constexpr std::array bodies{
    Body{"temperatureMachine", REPORT_TEXT("report", "temperature of the machine"), "expansionMachine",
         REPORT_TEXT("report", "coefficient of expansion of the machine"), SensorMeasures::machine,
         &MachineAndInstrument::machine, &Expansion::machine,
         REPORT_TEXT("report", "temperature θ of the machine at start and end"),
         REPORT_TEXT("report", "coefficient of expansion α of the machine"), inputs::thetaRangeMachine,
         inputs::alphaRangeMachine},
    Body{"temperatureInstrument", REPORT_TEXT("report", "temperature of the instrument"),
         "expansionInstrument", REPORT_TEXT("report", "coefficient of expansion of the instrument"),
         SensorMeasures::instrument, &MachineAndInstrument::instrument, &Expansion::instrument,
         REPORT_TEXT("report", "temperature θ of the instrument at start and end"),
         REPORT_TEXT("report", "coefficient of expansion α of the instrument"), inputs::thetaRangeInstrument,
         inputs::alphaRangeInstrument},
};

/// Removes the rounding errors from a difference of temperatures.
double readable(double value) {
    constexpr double places = 1e6;
    return std::isfinite(value) ? std::round(value * places) / places : 0;
}

constexpr Text lengthName = REPORT_TEXT("report", "length L, which must be above 0");

/// Builds the budget. Sizes are in µm (rotary: arc seconds) until stored.
class PositioningBudgetMaker {
public:
    PositioningBudgetMaker(const PositioningMeasurement &measurement,
                           std::optional<double> environmentalVariation)
        : m_measurement(measurement)
        , m_inputs(measurement.uncertainty)
        , m_linear(measurement.axis.motion == Motion::linear)
        , m_toBase(m_linear ? micrometresPerMm : arcSecondsPerDegree)
        , m_length(m_inputs.length ? *m_inputs.length : measurementTravel(measurement))
        , m_environmentalVariation(m_inputs.environmentalVariation) {
        if (!m_environmentalVariation && environmentalVariation)
            m_environmentalVariation = *environmentalVariation * m_toBase;
    }

    PositioningBudget make() {
        m_budget.length = m_length;
        addDevice();
        if (m_linear) {
            addMisalignment();
            for (const Body &body : bodies)
                addTemperature(body);
            for (const Body &body : bodies)
                addExpansion(body);
        }
        addEnvironment();
        return std::move(m_budget);
    }

private:
    [[nodiscard]] Number metres() const {
        constexpr int decimals = 3;
        return {m_length / mmPerMetre, Quantity::number, decimals};
    }
    [[nodiscard]] Number size(double value) const {
        return {value, m_linear ? Quantity::micrometres : Quantity::arcSeconds};
    }
    static Number factor(double value) { return {value, Quantity::number}; }
    /// A dash for a factor that is not stated, which a stated 0 beside it allows.
    static Argument stated(std::optional<double> value, Quantity quantity) {
        return value ? Argument(Number{*value, quantity}) : Argument(std::string("–"));
    }

    void store(Contribution contribution, double expanded) {
        if (contribution.defects.empty() && std::isfinite(expanded))
            contribution.expanded = expanded / m_toBase;
        m_budget.contributions.push_back(std::move(contribution));
    }

    /// Returns L, needed if a contribution grows with it.
    double lengthFor(InputReader &read) { return read.positive(m_length, "length", lengthName); }

    void addDevice() {
        const DeviceUncertainty &device = m_inputs.device;
        const bool certificate = device.kind == DeviceKind::certificate;
        Contribution result{deviceId,
                            certificate ? REPORT_TEXT("report", "instrument, calibration certificate")
                                        : REPORT_TEXT("report", "instrument, range of its error"),
                            {},
                            {},
                            true,
                            {}};
        InputReader read(result);
        const double fixed = read.size(device.fixed, deviceId, inputs::fixedPart);
        double perMetre = 0;
        const Text name = inputs::perMetre;
        if (m_linear)
            perMetre = read.size(device.perMetre, deviceId, name);
        else if (device.perMetre && !isZero(device.perMetre))
            read.refuse(deviceId,
                        REPORT_TEXT("report", "part per metre of the instrument, on a rotary axis"));
        if (perMetre > 0)
            lengthFor(read);
        double scale = rectangularFactor;
        if (certificate)
            scale = coverage / read.positive(device.coverageFactor, deviceId, inputs::certificateFactor);
        const double atLength = fixed + perMetre * m_length / mmPerMetre;
        result.inputs = deviceInputs(certificate, fixed, perMetre);
        m_budget.fixedDevice = scale * fixed / m_toBase;
        store(std::move(result), scale * atLength);
    }

    [[nodiscard]] Message deviceInputs(bool certificate, double fixed, double perMetre) const {
        const double k = m_inputs.device.coverageFactor;
        const Number scale = certificate ? factor(k) : factor(rectangularFactor);
        const bool scaled = !certificate || k != coverage;
        if (perMetre == 0)
            return !scaled       ? Message{REPORT_TEXT("report", "%1"), {size(fixed)}}
                   : certificate ? Message{REPORT_TEXT("report", "%1 · 2/%2"), {size(fixed), scale}}
                                 : Message{REPORT_TEXT("report", "%1 · %2"), {scale, size(fixed)}};
        if (fixed == 0)
            return !scaled       ? Message{REPORT_TEXT("report", "%1/m · %2 m"), {size(perMetre), metres()}}
                   : certificate ? Message{REPORT_TEXT("report", "%1/m · %2 m · 2/%3"),
                                           {size(perMetre), metres(), scale}}
                                 : Message{REPORT_TEXT("report", "%1 · %2/m · %3 m"),
                                           {scale, size(perMetre), metres()}};
        return !scaled       ? Message{REPORT_TEXT("report", "%1 + %2/m · %3 m"),
                                 {size(fixed), size(perMetre), metres()}}
               : certificate ? Message{REPORT_TEXT("report", "(%1 + %2/m · %3 m) · 2/%4"),
                                       {size(fixed), size(perMetre), metres(), scale}}
                             : Message{REPORT_TEXT("report", "%1 · (%2 + %3/m · %4 m)"),
                                       {scale, size(fixed), size(perMetre), metres()}};
    }

    void addMisalignment() {
        constexpr double squareFactor = rectangularFactor / 2; // the cosine error lies between 0 and R²/2L
        Contribution result{misalignmentId, REPORT_TEXT("report", "misalignment"), {}, {}, true, {}};
        InputReader read(result);
        const double range = read.size(m_inputs.misalignmentRange, "misalignmentRange", inputs::misalignment);
        double expanded = 0;
        if (range > 0)
            expanded = squareFactor * range * range / lengthFor(read) * micrometresPerMm;
        result.inputs = {
            REPORT_TEXT("report", "%1 · (%2)² / %3"),
            {factor(squareFactor), Number{range, Quantity::position}, Number{m_length, Quantity::position}}};
        store(std::move(result), expanded);
    }

    [[nodiscard]] std::optional<double> alphaOf(const Body &body) const {
        return m_measurement.conditions.common.expansion.*body.alpha;
    }

    /// True for an instrument that compensates for air only: it has no material that expands.
    [[nodiscard]] bool withoutExpansion(const Body &body, std::optional<double> range) const {
        return body.sensor == SensorMeasures::instrument && isZero(alphaOf(body)) &&
               (!range || isZero(range));
    }

    static Message noExpansion() {
        return {REPORT_TEXT("report", "instrument without expansion, α = 0"), {}};
    }

    void addTemperature(const Body &body) {
        const auto range = m_inputs.temperatureRange.*body.range;
        Contribution result{body.temperatureId, body.temperatureName, {}, {}, true, {}};
        if (withoutExpansion(body, std::nullopt) && (!range || *range >= 0)) {
            result.applies = false;
            result.inputs = noExpansion();
            store(std::move(result), 0);
            return;
        }
        InputReader read(result);
        double expanded = 0;
        double alpha = alphaOf(body).value_or(0);
        double width = range.value_or(0);
        if (range || !isZero(alphaOf(body)))
            width = read.size(range, "temperatureRange", body.temperatureRange);
        if (alphaOf(body) || !isZero(range))
            alpha = read.number(alphaOf(body), "expansion", body.alphaName);
        if (width > 0 && alpha != 0)
            expanded = rectangularFactor * std::abs(alpha) * lengthFor(read) / mmPerMetre * width;
        result.inputs = {REPORT_TEXT("report", "%1 · %2 · %3 m · %4"),
                         {factor(rectangularFactor), stated(alphaOf(body), Quantity::expansion), metres(),
                          stated(range, Quantity::temperature)}};
        store(std::move(result), expanded);
    }

    void addExpansion(const Body &body) {
        const auto range = m_inputs.expansionRange.*body.range;
        Contribution result{body.expansionId, body.expansionName, {}, {}, true, {}};
        if (withoutExpansion(body, range)) {
            result.applies = false;
            result.inputs = noExpansion();
            store(std::move(result), 0);
            return;
        }
        InputReader read(result);
        const auto theta = fartherTemperature(m_measurement.conditions.common, body.sensor);
        double expanded = 0;
        double width = range.value_or(0);
        const auto distance =
            theta ? std::optional(readable(std::abs(*theta - referenceTemperature))) : std::nullopt;
        double away = theta ? std::abs(*theta - referenceTemperature) : 0;
        if (range || !(theta && away == 0))
            width = read.size(range, "expansionRange", body.expansionRange);
        if (theta || !isZero(range))
            away = std::abs(read.number(theta, "sensors", body.theta) - referenceTemperature);
        if (width > 0 && away > 0)
            expanded = rectangularFactor * away * lengthFor(read) / mmPerMetre * width;
        result.inputs = {REPORT_TEXT("report", "%1 · %2 · %3 m · %4"),
                         {factor(rectangularFactor), stated(distance, Quantity::temperature), metres(),
                          stated(range, Quantity::expansion)}};
        store(std::move(result), expanded);
    }

    void addEnvironment() {
        Contribution result{environmentalVariationId,
                            REPORT_TEXT("report", "environmental variation, E_VE"),
                            {},
                            {},
                            true,
                            {}};
        InputReader read(result);
        const double range =
            read.size(m_environmentalVariation, environmentalVariationId, inputs::environment);
        result.inputs = {REPORT_TEXT("report", "%1 · %2"), {factor(rectangularFactor), size(range)}};
        store(std::move(result), rectangularFactor * range);
    }

    const PositioningMeasurement &m_measurement;
    const PositioningUncertaintyInputs &m_inputs;
    bool m_linear;
    double m_toBase;
    double m_length;
    std::optional<double> m_environmentalVariation;
    PositioningBudget m_budget;
};

} // namespace

const Contribution *PositioningBudget::find(std::string_view id) const {
    const auto found = std::ranges::find(contributions, id, [](const Contribution &c) { return c.id; });
    return found == contributions.end() ? nullptr : &*found;
}

std::optional<double> PositioningBudget::systematic() const {
    double squares = 0;
    for (const Contribution &contribution : contributions) {
        if (std::string_view(contribution.id) == environmentalVariationId)
            continue;
        if (!contribution.expanded)
            return std::nullopt;
        squares += *contribution.expanded * *contribution.expanded;
    }
    return std::sqrt(squares);
}

std::optional<double> PositioningBudget::environmental() const {
    const Contribution *contribution = find(environmentalVariationId);
    return contribution ? contribution->expanded : std::nullopt;
}

PositioningBudget positioningBudget(const PositioningMeasurement &measurement,
                                    std::optional<double> environmentalVariation) {
    return PositioningBudgetMaker(measurement, environmentalVariation).make();
}

} // namespace palmer
