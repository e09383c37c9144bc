// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/words/kindwords.h"

#include <array>

namespace palmer {

const KindWords &kindWords(const Test &test) {
    static constexpr std::array kinds{
        // in the order of Measurement
        KindWords{REPORT_TEXT("report", "Positioning test of the %1 axis"),
                  REPORT_TEXT("report", "Positioning test of axis %1"), REPORT_TEXT("report", "%1 axis"),
                  REPORT_TEXT("report", "GUM, after the model of ISO 230-2:2006 Annex A"),
                  REPORT_TEXT("report", "Model of Annex A")},
        KindWords{REPORT_TEXT("report", "Circular test in the %1 plane"),
                  REPORT_TEXT("report", "Circular test in the plane %1"),
                  REPORT_TEXT("report", "%1 circle, R %2"),
                  REPORT_TEXT("report", "GUM, contributors of ISO 230-4:2005, 4.6"),
                  REPORT_TEXT("report", "Simplified budget")},
        KindWords{REPORT_TEXT("report", "Drift test of the %1 axis"),
                  REPORT_TEXT("report", "Drift test of axis %1"),
                  REPORT_TEXT("report", "%1 axis"),
                  {},
                  {}}};
    static_assert(kinds.size() == allKinds.size());
    return kinds.at(static_cast<std::size_t>(kindOf(test)));
}

} // namespace palmer
