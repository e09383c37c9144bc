// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <functional>

namespace palmer {

/// What became of one input.
struct JobResult {
    int code = 0;    ///< ExitCode
    QByteArray rows; ///< for a summary of all
};

/// How inputs are worked on and who hears of it.
struct Jobs {
    std::function<JobResult(int)> work;                ///< on this input; prints what it has to say
    std::function<void(int, const JobResult &)> heard; ///< input after input
    /// Prints what to say of an input whose process ended before it had an answer (too little memory, say);
    /// its code.
    std::function<int(int)> broken;
    bool parted = false; ///< an empty line between what the inputs print on stdout
};

/// Works on inputs 0 … count − 1, `jobs` at a time, each in a process of its own, so that one that breaks off
/// takes no other along; what they print comes out in the order of the inputs. How far it is stands on stderr
/// where that is a terminal. One input alone is worked on in this process.
void eachJob(int count, int jobs, const Jobs &tell);

/// As many as the machine has processors.
[[nodiscard]] int defaultJobs();

} // namespace palmer
