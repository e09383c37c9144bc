// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palmer::benchmarks {

/// Processor time of this thread so far, ms.
[[nodiscard]] double processorTime();

/// How long the window was kept from its user: from one look for events to the next, on the thread of the
/// program's start. Counted are the turns since this was made; one at a time.
class LongestTurn {
public:
    LongestTurn();
    ~LongestTurn();
    LongestTurn(const LongestTurn &) = delete;
    LongestTurn &operator=(const LongestTurn &) = delete;

    /// Processor time of the thread, ms: others that keep the machine busy do not count.
    [[nodiscard]] double longest() const;
};

} // namespace palmer::benchmarks
