// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/surroundings.h"
#include "kernel/evaluation/testevaluation.h"
#include "kernel/measurement/test.h"

#include <vector>

namespace palmer {

/// A result that the instrument's own program states, and ours that says the same.
struct InstrumentResult {
    const ImportedFile *file = nullptr;
    const ImportedResult *stated = nullptr;
    const Parameter *ours = nullptr; ///< null: there is none, or its unit is none of a length or angle
    double value = 0;                ///< what is stated, in the unit of ours: mm or degrees
};

/// The results the imported files of a test state, in their order. Points into the arguments.
[[nodiscard]] std::vector<InstrumentResult> instrumentResults(const Test &test,
                                                              const TestEvaluation &evaluation);

/// A note for each result of an instrument's program that ours differs from by more than 5 % of it, twice the
/// resolution of the instruments and 0.2 µm (0.2″): bounds of ours.
void findOtherResults(TestEvaluation &evaluation, const Test &test, const Surroundings &surroundings);

} // namespace palmer
