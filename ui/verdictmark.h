// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/accordance.h"
#include "kernel/evaluation/parameter.h"
#include "ui/theme.h"

#include <QString>
#include <optional>

namespace palmer::ui {

/// Display of a verdict: a line icon, its colour and the accompanying word.
struct VerdictMark {
    QString icon; ///< empty if nothing is to be decided
    Token colour = Token::secondaryText;
    QString word; ///< in the window's language

    bool operator==(const VerdictMark &) const = default;
};

/// The verdict on one result; empty without verdict.
[[nodiscard]] VerdictMark verdictMark(std::optional<Verdict> verdict);

// A verdict consists of two independent statements.

/// The first: conformity with the limits. `anyLimit`: limits were agreed, even if none applies to the test.
[[nodiscard]] VerdictMark limitsMark(std::optional<Verdict> verdict, bool anyLimit);

/// The second: whether the test was carried out as its edition requires.
[[nodiscard]] VerdictMark accordanceMark(Accordance accordance);

/// Background of a chip of that colour.
[[nodiscard]] Token groundOf(Token colour);

} // namespace palmer::ui
