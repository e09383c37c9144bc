// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/instruments.h"

#include "kernel/measurement/testfacts.h"

#include <algorithm>

namespace palmer {

Quantity resolutionQuantity(const Document &document, const Instrument &instrument) {
    for (const TestPointer &test : document.tests) {
        if (isJudged(*test) && axisOf(*test) &&
            std::ranges::find(test->instruments, instrument.id) != test->instruments.end())
            return deviationQuantity(*test);
    }
    return Quantity::deviation;
}

} // namespace palmer
