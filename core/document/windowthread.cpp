// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/windowthread.h"

#include "kernel/measurement/testfacts.h"

#include <cassert>

namespace palmer {

namespace {

bool &paintsWindows() {
    thread_local bool paints = false;
    return paints;
}

} // namespace

WindowThread::WindowThread() {
    paintsWindows() = true;
}

WindowThread::~WindowThread() {
    paintsWindows() = false;
}

void requireBackground([[maybe_unused]] std::size_t readings) {
    assert((!paintsWindows() || readings <= fewReadings) && "long work on the thread of the windows");
}

void requireBackground(const Document &document) {
    std::size_t readings = 0;
    for (const TestPointer &test : document.tests)
        readings += readingsOf(*test);
    requireBackground(readings);
}

} // namespace palmer
