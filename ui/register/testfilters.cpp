// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/testfilters.h"

#include "document/resultwords.h"
#include "report/words/accordancetext.h"
#include "report/words/wording.h"
#include "ui/windowlanguage.h"

namespace palmer::ui {

namespace {

/// Text of the enumerator that has a word in files; empty if none has it.
template <class Enumeration>
Text textOfWord(const QString &word, Text (*text)(Enumeration)) {
    const auto value = ofFileWord<Enumeration>(word.toStdString());
    return value ? text(*value) : Text{};
}

Text textOfLimits(const QString &word) {
    for (const auto &row : fileWords<Verdict>) {
        if (word == QLatin1StringView(limitsWord(row.value)))
            return limitsText(row.value, true);
    }
    return limitsText(std::nullopt, false);
}

} // namespace

QString TestFilters::valueOf(Property property, const ListedTest &listed) {
    const RegisteredTest &test = listed.test;
    switch (property) {
    case axis:
        return QString::fromStdString(test.axis);
    case since:
        return QString::fromStdString(test.date.value_or("")).left(4);
    case edition:
        return QString::fromStdString(test.edition);
    case purpose:
        return QString::fromLatin1(fileWord(test.purpose));
    case role:
        return QString::fromLatin1(fileWord(test.role));
    case limits:
        return QString::fromLatin1(limitsWord(test.verdict));
    case accordance:
        return QString::fromLatin1(fileWord(test.accordance));
    case count:
        break;
    }
    return {};
}

QString TestFilters::nameOf(Property property, const QString &value) {
    Text text;
    switch (property) {
    case since:
        return tr("since %1").arg(value);
    case purpose:
        text = textOfWord<Purpose>(value, purposeText);
        break;
    case role:
        text = textOfWord<TestRole>(value, roleText);
        break;
    case limits:
        text = textOfLimits(value);
        break;
    case accordance:
        text = textOfWord<Accordance>(value, accordanceWords);
        break;
    default:
        return value.isEmpty() ? tr("not stated") : value;
    }
    return text.empty() ? tr("not stated") : windowLanguage().text(text);
}

bool TestFilters::passes(Property property, const ListedTest &test) const {
    const QString &wanted = chosen.at(property);
    const QString value = valueOf(property, test);
    return wanted.isEmpty() || (property == since ? value >= wanted : value == wanted);
}

bool TestFilters::passes(const ListedTest &test) const {
    bool all = true;
    for (int i = 0; all && i < count; ++i)
        all = passes(static_cast<Property>(i), test);
    return all;
}

} // namespace palmer::ui
