// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/uncertainty/circularbudget.h"

#include "kernel/uncertainty/inputs.h"

#include <algorithm>
#include <cmath>

namespace palmer {

namespace {

constexpr double rootOfTwelve = 3.4641016151377546; ///< standard deviation of a uniform width w: w/√12

/// Builds the budget; standard uncertainties are in µm until stored.
class CircularBudgetMaker {
public:
    CircularBudgetMaker(const CircularMeasurement &measurement, std::optional<double> environmentalVariation,
                        std::optional<double> repeatability, std::size_t points)
        : m_measurement(measurement)
        , m_inputs(measurement.uncertainty)
        , m_environmentalVariation(m_inputs.environmentalVariation)
        , m_repeated(repeatability)
        , m_points(points) {
        if (!m_environmentalVariation && environmentalVariation)
            m_environmentalVariation = *environmentalVariation * micrometresPerMm;
    }

    CircularBudget make() {
        addDisplacement();
        addSize(resolutionId, REPORT_TEXT("report", "resolution of the instrument"), m_inputs.resolution,
                REPORT_TEXT("report", "resolution of the instrument"), 1 / rootOfTwelve,
                REPORT_TEXT("report", "2 · %1 / √12"));
        addRepeatability();
        addSize(driftId, REPORT_TEXT("report", "environmental variation, E_VE"), m_environmentalVariation,
                inputs::environment, 1 / rootOfTwelve, REPORT_TEXT("report", "2 · %1 / √12"));
        addReferenceLength();
        addCorrection();
        addSize(centringId, REPORT_TEXT("report", "centring of the set-up"), m_inputs.centring,
                inputs::centring, 1, REPORT_TEXT("report", "2 · %1"));
        addPointNoise();
        return std::move(m_budget);
    }

private:
    static Number micrometres(double value) { return {value, Quantity::micrometres}; }

    void store(Contribution contribution, double u) {
        if (contribution.defects.empty() && std::isfinite(u))
            contribution.expanded = coverage * u / micrometresPerMm;
        m_budget.contributions.push_back(std::move(contribution));
    }

    /// Adds a contribution that is one number times a factor.
    void addSize(const char *id, const Text &name, std::optional<double> value, const Text &input,
                 double factor, const Text &formula) {
        Contribution result{id, name, {}, {}, true, {}};
        InputReader read(result);
        const double size = read.size(value, id, input);
        result.inputs = {formula, {micrometres(size)}};
        store(std::move(result), factor * size);
    }

    /// Adds an expanded uncertainty from a certificate.
    void addCertified(const char *id, const Text &name, std::optional<double> expanded, double k,
                      const Text &input) {
        Contribution result{id, name, {}, {}, true, {}};
        InputReader read(result);
        const double size = read.size(expanded, id, input);
        const double factor = read.positive(k, id, inputs::certificateFactor);
        result.inputs = k == coverage ? Message{REPORT_TEXT("report", "%1"), {micrometres(size)}}
                                      : Message{REPORT_TEXT("report", "%1 · 2/%2"),
                                                {micrometres(size), Number{factor, Quantity::number}}};
        store(std::move(result), size / factor);
    }

    void addDisplacement() {
        addCertified(displacementId, REPORT_TEXT("report", "instrument, calibration of displacement"),
                     m_inputs.displacement.expanded, m_inputs.displacement.coverageFactor,
                     inputs::displacement);
    }

    void addReferenceLength() {
        const ReferenceLength &length = m_measurement.referenceLength;
        addCertified(referenceLengthId, REPORT_TEXT("report", "reference length"), length.expandedUncertainty,
                     length.coverageFactor, inputs::referenceLength);
    }

    void addPointNoise() {
        const auto n = static_cast<double>(std::max<std::size_t>(m_points, 1));
        Contribution result{pointNoiseId, REPORT_TEXT("report", "noise of the points"), {}, {}, true, {}};
        InputReader read(result);
        const double noise = read.size(m_inputs.pointNoise, pointNoiseId, inputs::pointNoise);
        result.inputs = {REPORT_TEXT("report", "2 · %1 / √%2"),
                         {micrometres(noise), Number{n, Quantity::count}}};
        store(std::move(result), noise / std::sqrt(n));
    }

    void addRepeatability() {
        const Text name = REPORT_TEXT("report", "repeatability");
        const Text input = REPORT_TEXT("report", "repeatability, or repeated circles");
        if (m_inputs.repeatability || !m_repeated) {
            addSize(repeatabilityId, name, m_inputs.repeatability, input, 1, REPORT_TEXT("report", "2 · %1"));
            return;
        }
        Contribution result{repeatabilityId, name, {}, {}, true, {}};
        const double s = *m_repeated * micrometresPerMm;
        result.inputs = {REPORT_TEXT("report", "2 · %1, largest s of the repeated circles"),
                         {Number{s, Quantity::micrometres, 3}}};
        store(std::move(result), s);
    }

    /// Returns α·u(T) as a relative length times 1e6; if u is stated as 0, α is not needed.
    static double temperatureTerm(InputReader &read, std::optional<double> alpha, std::optional<double> u,
                                  const Text &alphaName, const Text &uName) {
        if (u)
            read.size(u, "temperatureStandardUncertainty", uName);
        if (alpha)
            read.number(alpha, "expansion", alphaName);
        if (isZero(alpha) || isZero(u))
            return 0;
        if (!u)
            read.size(u, "temperatureStandardUncertainty", uName);
        if (!alpha)
            read.number(alpha, "expansion", alphaName);
        return alpha.value_or(0) * u.value_or(0);
    }

