// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/conditions.h"
#include "kernel/uncertainty/contribution.h"

#include <cmath>
#include <optional>

namespace palmer {

// How budgets read their inputs: each one is a number, or a defect of its contribution.

inline constexpr double coverage = 2;            ///< k of every U here
inline constexpr double micrometresPerMm = 1000; ///< certificates state µm

/// Names of the inputs, for budgets and lists of stated values.
namespace inputs {
inline constexpr Text fixedPart = REPORT_TEXT("report", "fixed part of the instrument");
inline constexpr Text perMetre = REPORT_TEXT("report", "part per metre of the instrument");
inline constexpr Text certificateFactor = REPORT_TEXT("report", "coverage factor of the certificate");
inline constexpr Text misalignment = REPORT_TEXT("report", "range of the misalignment");
inline constexpr Text thetaRangeMachine =
    REPORT_TEXT("report", "range R(θ) of the temperature of the machine");
inline constexpr Text thetaRangeInstrument =
    REPORT_TEXT("report", "range R(θ) of the temperature of the instrument");
inline constexpr Text alphaRangeMachine =
    REPORT_TEXT("report", "range R(α) of the coefficient of expansion of the machine");
inline constexpr Text alphaRangeInstrument =
    REPORT_TEXT("report", "range R(α) of the coefficient of expansion of the instrument");
inline constexpr Text environment = REPORT_TEXT("report", "environmental variation error E_VE");
inline constexpr Text displacement = REPORT_TEXT("report", "uncertainty of the calibration of displacement");
inline constexpr Text referenceLength = REPORT_TEXT("report", "uncertainty of the reference length");
inline constexpr Text centring = REPORT_TEXT("report", "standard uncertainty of the centring");
inline constexpr Text pointNoise = REPORT_TEXT("report", "standard uncertainty of one point");
inline constexpr Text thetaOfMachine =
    REPORT_TEXT("report", "standard uncertainty of the temperature of the machine");
inline constexpr Text thetaOfInstrument =
    REPORT_TEXT("report", "standard uncertainty of the temperature of the instrument");
inline constexpr Text alphaOfMachine =
    REPORT_TEXT("report", "standard uncertainty of the coefficient of expansion of the machine");
inline constexpr Text alphaOfInstrument =
    REPORT_TEXT("report", "standard uncertainty of the coefficient of expansion of the instrument");
} // namespace inputs

/// Reads the sizes (ranges, uncertainties) of a contribution.
class InputReader {
public:
    explicit InputReader(Contribution &contribution)
        : m_contribution(contribution) {}

    /// Reads a size ≥ 0.
    double size(std::optional<double> value, const char *key, const Text &name) {
        return checked(value, key, name, value && *value >= 0);
    }
    /// Reads a number > 0.
    double positive(std::optional<double> value, const char *key, const Text &name) {
        return checked(value, key, name, value && *value > 0);
    }
    /// Reads a number that may be negative.
    double number(std::optional<double> value, const char *key, const Text &name) {
        return checked(value, key, name, true);
    }
    void refuse(const char *key, const Text &name) { m_contribution.defects.push_back({key, name, true}); }
    [[nodiscard]] bool complete() const { return m_contribution.defects.empty(); }

private:
    double checked(std::optional<double> value, const char *key, const Text &name, bool possible) {
        if (value && possible && std::isfinite(*value))
            return *value;
        m_contribution.defects.push_back({key, name, value.has_value()});
        return 0;
    }

    Contribution &m_contribution;
};

/// True for a stated 0: a product with it is 0 whatever the other factors are.
inline bool isZero(std::optional<double> value) {
    return value && *value == 0;
}

} // namespace palmer
