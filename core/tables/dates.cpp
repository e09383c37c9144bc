// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tables/dates.h"

#include "tables/folded.h"

#include <QDate>
#include <QRegularExpression>
#include <QTime>
#include <array>

namespace palmer {

namespace {

/// Beginnings of the months, folded, in five languages, as long as needed to distinguish them.
constexpr std::array<std::array<std::string_view, 5>, 12> monthWords{{
    {"jan", "janv", "gen", "ene", "janner"},
    {"feb", "fev", "febr", "feb", "feb"},
    {"mar", "mars", "marz", "maerz", "marzo"},
    {"apr", "avr", "abr", "apr", "apr"},
    {"may", "mai", "mag", "may", "mayo"},
    {"jun", "juin", "giu", "jun", "juni"},
    {"jul", "juil", "lug", "jul", "juli"},
    {"aug", "aout", "ago", "aug", "agosto"},
    {"sep", "sept", "set", "sep", "sep"},
    {"oct", "okt", "ott", "oct", "oct"},
    {"nov", "nov", "nov", "nov", "nov"},
    {"dec", "dez", "dic", "dec", "dic"},
}};

int monthNamed(const QString &name) {
    const std::string low = folded(name.toStdString());
    int found = 0;
    std::size_t longest = 2;
    for (std::size_t m = 0; m < monthWords.size(); ++m) {
        for (const std::string_view word : monthWords[m]) {
            if (word.size() > longest && low.starts_with(word)) {
                found = static_cast<int>(m) + 1;
                longest = word.size();
            }
        }
    }
    return found;
}

std::optional<std::string> validDate(int year, int month, int day) {
    const QDate date(year < 100 ? 2000 + year : year, month, day);
    return date.isValid() ? std::optional(date.toString(Qt::ISODate).toStdString()) : std::nullopt;
}

const QRegularExpression &numericDate() {
    static const QRegularExpression pattern(QStringLiteral(
        R"((?<![\d.])(?:(\d{4})[-/.](\d{1,2})[-/.](\d{1,2})|(\d{1,2})(\.\s?|[-/])(\d{1,2})\5(\d{4}))(?![\d.]))"));
    return pattern;
}

} // namespace

std::optional<std::string> isoDate(std::string_view text) {
    const QString line = QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
    if (const auto match = numericDate().match(line); match.hasMatch()) {
        if (!match.captured(1).isEmpty())
            return validDate(match.captured(1).toInt(), match.captured(2).toInt(), match.captured(3).toInt());
        const int first = match.captured(4).toInt();
        const int second = match.captured(6).toInt();
        const int year = match.captured(7).toInt();
        if (match.captured(5).startsWith(QLatin1Char('.')) || first > 12 || first == second)
            return validDate(year, second, first);
        return second > 12 ? validDate(year, first, second) : std::nullopt;
    }
    static const QRegularExpression named(
        QStringLiteral(
            R"((?<!\d)(\d{1,2})(?:st|nd|rd|th|er)?[.]?[\s-]+(?:(?:de|of)\s+)?(\p{L}{3,})[.,]?[\s-]+(?:de\s+)?(\d{4})(?!\d))"
            R"(|(?<!\p{L})(\p{L}{3,})\.?\s+(\d{1,2})(?:st|nd|rd|th)?)"
            R"((?:\s+\d{1,2}:\d{2}(?::\d{2})?(?:\s+\p{L}{2,5})?)?,?\s+(\d{4})(?!\d))"), // 13 March, March 13
                                                                                        // 13
        QRegularExpression::UseUnicodePropertiesOption);
    for (auto all = named.globalMatch(line); all.hasNext();) {
        const auto match = all.next();
        const bool dayFirst = !match.captured(1).isEmpty();
        const int month = monthNamed(match.captured(dayFirst ? 2 : 4));
        if (month != 0)
            return validDate(match.captured(dayFirst ? 3 : 6).toInt(), month,
                             match.captured(dayFirst ? 1 : 5).toInt());
    }
    return {};
}

bool hasTwoReadings(std::string_view date) {
    static const QRegularExpression pattern(
        QStringLiteral(R"((?<!\d)(\d{1,2})([-/.])(\d{1,2})\2(\d{4}|\d{2})(?!\d))"));
    const auto match = pattern.match(QString::fromUtf8(date.data(), static_cast<qsizetype>(date.size())));
    const int first = match.captured(1).toInt();
    const int second = match.captured(3).toInt();
    const int year = match.captured(4).toInt();
    return match.hasMatch() && (match.captured(4).size() == 2 ||
                                (validDate(year, first, second) && validDate(year, second, first)));
}

std::optional<std::string> compactDate(std::string_view text) {
    static const QRegularExpression pattern(
        QStringLiteral(R"(^\s*((?:19|20)\d{2})(\d{2})(\d{2})(?:\s.*)?$)"));
    const auto match = pattern.match(QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size())));
    const auto part = [&](int group) { return match.captured(group).toInt(); };
    // "20122012" could be the 20th of December, too.
    const bool isEither = validDate(part(2) * 100 + part(3), part(1) % 100, part(1) / 100) &&
                          part(2) * 100 + part(3) >= 1900 && part(2) * 100 + part(3) < 2100;
    return match.hasMatch() && !isEither ? validDate(part(1), part(2), part(3)) : std::nullopt;
}

