// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/forms/member.h"

#include <optional>

namespace palmer::ui {

// The decision rule of a test, as members for the pages of limits and uncertainty.

/// The rule by its index: simple acceptance, ISO 14253-1, rejection proven.
[[nodiscard]] inline Member<int> decisionRuleMember() {
    using Rule = decltype(DecisionRule::rule);
    return choiceOf<Rule>(ofTest([](auto &test) { return &test.decisionRule.rule; }),
                          {Rule::simpleAcceptance, Rule::iso14253_1, Rule::rejectionProven});
}

/// Guard band as a multiple of U; if emptied, the default of a new rule.
[[nodiscard]] inline Member<std::optional<double>> guardFactorMember() {
    Member<double> guard = ofTest([](auto &test) { return &test.decisionRule.guardFactor; });
    return converted<std::optional<double>, double>(
        std::move(guard), [](const double &factor) { return std::optional(factor); },
        [](const std::optional<double> &factor) { return factor.value_or(DecisionRule().guardFactor); });
}

} // namespace palmer::ui
