// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/referencetemperature.h"
#include "kernel/uncertainty/contribution.h"

#include <cmath>
#include <optional>

namespace palmer {

// How the budgets read their inputs: every one is a number, or a defect of the contribution it is for.

inline constexpr double coverage = 2;            ///< k of every U here
inline constexpr double micrometresPerMm = 1000; ///< certificates speak of µm

/// What the inputs are called, by budgets and by lists of what a test states.
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

/// The sizes (ranges, uncertainties) that a contribution is made of.
class InputReader {
public:
    explicit InputReader(Contribution &contribution)
        : m_contribution(contribution) {}

    /// A size: not negative.
    double size(std::optional<double> value, const char *key, const Text &name) {
        return checked(value, key, name, value && *value >= 0);
    }
    /// Above 0.
    double positive(std::optional<double> value, const char *key, const Text &name) {
        return checked(value, key, name, value && *value > 0);
    }
    /// Of either sign.
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

/// A product with a stated 0 is 0 whatever its other factors are.
inline bool isZero(std::optional<double> value) {
    return value && *value == 0;
}

} // namespace palmer