std::optional<std::string> timeOfDay(std::string_view text) {
    static const QRegularExpression pattern(
        QStringLiteral(R"((?<![\d:])(\d{1,2}):(\d{2})(?::\d{2}(?:[.,]\d+)?)?(?![\d:])\s*([ap])?\.?(?:m\b)?)"),
        QRegularExpression::CaseInsensitiveOption);
    // "14h30", "14.30 Uhr"
    static const QRegularExpression named(
        QStringLiteral(R"((?<![\d:.,])(\d{1,2})(?:\s?h\s?(\d{2})(?!\d|\s?min)|\.(\d{2})\s?Uhr\b))"),
        QRegularExpression::CaseInsensitiveOption);
    const QString line = QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
    const auto match = pattern.match(line);
    if (const auto other = named.match(line); !match.hasMatch() && other.hasMatch()) {
        const QTime time(other.captured(1).toInt(), (other.captured(2) + other.captured(3)).toInt());
        return time.isValid() ? std::optional(time.toString(QStringLiteral("HH:mm")).toStdString())
                              : std::nullopt;
    }
    if (!match.hasMatch())
        return {};
    const QString half = match.captured(3).toLower();
    int hour = match.captured(1).toInt();
    if (!half.isEmpty() && (hour < 1 || hour > 12))
        return {};
    if (!half.isEmpty())
        hour = hour % 12 + (half == QLatin1StringView("p") ? 12 : 0);
    const QTime time(hour, match.captured(2).toInt());
    return time.isValid() ? std::optional(time.toString(QStringLiteral("HH:mm")).toStdString())
                          : std::nullopt;
}

bool isDate(std::string_view cell) {
    if (cell.size() < 8 || cell.size() > 10)
        return false;
    std::array<std::size_t, 3> digits{};
    std::size_t part = 0;
    char separator = 0;
    for (const char c : cell) {
        if (c >= '0' && c <= '9') {
            ++digits[part];
        } else if ((c == '-' || c == '.' || c == '/') && (separator == 0 || c == separator) && part < 2) {
            separator = c;
            ++part;
        } else {
            return false;
        }
    }
    const bool isIso = digits[0] == 4 && digits[2] <= 2;
    const bool isLocal = digits[0] <= 2 && digits[0] > 0 && digits[2] == 4;
    return part == 2 && digits[1] > 0 && digits[1] <= 2 && (isIso || isLocal);
}

std::optional<long> dayOf(std::string_view cell) {
    if (cell.size() < 8 || cell[0] < '0' || cell[0] > '9')
        return {};
    const std::size_t end = cell.find_first_not_of("0123456789-/");
    std::string date(cell.substr(0, end));
    if (!isDate(date) || (date[4] != '-' && date[4] != '/'))
        return {};
    for (char &c : date)
        c = c == '/' ? '-' : c;
    const QDate day = QDate::fromString(QString::fromStdString(date), QStringLiteral("yyyy-M-d"));
    return day.isValid() ? std::optional(static_cast<long>(day.toJulianDay() - 2440588)) : std::nullopt;
}

} // namespace palmer
