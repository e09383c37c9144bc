#include "commands/optionvalues.h"

#include "language/entry.h"

#include <cmath>

namespace palmer {

void refuse(const char *option, const QString &given) {
    throw UsageError(
        {REPORT_TEXT("report", "--%1 cannot be %2"), {std::string(option), given.toStdString()}});
}

double numberGiven(const char *option, const QString &given) {
    const NumberEntry entry = enteredNumber(given, Quantity::number);
    if (!entry.value || !std::isfinite(*entry.value))
        refuse(option, given);
    return *entry.value;
}

std::optional<double> numberOf(const Invocation &invocation, const char *option) {
    const auto given = invocation.value(QLatin1StringView(option));
    return given ? std::optional(numberGiven(option, *given)) : std::nullopt;
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
