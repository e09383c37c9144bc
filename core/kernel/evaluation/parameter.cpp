// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/parameter.h"

#include <algorithm>

namespace palmer {

bool hasLimit(const Limits &limits, const Term &term) {
    return std::ranges::any_of(
        limits, [&](const auto &limit) { return limit.second.value && term.isMeantBy(limit.first); });
}

bool hasLimits(const Limits &limits) {
    return std::ranges::any_of(limits, [](const auto &limit) { return limit.second.value.has_value(); });
}

std::string parameterId(const Parameter &parameter) {
    std::string id = parameter.term.id;
    if (!parameter.index.empty())
        id += "_" + parameter.index;
    return id;
}

std::string plainSymbol(const Parameter &parameter) {
    const Symbol &symbol = parameter.term.symbol;
    return std::string(symbol.base) + symbol.subscript + symbol.arrow + parameter.index;
}

std::optional<double> Parameter::guardedUncertainty() const {
    return decidedBy == UncertaintyMethod::monteCarlo && simulated ? simulated->guarded()
                                                                   : expandedUncertainty;
}

} // namespace palmer
