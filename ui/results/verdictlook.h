#pragma once

#include "kernel/evaluation/parameter.h"
#include "ui/theme.h"

namespace palmer::ui {

/// Mark and colours of a verdict; the word stands beside it, always.
struct VerdictLook {
    const char *icon;
    Token colour;
    Token ground;
};

[[nodiscard]] inline VerdictLook verdictLook(Verdict verdict) {
    switch (verdict) {
    case Verdict::conforms:
        return {"check", Token::ok, Token::okGround};
    case Verdict::notProven:
        return {"ques", Token::unsure, Token::unsureGround};
    case Verdict::doesNotConform:
        break;
    }
    return {"cross", Token::bad, Token::badGround};
}

} // namespace palmer::ui
