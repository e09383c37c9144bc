// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <functional>
#include <map>
#include <memory>
#include <optional>

namespace palmer {

/// Result of one input.
struct JobResult {
    int code = 0;    ///< exit code
    QByteArray rows; ///< for a common summary
};

/// A result with what was printed for it.
struct FinishedJob {
    JobResult result;
    QByteArray printed;
    QByteArray errors; ///< on standard error
};

/// By input; null if the process that worked on it ended before it answered.
using FinishedJobs = std::map<int, std::optional<FinishedJob>>;

/// Processes that each take the next of the inputs 0 … count − 1 and process it, so that a crash does not
/// affect the others.
class Workers {
public:
    Workers() = default;
    virtual ~Workers() = default;
    Workers(const Workers &) = delete;
    Workers &operator=(const Workers &) = delete;

    /// Starts processes while inputs are left, up to `jobs` of them; false if none is running.
    virtual bool keepUp(int jobs) = 0;

    /// Waits until a process says something; adds what has ended.
    virtual void listen(FinishedJobs &ended) = 0;
};

/// On Linux they are copies of this process; on Windows they run the same command line again, and this does
/// not return in them: nothing may be written to a file before.
[[nodiscard]] std::unique_ptr<Workers> workersFor(int count, std::function<JobResult(int)> work);

} // namespace palmer
