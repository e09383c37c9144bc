// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commandline/optionvalues.h"

#include "document/filewords.h"
#include "document/setfield.h"
#include "language/entry.h"

#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace palmer {

namespace {

/// An option as it is typed, or an argument as the help calls it (MONTHS).
std::string typed(const char *option) {
    const bool isArgument = *option >= 'A' && *option <= 'Z';
    return (isArgument ? "" : "--") + std::string(option);
}

Number shown(double value) {
    return {value, Quantity::number};
}

QString bare(const QString &word) {
    QString result = word.toLower();
    result.remove(u' ');
    return result;
}

/// True if the part matches whole words and numbers of the designation: "2006" matches, "006" does not.
bool isPartOf(const QString &part, const QString &designation) {
    // At `at` between two characters; "ISO230" has a word and a number, as blanks are removed.
    const auto isBorder = [&designation](qsizetype at) {
        if (at <= 0 || at >= designation.size())
            return true;
        const QChar before = designation[at - 1];
        const QChar after = designation[at];
        return !(before.isLetter() && after.isLetter()) && !(before.isDigit() && after.isDigit());
    };
    for (qsizetype at = designation.indexOf(part); at >= 0; at = designation.indexOf(part, at + 1)) {
        if (isBorder(at) && isBorder(at + part.size()))
            return true;
    }
    return false;
}

} // namespace

void refuse(const char *option, const QString &given, const std::string &form) {
    throw UsageError(
        {REPORT_TEXT("report", "%1 cannot be %2; expected %3"), {typed(option), given.toStdString(), form}});
}

void requireClearComma(const std::string &option, const QString &given) {
    if (mayBeGrouped(given.toStdString()))
        throw UsageError({REPORT_TEXT("report", "%1 cannot be %2: the comma may stand before thousands or "
                                                "before decimals; write it without"),
                          {option, given.toStdString()}});
}

double numberGiven(const char *option, const QString &given) {
    static const QRegularExpression power(QStringLiteral("^[^eE]+[eE][+-]?[0-9]{1,3}$"));
    requireClearComma(typed(option), given);
    std::optional<double> value = enteredNumber(given, Quantity::number).value;
    if (bool isNumber = false; power.match(given).hasMatch()) {
        value = QString(given).replace(u',', u'.').toDouble(&isNumber);
        value = isNumber ? value : std::nullopt;
    }
    if (!value || !std::isfinite(*value))
        throw UsageError({REPORT_TEXT("report", "%1 cannot be %2; expected a number"),
                          {typed(option), given.toStdString()}});
    return *value;
}

double numberBetween(const char *option, const QString &given, double least, double most) {
    const double value = numberGiven(option, given);
    if (value < least || value > most)
        throw UsageError({REPORT_TEXT("report", "%1 cannot be %2; expected a number from %3 to %4"),
                          {typed(option), given.toStdString(), shown(least), shown(most)}});
    return value;
}

double numberAbove(const char *option, const QString &given, double bound) {
    const double value = numberGiven(option, given);
    if (!(value > bound))
        throw UsageError({REPORT_TEXT("report", "%1 cannot be %2; expected a number greater than %3"),
                          {typed(option), given.toStdString(), shown(bound)}});
    return value;
}

std::optional<double> numberOf(const Invocation &invocation, const char *option) {
    const auto given = invocation.value(option);
    return given ? std::optional(numberGiven(option, *given)) : std::nullopt;
}

Interval intervalGiven(const char *option, const QString &given) {
    const QStringList ends = given.split(u':');
    if (ends.size() != 2)
        refuse(option, given, "FROM:TO");
    const Interval interval{numberGiven(option, ends[0]), numberGiven(option, ends[1])};
    if (!(interval.to > interval.from))
        refuse(option, given, "FROM:TO");
    return interval;
}

std::optional<long long> wholeGiven(const QString &given) {
    bool isNumber = false;
    const long long number = given.toLongLong(&isNumber);
    if (isNumber)
        return number;
    static const QRegularExpression power(QStringLiteral("^[0-9]+([.,][0-9]+)?[eE][+]?[0-9]{1,2}$"));
    constexpr double exact = 9e15; // a double represents all integers up to here
    const double value =
        power.match(given).hasMatch() ? QString(given).replace(u',', u'.').toDouble(&isNumber) : 0;
    if (!isNumber || value > exact || value != std::floor(value))
        return {};
    return static_cast<long long>(value);
}

long long wholeBetween(const char *option, const QString &given, long long least, long long most) {
    const std::optional<long long> number = wholeGiven(given);
    if (!number || *number < least || *number > most)
        throw UsageError({REPORT_TEXT("report", "%1 cannot be %2; expected a whole number from %3 to %4"),
                          {typed(option), given.toStdString(), std::to_string(least), std::to_string(most)}});
    return *number;
}

CsvMarks csvMarks(const Invocation &invocation) {
    const auto mark = invocation.value("decimal-mark");
    if (!mark)
        return {};
    return {*mark == QLatin1StringView("comma") ? ',' : '.', "\xEF\xBB\xBF"};
}

std::size_t testIndex(const Invocation &invocation, std::size_t count) {
    return testIndex(invocation.value("test").value_or(QStringLiteral("1")), count);
}

std::size_t testIndex(const QString &word, std::size_t count) {
    bool isNumber = false;
    const uint number = word.toUInt(&isNumber);
    if (!isNumber || number < 1 || number > count)
        throw UsageError({REPORT_TEXT("report", "there is no test %1; the file has %2"),
                          {word.toStdString(), Number{static_cast<double>(count), Quantity::count}}});
    return number - 1;
}

std::optional<std::int64_t> seedOf(const Invocation &invocation) {
    const auto given = invocation.value("seed");
    if (!given)
        return std::nullopt;
    return wholeBetween("seed", *given, 0, std::numeric_limits<std::int64_t>::max());
}

const Edition *editionAsked(const Invocation &invocation, std::optional<Kind> kind) {
    const auto word = invocation.value("edition");
    return word ? editionCalled(*word, kind) : nullptr;
}

const Edition *editionCalled(const QString &word, std::optional<Kind> kind) {
    const QString asked = bare(word);
    const auto known = kind ? editionsOf(*kind) : editions();
    std::vector<const Edition *> found;
    for (const Edition *edition : known) {
        const QString designation = bare(QString::fromUtf8(edition->word));
        if (designation == asked)
            return edition;
        if (!asked.isEmpty() && asked.front().isLetterOrNumber() && isPartOf(asked, designation))
            found.push_back(edition);
    }
    if (found.size() == 1)
        return found.front();
    if (found.empty())
        throw UsageError(
            {REPORT_TEXT("report", "unknown edition %1; known: %2"), {word.toStdString(), wordsOf(known)}});
    throw UsageError({REPORT_TEXT("report", "the edition %1 may be one of these: %2"),
                      {word.toStdString(), wordsOf(found)}});
}

void requireTestOf(const Edition &edition, const Document &document) {
    const bool has = std::ranges::any_of(
        document.tests, [&](const TestPointer &test) { return kindOf(*test) == edition.kind; });
    if (!has)
        throw UsageError(
            {REPORT_TEXT("report", "no test of the file is of the kind of %1"), {std::string(edition.word)}});
}

std::optional<Dialect> dialectOf(const Invocation &invocation, const char *option,
                                 std::optional<Dialect> otherwise) {
    const auto word = invocation.value(option);
    if (!word)
        return otherwise;
    return std::ranges::find_if(
               dialects(), [&](const DialectName &each) { return *word == QLatin1StringView(each.word); })
        ->dialect; // parseArguments() has checked the word
}

} // namespace palmer
