#include "ui/verdictmark.h"

#include "ui/windowlanguage.h"

namespace palmer::ui {

VerdictMark verdictMark(std::optional<Verdict> verdict) {
    if (!verdict)
        return {};
    const Language &language = windowLanguage();
    switch (*verdict) {
    case Verdict::conforms:
        return {QStringLiteral("check"), Token::ok, language.text(REPORT_TEXT("report", "conforms"))};
    case Verdict::notProven:
        return {QStringLiteral("ques"), Token::unsure, language.text(REPORT_TEXT("report", "not proven"))};
    case Verdict::doesNotConform:
        return {QStringLiteral("cross"), Token::bad,
                language.text(REPORT_TEXT("report", "does not conform"))};
    }
    return {};
}

Token verdictGround(Verdict verdict) {
    switch (verdict) {
    case Verdict::conforms:
        return Token::okGround;
    case Verdict::notProven:
        return Token::unsureGround;
    case Verdict::doesNotConform:
        break;
    }
    return Token::badGround;
}

} // namespace palmer::ui
