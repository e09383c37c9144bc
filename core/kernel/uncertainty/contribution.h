// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/words/message.h"

#include <optional>
#include <string>
#include <vector>

namespace palmer {

/// An input of a budget that is not stated, or cannot be what it is stated to be. `key` of the file.
struct InputDefect {
    const char *key = "";
    Text name;
    bool impossible = false; ///< stated, but negative, not finite, or refused for this kind of axis

    bool operator==(const InputDefect &) const = default;
};

/// One line of an uncertainty budget: what a quantity adds to the uncertainty of the results, k = 2.
struct Contribution {
    const char *id = "";
    Text name;
    Message inputs;                 ///< the formula with the numbers put in
    std::optional<double> expanded; ///< U, mm (rotary: degrees); null: unknown, `defects` say why
    bool applies = true;            ///< false: stated not to exist; U is 0 and a dash is printed
    std::vector<InputDefect> defects;

    bool operator==(const Contribution &) const = default;
};

/// The contributions of a budget, the largest first; the unknown ones before, those that do not apply last.
[[nodiscard]] std::vector<const Contribution *> bySize(const std::vector<Contribution> &contributions);

/// Part of a contribution in the sum of the squares of all, 0 … 1; 0 where nothing is known.
[[nodiscard]] double shareOf(const Contribution &contribution,
                             const std::vector<Contribution> &contributions);

/// What is to be improved first: the largest of the known contributions, if it makes at least 5 % of the sum
/// of the squares. Null: nothing stands out. Means something only for a budget that is complete.
[[nodiscard]] const Contribution *toImproveFirst(const std::vector<Contribution> &contributions);

} // namespace palmer
