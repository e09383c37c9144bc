// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "longestturn.h"

#include <algorithm>
#include <csignal>
#include <ctime>
#include <dlfcn.h>
#include <poll.h>
#include <pthread.h>

namespace palmer::benchmarks {

double processorTime() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

} // namespace palmer::benchmarks

namespace {

using palmer::benchmarks::processorTime;

const pthread_t windows = pthread_self();
bool counts = false;
double begun = 0;
double longestSoFar = 0;

/// Between the two calls the thread looks for events.
void endTurn() {
    if (counts && pthread_equal(pthread_self(), windows))
        longestSoFar = std::max(longestSoFar, processorTime() - begun);
}

void beginTurn() {
    if (counts && pthread_equal(pthread_self(), windows))
        begun = processorTime();
}

template <typename Function>
Function next(const char *name) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): so dlsym gives functions
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

} // namespace

// Both event loops that Qt has under Linux wait in one of these; what is behind the signals of its dispatcher
// leaves out all that the loop of GLib does itself.
extern "C" int poll(pollfd *files, nfds_t count, int timeout) {
    static const auto original = next<int (*)(pollfd *, nfds_t, int)>("poll");
    endTurn();
    const int result = original(files, count, timeout);
    beginTurn();
    return result;
}

extern "C" int ppoll(pollfd *files, nfds_t count, const timespec *timeout, const sigset_t *mask) {
    static const auto original = next<int (*)(pollfd *, nfds_t, const timespec *, const sigset_t *)>("ppoll");
    endTurn();
    const int result = original(files, count, timeout, mask);
    beginTurn();
    return result;
}

namespace palmer::benchmarks {

LongestTurn::LongestTurn() {
    longestSoFar = 0;
    begun = processorTime();
    counts = true;
}

LongestTurn::~LongestTurn() {
    counts = false;
}

double LongestTurn::longest() const {
    return longestSoFar;
}

} // namespace palmer::benchmarks
