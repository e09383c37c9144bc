// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "language/entry.h"

#include "kernel/words/unit.h"
#include "language/language.h"

#include <QDate>
#include <QRegularExpression>
#include <QTime>
#include <algorithm>
#include <array>
#include <cmath>

namespace palmer {
namespace {

constexpr Text notANumber = REPORT_TEXT("report", "not a number");
constexpr Text beyondNumbers = REPORT_TEXT("report", "larger than any number");
constexpr Text tooManyDigits = REPORT_TEXT("report", "more than 21 digits before the decimal mark");
constexpr double mostToType = 1e21; // beyond it numbers are shown with an exponent, which nobody can type
constexpr Text notTwoNumbers = REPORT_TEXT("report", "two numbers are asked for, such as −10 … 1590");
constexpr Text notAscending = REPORT_TEXT("report", "the first number is not the smaller one");
constexpr Text notADate = REPORT_TEXT("report", "not a date such as 2026-03-12, 12.03.2026 or 12 March 2026");
constexpr Text notATime = REPORT_TEXT("report", "not a time");

constexpr Text otherUnit = REPORT_TEXT("report", "another unit than the one shown");
constexpr Text withExponent = REPORT_TEXT("report", "a power of ten: type all digits");

/// "1e99", "2.5E-3": a number as programs write it.
bool isWithExponent(QStringView text) {
    static const QRegularExpression form(QStringLiteral("^[-+]?\\d+([.,]\\d*)?[eE][-+]?\\d+$"));
    return form.match(text.toString()).hasMatch();
}

bool isDigit(QChar c) {
    return c >= u'0' && c <= u'9';
}

/// The unit that ends a number: "5 um", "2in"; null if there is none.
const Unit *unitAfter(QStringView text) {
    const auto last = std::find_if(text.rbegin(), text.rend(), isDigit);
    const std::string end = text.last(last - text.rbegin()).trimmed().toString().toStdString();
    if (last == text.rend() || end.empty())
        return nullptr;
    const Unit *unit = unitOf(end);
    return unit ? unit : unitOfSign(end);
}

NumberEntry refused(const Text &reason) {
    return {{}, reason};
}

/// True if spaces separate the integer digits of a number into groups of three.
bool isGroupedWell(QStringView number) {
    const auto end =
        std::find_if(number.begin(), number.end(), [](QChar c) { return c == u'.' || c == u','; });
    bool grouped = false;
    qsizetype digits = 0;
    for (const QChar c : number.first(end - number.begin())) {
        if (!c.isSpace()) {
            digits += isDigit(c) ? 1 : 0;
            continue;
        }
        if (digits == 0 || (grouped ? digits != 3 : digits > 3))
            return false;
        grouped = true;
        digits = 0;
    }
    return (!grouped || digits == 3) && std::none_of(end, number.end(), [](QChar c) { return c.isSpace(); });
}

MomentEntry day(int year, int month, int dayOfMonth) {
    const QDate date(year, month, dayOfMonth);
    if (!date.isValid() || year < 1000 || year > 9999)
        return {{}, Message{notADate}};
    return {date.toString(Qt::ISODate).toStdString(), {}};
}

/// Returns 1 … 12 for the name of a month in one of the languages, or its first three letters or more;
/// otherwise 0.
int monthOf(const QString &name) {
    if (name.size() < 3)
        return 0;
    for (const Language::Id id : {Language::Id::french, Language::Id::english}) {
        const Language language(id);
        int found = 0;
        int matches = 0;
        for (int month = 1; month <= 12; ++month) {
            // "2", no-break space, month, space, "2000"
            const QString written = language.date(QDate(2000, month, 2).toString(Qt::ISODate).toStdString());
            if (!written.section(QChar(u'\u00A0'), 1)
                     .section(u' ', 0, 0)
                     .startsWith(name, Qt::CaseInsensitive))
                continue;
            found = month;
            ++matches;
        }
        if (matches == 1) // "jui" may be juin or juillet
            return found;
    }
    return 0;
}

} // namespace

NumberEntry enteredNumber(QStringView typed, Quantity quantity, const DisplayUnits &units) {
    QStringView trimmed = typed.trimmed();
    const QString unit = QString::fromUtf8(shownUnit(quantity, units).sign);
    if (!unit.isEmpty() && trimmed.endsWith(unit)) {
        trimmed = trimmed.chopped(unit.size()).trimmed();
    } else if (const Unit *other = unit.isEmpty() ? nullptr : unitAfter(trimmed)) {
        if (unit != QString::fromUtf8(other->sign))
            return refused(otherUnit);
        trimmed = trimmed.chopped(QLatin1StringView(other->word).size()).trimmed(); // "um"
    }
    if (trimmed.isEmpty())
        return {};
    std::string plain;
    int commas = 0;
    int points = 0;
    for (const QChar c : trimmed) {
        if (isDigit(c))
            plain += c.toLatin1();
        else if (c == u'.' || c == u',')
            plain += '.', ++(c == u',' ? commas : points);
        else if ((c == u'-' || c == u'\u2212' || c == u'\u2013') && plain.empty())
            plain += '-';
        else if (c == u'+' && plain.empty())
            continue;
        else if (!c.isSpace())
            return refused(isWithExponent(trimmed) ? withExponent : notANumber);
    }
    if (commas + points > 1)
        return refused(commas > 0 && points > 0 ? REPORT_TEXT("report", "comma and point in one number")
                       : commas > 1             ? REPORT_TEXT("report", "two commas")
                                                : REPORT_TEXT("report", "two points"));
    if (std::none_of(plain.begin(), plain.end(), [](char c) { return c >= '0' && c <= '9'; }) ||
        !isGroupedWell(trimmed))
        return refused(notANumber);
    const double value = fromShown(plain, quantity, units);
    if (!std::isfinite(value))
        return refused(beyondNumbers);
    return std::abs(value) * unitScale(quantity, units) < mostToType ? NumberEntry{value, {}}
                                                                     : refused(tooManyDigits);
}

IntervalEntry enteredInterval(QStringView typed, Quantity quantity, const DisplayUnits &units) {
    const QString text = typed.trimmed().toString();
    if (text.isEmpty())
        return {};
    static const QRegularExpression between(QStringLiteral("\\s*(?:…|\\.\\.+|;|\\bto\\b|\\bà\\b)\\s*"),
                                            QRegularExpression::UseUnicodePropertiesOption);
    static const QRegularExpression dash(QStringLiteral("\\s[-\u2013\u2014]\\s"));
    const QStringList parts = text.split(text.contains(between) ? between : dash);
    if (parts.size() != 2)
        return {{}, notTwoNumbers};
    const NumberEntry from = enteredNumber(parts[0], quantity, units);
    const NumberEntry to = enteredNumber(parts[1], quantity, units);
    if (!from.value || !to.value)
        return {{}, notTwoNumbers};
    if (!(*from.value < *to.value))
        return {{}, notAscending};
    return {Interval{*from.value, *to.value}, {}};
}

MomentEntry enteredDate(QStringView typed, const Language &language) {
    const QString text = typed.trimmed().toString();
    if (text.isEmpty())
        return {};
    const QString word = text.toLower().replace(u'\u2019', u'\'');
    if (word == u"today" || word == u"aujourd'hui")
        return {QDate::currentDate().toString(Qt::ISODate).toStdString(), {}};
    static const QRegularExpression yearFirst(QStringLiteral("^(\\d{4})[-./](\\d{1,2})[-./](\\d{1,2})$"));
    static const QRegularExpression yearLast(
        QStringLiteral("^(\\d{1,2})([-./ ])(\\d{1,2})[-./ ](\\d{2}|\\d{4})$"));
    static const QRegularExpression inWords(
        QStringLiteral("^(\\d{1,2})(?:er)?\\s+(\\p{L}+)\\.?\\s+(\\d{4})$"),
        QRegularExpression::UseUnicodePropertiesOption);
    if (const auto match = yearFirst.match(text); match.hasMatch())
        return day(match.captured(1).toInt(), match.captured(2).toInt(), match.captured(3).toInt());
    if (const auto match = inWords.match(text); match.hasMatch())
        return day(match.captured(3).toInt(), monthOf(match.captured(2)), match.captured(1).toInt());
    const auto match = yearLast.match(text);
    if (!match.hasMatch())
        return {{}, Message{notADate}};
    constexpr int firstOfTwoDigits = 70;
    const int digits = match.captured(4).toInt();
    const int year =
        match.captured(4).size() > 2 ? digits : digits + (digits < firstOfTwoDigits ? 2000 : 1900);
    const int first = match.captured(1).toInt();
    const int second = match.captured(3).toInt();
    const bool isWrittenBothWays =
        language.id() == Language::Id::english && (match.captured(2) == u"/" || match.captured(2) == u"-");
    const MomentEntry dayFirst = day(year, second, first);
    const MomentEntry monthFirst = isWrittenBothWays ? day(year, first, second) : MomentEntry();
    if (dayFirst.value && monthFirst.value && first != second)
        return {{},
                Message{REPORT_TEXT("report", "%1 or %2? Type one of them"),
                        {language.date(*dayFirst.value).toStdString(),
                         language.date(*monthFirst.value).toStdString()}}};
    return dayFirst.value || !monthFirst.value ? dayFirst : monthFirst;
}

MomentEntry enteredTime(QStringView typed) {
    const QString text = typed.trimmed().toString();
    if (text.isEmpty())
        return {};
    static const QRegularExpression hoursAndMinutes(QStringLiteral("^(\\d{1,2})\\s*[:hH]\\s*(\\d{2})$"),
                                                    QRegularExpression::UseUnicodePropertiesOption);
    const auto match = hoursAndMinutes.match(text);
    const QTime time(match.captured(1).toInt(), match.captured(2).toInt());
    if (!match.hasMatch() || !time.isValid())
        return {{}, Message{notATime}};
    return {time.toString(QStringLiteral("HH:mm")).toStdString(), {}};
}

} // namespace palmer
