#pragma once

#include "kernel/evaluation/parameter.h"
#include "ui/theme.h"

#include <QString>
#include <optional>

namespace palmer::ui {

/// How the state of a test is shown: a line icon, its colour, and the word that always goes with it.
struct VerdictMark {
    QString icon; ///< empty: nothing is to be decided
    Token colour = Token::secondaryText;
    QString word; ///< in the window's language

    bool operator==(const VerdictMark &) const = default;
};

[[nodiscard]] VerdictMark verdictMark(std::optional<Verdict> verdict);

/// The ground of a chip that says the verdict.
[[nodiscard]] Token verdictGround(Verdict verdict);

} // namespace palmer::ui
