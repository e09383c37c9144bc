#pragma once

#include "kernel/evaluation/testevaluation.h"
#include "kernel/measurement/test.h"

#include <vector>

namespace palmer {

/// A result that the instrument's own program states, and ours that says the same.
struct InstrumentResult {
    const ImportedFile *file;
    const ImportedResult *stated;
    const Parameter *ours = nullptr; ///< null: there is none, or its unit is none of a length or angle
    double value = 0;                ///< what is stated, in the unit of ours: mm or degrees
};

/// The results the imported files of a test state, in their order. Points into the arguments.
[[nodiscard]] std::vector<InstrumentResult> instrumentResults(const Test &test,
                                                              const TestEvaluation &evaluation);

} // namespace palmer
