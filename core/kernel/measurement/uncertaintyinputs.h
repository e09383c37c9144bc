// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>

namespace palmer {

/// budgetActual: the budget with the share of S that the actual targets carry; positioning only.
enum class UncertaintyMethod { none, budget, budgetActual, monteCarlo, direct };

/// True if a method uses the contributions of a budget.
[[nodiscard]] constexpr bool usesContributions(UncertaintyMethod method) {
    return method != UncertaintyMethod::none && method != UncertaintyMethod::direct;
}

inline constexpr long long mostTrialsStated = 1'000'000'000; ///< if the number of trials is fixed

enum class DeviceKind { certificate, range };
enum class DriftModel { independent, linear };

/// Uncertainty of the measuring device as its certificate states it: µm and µm/m (rotary: arc seconds).
struct DeviceUncertainty {
    DeviceKind kind = DeviceKind::certificate;
    std::optional<double> fixed;
    std::optional<double> perMetre;
    double coverageFactor = 2;

    bool operator==(const DeviceUncertainty &) const = default;
};

/// A pair of values for machine and instrument; null = unknown.
struct MachineAndInstrument {
    std::optional<double> machine;
    std::optional<double> instrument;

    bool operator==(const MachineAndInstrument &) const = default;
};

/// Expanded uncertainties entered directly: parameter id → U in µm (rotary: arc seconds).
using ExpandedUncertainties = std::map<std::string, double>;

/// Inputs of the budget of a positioning test; null = unknown, 0 = stated to be zero.
struct PositioningUncertaintyInputs {
    UncertaintyMethod method = UncertaintyMethod::none;
    DeviceUncertainty device;
    std::optional<double> misalignmentRange;      ///< R_MIS, mm
    MachineAndInstrument temperatureRange;        ///< R(θ), °C
    MachineAndInstrument expansionRange;          ///< R(α), µm/(m·°C)
    std::optional<double> environmentalVariation; ///< E_VE, µm or arc seconds
    std::optional<std::string> driftTest;         ///< id of the drift test that gives E_VE
    DriftModel driftModel = DriftModel::independent;
    std::optional<double> length;    ///< L, mm; null: the measurement travel
    std::optional<long long> trials; ///< 1 … 10⁹; null: adaptive
    long long seed = 1;
    ExpandedUncertainties expanded;

    bool operator==(const PositioningUncertaintyInputs &) const = default;
};

/// An expanded uncertainty in µm with its coverage factor.
struct ExpandedValue {
    std::optional<double> expanded;
    double coverageFactor = 2;

    bool operator==(const ExpandedValue &) const = default;
};

/// Inputs of the budgets of a circular test; null = unknown, 0 = stated to be zero.
struct CircularUncertaintyInputs {
    UncertaintyMethod method = UncertaintyMethod::none;
    ExpandedValue displacement;
    std::optional<double> resolution;             ///< step, µm
    std::optional<double> pointNoise;             ///< standard uncertainty, µm
    std::optional<double> repeatability;          ///< standard uncertainty, µm; null: from repeated arcs
    std::optional<double> environmentalVariation; ///< full range, µm
    std::optional<std::string> driftTest;
    std::optional<double> centring; ///< standard uncertainty, µm; set-up centring only
    bool sameSensor = false;        ///< one temperature sensor for machine and instrument
    MachineAndInstrument temperatureStandardUncertainty; ///< °C
    MachineAndInstrument expansionStandardUncertainty;   ///< µm/(m·°C)
    std::optional<long long> trials;
    long long seed = 1;
    ExpandedUncertainties expanded;

    bool operator==(const CircularUncertaintyInputs &) const = default;
};

} // namespace palmer