    /// Returns (T − 20)·u(α), likewise.
    static double expansionTerm(InputReader &read, std::optional<double> temperature, std::optional<double> u,
                                const Text &temperatureName, const Text &uName) {
        if (u)
            read.size(u, "expansionStandardUncertainty", uName);
        if (isZero(u) || (temperature && *temperature == referenceTemperature))
            return 0;
        if (!u)
            read.size(u, "expansionStandardUncertainty", uName);
        read.number(temperature, "sensors", temperatureName);
        return (temperature.value_or(referenceTemperature) - referenceTemperature) * u.value_or(0);
    }

    void addCorrection() {
        Contribution result{correctionId, REPORT_TEXT("report", "correction to 20 °C"), {}, {}, true, {}};
        InputReader read(result);
        const Conditions &conditions = m_measurement.conditions.common;
        // A start or end value alone does not say how far the other was from 20 °C.
        const auto theta = [&](SensorMeasures what) {
            return temperatureSpan(conditions, what).complete ? meanTemperature(conditions, what)
                                                              : std::nullopt;
        };
        auto machine = theta(SensorMeasures::machine);
        auto instrument = theta(SensorMeasures::instrument);
        const auto &[alphaMachine, alphaInstrument] = conditions.expansion;
        const auto &[uMachine, uInstrument] = m_inputs.temperatureStandardUncertainty;
        const Text alphaOfMachine = REPORT_TEXT("report", "coefficient of expansion α of the machine");
        const Text alphaOfInstrument = REPORT_TEXT("report", "coefficient of expansion α of the instrument");

        double squares = 0;
        const auto add = [&](double term) { squares += term * term; };
        if (m_inputs.sameSensor) {
            machine = machine ? machine : instrument;
            instrument = instrument ? instrument : machine;
            std::optional<double> difference;
            if (alphaMachine && alphaInstrument)
                difference = *alphaInstrument - *alphaMachine;
            add(temperatureTerm(read, difference, uMachine ? uMachine : uInstrument,
                                alphaMachine ? alphaOfInstrument : alphaOfMachine, inputs::thetaOfMachine));
        } else {
            add(temperatureTerm(read, alphaMachine, uMachine, alphaOfMachine, inputs::thetaOfMachine));
            add(temperatureTerm(read, alphaInstrument, uInstrument, alphaOfInstrument,
                                inputs::thetaOfInstrument));
        }
        const auto &[uAlphaMachine, uAlphaInstrument] = m_inputs.expansionStandardUncertainty;
        add(expansionTerm(read, machine, uAlphaMachine,
                          REPORT_TEXT("report", "temperature θ of the machine at start and end"),
                          inputs::alphaOfMachine));
        add(expansionTerm(read, instrument, uAlphaInstrument,
                          REPORT_TEXT("report", "temperature θ of the instrument at start and end"),
                          inputs::alphaOfInstrument));

        constexpr double parts = 1e-6; // α is in µm/(m·°C)
        const double u = m_measurement.nominalRadius * parts * std::sqrt(squares) * micrometresPerMm;
        constexpr int decimals = 3;
        result.inputs = {
            m_inputs.sameSensor
                ? REPORT_TEXT("report", "2 · %1, from temperatures (one sensor for machine and "
                                        "instrument) and coefficients of expansion")
                : REPORT_TEXT("report", "2 · %1, from temperatures and coefficients of expansion"),
            {Number{std::isfinite(u) ? u : 0, Quantity::micrometres, decimals}}};
        store(std::move(result), u);
    }

    const CircularMeasurement &m_measurement;
    const CircularUncertaintyInputs &m_inputs;
    std::optional<double> m_environmentalVariation;
    std::optional<double> m_repeated;
    std::size_t m_points;
    CircularBudget m_budget;
};

} // namespace

const Contribution *CircularBudget::find(std::string_view id) const {
    const auto found = std::ranges::find(contributions, id, [](const Contribution &c) { return c.id; });
    return found == contributions.end() ? nullptr : &*found;
}

CircularContributions contributionsOf(OfCircle what, Centring centring) {
    switch (what) {
    case OfCircle::radialDeviation:
        return {true, centring == Centring::instrument, false};
    case OfCircle::meanRadialDeviation:
        return {true, false, true};
    default:
        return {};
    }
}

bool takesUp(const CircularContributions &uses, std::string_view contribution) {
    if (contribution == referenceLengthId || contribution == correctionId)
        return uses.length;
    if (contribution == centringId)
        return uses.centring;
    if (contribution == pointNoiseId)
        return uses.noise;
    return true;
}

CircularBudget circularBudget(const CircularMeasurement &measurement,
                              std::optional<double> environmentalVariation,
                              std::optional<double> repeatability, std::size_t points) {
    return CircularBudgetMaker(measurement, environmentalVariation, repeatability, points).make();
}

std::optional<double> combined(const CircularBudget &budget, const CircularContributions &uses,
                               std::optional<double> repeatability) {
    double squares = 0;
    for (const Contribution &contribution : budget.contributions) {
        const std::string_view id = contribution.id;
        if (!takesUp(uses, id))
            continue;
        std::optional<double> expanded = contribution.expanded;
        if (id == repeatabilityId && repeatability)
            expanded = coverage * *repeatability;
        if (!expanded)
            return std::nullopt;
        squares += *expanded * *expanded;
    }
    return std::sqrt(squares);
}

} // namespace palmer
