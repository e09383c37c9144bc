// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/accordance.h"
#include "kernel/evaluation/parameter.h"
#include "ui/theme.h"

#include <QString>
#include <optional>

namespace palmer::ui {

/// How a statement of a verdict is shown: a line icon, its colour, and the word that always goes with it.
struct VerdictMark {
    QString icon; ///< empty: nothing is to be decided
    Token colour = Token::secondaryText;
    QString word; ///< in the window's language

    bool operator==(const VerdictMark &) const = default;
};

/// The verdict on one result; empty without verdict.
[[nodiscard]] VerdictMark verdictMark(std::optional<Verdict> verdict);

// A verdict is two statements that do not depend on each other.

/// The first: the limits. `anyLimit`: limits were agreed, though they may not hold for the test.
[[nodiscard]] VerdictMark limitsMark(std::optional<Verdict> verdict, bool anyLimit);

/// The second: whether the test was carried out as its edition asks.
[[nodiscard]] VerdictMark accordanceMark(Accordance accordance);

/// The ground of a chip that says something in that colour.
[[nodiscard]] Token groundOf(Token colour);

} // namespace palmer::ui
