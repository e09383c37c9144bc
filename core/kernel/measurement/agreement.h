// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>

namespace palmer {

enum class AgreementState { notAgreed, agreed, notApplicable };

/// A point to be agreed between supplier/manufacturer and user; `point` is its key in the file format.
struct AgreedPoint {
    std::string point;
    AgreementState state = AgreementState::notAgreed;
    std::string text;
    std::optional<double> value = {}; ///< gradient: °C/h; feed: mm/min or °/min; null: no number

    bool operator==(const AgreedPoint &) const = default;
};

/// An agreed limit of a parameter, in mm (rotary: degrees). `edition`: the edition it was agreed for; null:
/// the test's own.
struct Limit {
    std::optional<double> value;
    std::optional<std::string> edition;
    std::string source;

    bool operator==(const Limit &) const = default;
};

/// Keyed by parameter id without axis index.
using Limits = std::map<std::string, Limit>;

enum class Rule { simpleAcceptance, iso14253_1, rejectionProven };

/// How value, limit and uncertainty give a verdict; the guard band is guardFactor·U.
struct DecisionRule {
    Rule rule = Rule::simpleAcceptance;
    double guardFactor = 1.0;

    bool operator==(const DecisionRule &) const = default;
};

} // namespace palmer
