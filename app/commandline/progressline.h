// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/simulation/simulate.h"
#include "language/language.h"

#include <chrono>

namespace palmer {

/// Progress of a simulation as a line on a terminal that is overwritten and cleared at the end. Prints
/// nothing if stderr is no terminal.
class ProgressLine {
public:
    explicit ProgressLine(const Language &language);
    ~ProgressLine();
    ProgressLine(const ProgressLine &) = delete;
    ProgressLine &operator=(const ProgressLine &) = delete;

    void show(const SimulationProgress &progress);

private:
    const Language &m_language;
    bool m_terminal;
    bool m_shown = false;
    std::chrono::steady_clock::time_point m_last = std::chrono::steady_clock::now();
};

} // namespace palmer
