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

} // namespace palmer::ui
