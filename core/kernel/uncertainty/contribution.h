// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/words/message.h"

#include <optional>
#include <string>
#include <vector>

namespace palmer {

/// An input of a budget that is not stated or impossible. `key` is that of the file.
struct InputDefect {
    const char *key = "";
    Text name;
    bool impossible = false; ///< stated, but negative, not finite, or refused for this kind of axis

    bool operator==(const InputDefect &) const = default;
};

/// One row of an uncertainty budget: the contribution of a quantity to the uncertainty of the results, k = 2.
struct Contribution {
    const char *id = "";
    Text name;
    Message inputs;                 ///< the formula with its numbers
    std::optional<double> expanded; ///< U, mm (rotary: degrees); null: unknown, see `defects`
    bool applies = true;            ///< false: stated not to exist; U is 0 and a dash is printed
    std::vector<InputDefect> defects;

    bool operator==(const Contribution &) const = default;
};

/// Returns the contributions, largest first; unknown ones precede, those that do not apply come last.
[[nodiscard]] std::vector<const Contribution *> bySize(const std::vector<Contribution> &contributions);

/// Returns the share of a contribution in the sum of all squares, 0 … 1; 0 if nothing is known.
[[nodiscard]] double shareOf(const Contribution &contribution,
                             const std::vector<Contribution> &contributions);

/// Returns the largest known contribution, if it makes up at least 5 % of the sum of squares, as the one to
/// improve first; otherwise null. Meaningful only for a complete budget.
[[nodiscard]] const Contribution *toImproveFirst(const std::vector<Contribution> &contributions);

} // namespace palmer
