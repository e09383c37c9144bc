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
