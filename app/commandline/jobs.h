// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "system/workers.h"

#include <functional>

namespace palmer {

/// How inputs are processed, and callbacks for the results.
struct Jobs {
    std::function<JobResult(int)> work;                ///< processes this input and prints its output
    std::function<void(int, const JobResult &)> heard; ///< called in input order
    /// Reports an input whose process ended before it answered (out of memory, for instance); returns its
    /// code.
    std::function<int(int)> broken;
    bool parted = false; ///< print an empty line between the outputs of the inputs
};

/// Processes inputs 0 … count − 1, `jobs` at a time, each in its own process, so that a crash does not affect
/// the others; output appears in input order. Progress is shown on stderr if it is a terminal. A single input
/// is processed in this process.
void eachJob(int count, int jobs, const Jobs &tell);

/// Shows "12 / 500" on stderr if it is a terminal, overwriting the previous text; clears it.
void showProgress(int done, int count);
void clearProgress();

/// Number of processors.
[[nodiscard]] int defaultJobs();

} // namespace palmer
