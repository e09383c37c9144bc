// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/surroundings.h"
#include "kernel/evaluation/testevaluation.h"
#include "kernel/measurement/test.h"

#include <vector>

namespace palmer {

/// A result stated by the instrument's own program, and our corresponding result.
struct InstrumentResult {
    const ImportedFile *file = nullptr;
    const ImportedResult *stated = nullptr;
    const Parameter *ours = nullptr; ///< null: none, or the stated unit is not a length or angle
    double value = 0;                ///< stated value in the unit of ours: mm or degrees
};

/// Returns the results stated by the imported files of a test, in their order. Points into the arguments.
[[nodiscard]] std::vector<InstrumentResult> instrumentResults(const Test &test,
                                                              const TestEvaluation &evaluation);

/// Adds a note for each result of an instrument's program that differs from ours by more than the largest of
/// 5 %, twice the resolution of the instruments and 0.2 µm (0.2″). These bounds are ours.
void findOtherResults(TestEvaluation &evaluation, const Test &test, const Surroundings &surroundings);

} // namespace palmer
