#include "commands/optionvalues.h"

#include "language/entry.h"

#include <QRegularExpression>
#include <cmath>

namespace palmer {

void refuse(const char *option, const QString &given) {
    throw UsageError(
        {REPORT_TEXT("report", "--%1 cannot be %2"), {std::string(option), given.toStdString()}});
}

double numberGiven(const char *option, const QString &given) {
    // "1,000" is a thousand to some and one to others; "0,125" is not.
    static const QRegularExpression grouped(QStringLiteral("^[+-]?[1-9][0-9]{0,2}(,[0-9]{3})+$"));
    static const QRegularExpression power(QStringLiteral("^[^eE]+[eE][+-]?[0-9]{1,3}$"));
    std::optional<double> value = enteredNumber(given, Quantity::number).value;
    if (bool isNumber = false; power.match(given).hasMatch()) {
        value = QString(given).replace(u',', u'.').toDouble(&isNumber);
        value = isNumber ? value : std::nullopt;
    }
    if (!value || !std::isfinite(*value) || grouped.match(given).hasMatch())
        refuse(option, given);
    return *value;
}

std::optional<double> numberOf(const Invocation &invocation, const char *option) {
    const auto given = invocation.value(QLatin1StringView(option));
    return given ? std::optional(numberGiven(option, *given)) : std::nullopt;
}

std::optional<long long> wholeGiven(const QString &given) {
    bool isNumber = false;
    const long long number = given.toLongLong(&isNumber);
    if (isNumber)
        return number;
    static const QRegularExpression power(QStringLiteral("^[0-9]+([.,][0-9]+)?[eE][+]?[0-9]{1,2}$"));
    constexpr double exact = 9e15; // a double holds all whole numbers up to here
    const double value =
        power.match(given).hasMatch() ? QString(given).replace(u',', u'.').toDouble(&isNumber) : 0;
    if (!isNumber || value > exact || value != std::floor(value))
        return {};
    return static_cast<long long>(value);
}

std::size_t testIndex(const Invocation &invocation, std::size_t count) {
    const QString word = invocation.value(QLatin1StringView("test")).value_or(QStringLiteral("1"));
    bool isNumber = false;
    const uint number = word.toUInt(&isNumber);
    if (!isNumber || number < 1 || number > count)
        throw UsageError({REPORT_TEXT("report", "there is no test %1; the file has %2"),
                          {word.toStdString(), Number{static_cast<double>(count), Quantity::count}}});
    return number - 1;
}

std::optional<std::int64_t> seedOf(const Invocation &invocation) {
    const auto given = invocation.value(QLatin1StringView("seed"));
    if (!given)
        return std::nullopt;
    bool isNumber = false;
    const std::int64_t value = given->toLongLong(&isNumber);
    if (!isNumber || value < 0)
        refuse("seed", *given);
    return value;
}

} // namespace palmer
