// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commandline/progressline.h"

#include "system/streams.h"

#include <cstdio>

namespace palmer {

namespace {

void write(const QString &text) {
    const QByteArray line = "\r\x1b[K" + text.toUtf8();
    std::fwrite(line.constData(), 1, static_cast<std::size_t>(line.size()), stderr);
    std::fflush(stderr);
}

} // namespace

ProgressLine::ProgressLine(const Language &language)
    : m_language(language)
    , m_terminal(errorsGoToTerminal()) {}

ProgressLine::~ProgressLine() {
    if (m_shown)
        write(QString());
}

void ProgressLine::show(const SimulationProgress &progress) {
    constexpr std::chrono::milliseconds pause(200);
    const auto now = std::chrono::steady_clock::now();
    if (!m_terminal || now - m_last < pause)
        return;
    m_last = now;
    m_shown = true;
    const auto number = [](long long value) { return Number{static_cast<double>(value), Quantity::count}; };
    write(m_language.sentence(
        progress.of ? Message{REPORT_TEXT("report", "Monte Carlo: %1 of %2 trials"),
                              {number(progress.trials), number(*progress.of)}}
                    : Message{REPORT_TEXT("report", "Monte Carlo: %1 trials"), {number(progress.trials)}}));
}

} // namespace palmer
