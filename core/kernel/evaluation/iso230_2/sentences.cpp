// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/iso230_2/sentences.h"

namespace palmer::iso230_2 {

std::string readingName(const Edition &edition, const PositioningMeasurement &measurement, std::size_t run,
                        std::size_t target) {
    const Direction approach = measurement.runs[run].approach;
    int number = 0;
    for (std::size_t k = 0; k <= run; ++k)
        number += measurement.runs[k].approach == approach;
    return std::to_string(target + 1) + arrow(approach) + " (" + edition.runLetter + " = " +
           std::to_string(number) + ")";
}

void NameList::add(const std::string &name) {
    constexpr int readable = 12;
    ++m_count;
    if (m_count > readable + 1)
        return;
    if (m_count > 1)
        m_text += ", ";
    m_text += m_count > readable ? "…" : name;
}

} // namespace palmer::iso230_2
