// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/verdictmark.h"

#include "report/words/wording.h"
#include "ui/windowlanguage.h"

#include <QCoreApplication>

namespace palmer::ui {

namespace {

QString say(const char *text) {
    return QCoreApplication::translate("palmer::ui::VerdictMark", text);
}

} // namespace

VerdictMark verdictMark(std::optional<Verdict> verdict) {
    if (!verdict)
        return {};
    const QString word = windowLanguage().text(verdictText(*verdict));
    switch (*verdict) {
    case Verdict::conforms:
        return {QStringLiteral("check"), Token::ok, word};
    case Verdict::notProven:
        return {QStringLiteral("ques"), Token::unsure, word};
    case Verdict::doesNotConform:
        break;
    }
    return {QStringLiteral("cross"), Token::bad, word};
}

VerdictMark limitsMark(std::optional<Verdict> verdict, bool anyLimit) {
    VerdictMark mark = verdictMark(verdict);
    if (!verdict)
        mark.word = anyLimit
                        ? say(QT_TRANSLATE_NOOP("palmer::ui::VerdictMark", "limits that do not hold here"))
                        : say(QT_TRANSLATE_NOOP("palmer::ui::VerdictMark", "no limit agreed"));
    else if (*verdict == Verdict::conforms)
        mark.word = say(QT_TRANSLATE_NOOP("palmer::ui::VerdictMark", "limits met"));
    else if (*verdict == Verdict::notProven)
        mark.word = say(QT_TRANSLATE_NOOP("palmer::ui::VerdictMark", "limits not proven"));
    else
        mark.word = say(QT_TRANSLATE_NOOP("palmer::ui::VerdictMark", "limits exceeded"));
    return mark;
}

VerdictMark accordanceMark(Accordance accordance) {
    switch (accordance) {
    case Accordance::notChecked:
        return {QStringLiteral("info"), Token::secondaryText,
                say(QT_TRANSLATE_NOOP("palmer::ui::VerdictMark", "text of the edition not available"))};
    case Accordance::no:
        return {QStringLiteral("warn"), Token::bad,
                say(QT_TRANSLATE_NOOP("palmer::ui::VerdictMark", "NOT in accordance with the edition"))};
    case Accordance::notShown:
        return {QStringLiteral("warn"), Token::unsure,
                say(QT_TRANSLATE_NOOP("palmer::ui::VerdictMark", "accordance with the edition not shown"))};
    case Accordance::partly:
        return {QStringLiteral("info"), Token::secondaryText,
                say(QT_TRANSLATE_NOOP("palmer::ui::VerdictMark", "in accordance in part"))};
    case Accordance::yes:
        break;
    }
    return {QStringLiteral("check"), Token::ok,
            say(QT_TRANSLATE_NOOP("palmer::ui::VerdictMark", "in accordance with the edition"))};
}

Token groundOf(Token colour) {
    switch (colour) {
    case Token::ok:
        return Token::okGround;
    case Token::unsure:
        return Token::unsureGround;
    case Token::bad:
        return Token::badGround;
    default:
        return Token::hover;
    }
}

} // namespace palmer::ui
