// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commandline/jobs.h"

#include "commandline/streams.h"
#include "system/streams.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <thread>

namespace palmer {

namespace {

void printWhat(const FinishedJob &finished, bool parted) {
    std::fwrite(finished.errors.constData(), 1, static_cast<std::size_t>(finished.errors.size()), stderr);
    if (!finished.printed.isEmpty())
        printOut((parted ? QByteArray("\n") : QByteArray()) + finished.printed);
}

} // namespace

void showProgress(int done, int count) {
    if (errorsGoToTerminal())
        std::fputs(("\r" + std::to_string(done) + " / " + std::to_string(count)).c_str(), stderr);
}

void clearProgress() {
    if (errorsGoToTerminal())
        std::fputs("\r\x1b[K", stderr);
}

int defaultJobs() {
    return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

void eachJob(int count, int jobs, const Jobs &tell) {
    if (count == 1) {
        tell.heard(0, tell.work(0));
        return;
    }
    const std::unique_ptr<Workers> workers = workersFor(count, tell.work);
    FinishedJobs ended; ///< not reported yet
    bool hasPrinted = false;
    int next = 0;
    while (next < count) {
        if (workers->keepUp(jobs)) {
            workers->listen(ended);
        } else if (!ended.contains(next)) { // no process available: process it here
            tell.heard(next, tell.work(next));
            ++next;
        }
        for (auto one = ended.find(next); one != ended.end(); one = ended.find(next)) {
            clearProgress();
            if (one->second) {
                printWhat(*one->second, tell.parted && hasPrinted);
                hasPrinted = hasPrinted || !one->second->printed.isEmpty();
            }
            tell.heard(next, one->second ? one->second->result : JobResult{tell.broken(next), {}});
            ended.erase(one);
            ++next;
        }
        showProgress(next, count);
    }
    clearProgress();
}

} // namespace palmer
