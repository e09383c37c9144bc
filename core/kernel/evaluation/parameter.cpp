// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/parameter.h"

namespace palmer {

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
