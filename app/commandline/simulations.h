// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commandline/command.h"
#include "document/evaluateddocument.h"

#include <array>
#include <optional>

namespace palmer {

/// Options for the uncertainty: --uncertainty, --seed, --trials, --threads.
inline constexpr std::array simulationCommandOptions{
    Option{"uncertainty", "budget|monteCarlo",
           REPORT_TEXT("report", "how the uncertainty is found that decides, whatever the file says")},
    Option{"seed", "N", REPORT_TEXT("report", "seed of the Monte Carlo simulation")},
    Option{"trials", "N",
           REPORT_TEXT("report", "trials of the simulation; without it until two places are stable")},
    Option{"threads", "N", REPORT_TEXT("report", "threads of the simulation; the figures are the same")},
};

/// Values of these options.
struct SimulationChoices {
    std::optional<UncertaintyMethod> method;
    std::optional<long long> seed;
    std::optional<long long> trials;
    int threads = 0;
};

/// Throws UsageError for an invalid word or number.
[[nodiscard]] SimulationChoices simulationChoices(const Invocation &invocation);

/// Applies the choices to all tests of the document.
void choose(Document &document, const SimulationChoices &choices);

/// Throws UsageError if the choices, already applied, have no effect on the document.
void requireEffect(const SimulationChoices &choices, const Document &document);

/// Runs the simulations; shows progress on stderr if it is a terminal.
[[nodiscard]] EvaluatedDocument simulated(EvaluatedDocument evaluated, SimulateWhich which, int threads,
                                          const Language &language);

} // namespace palmer
