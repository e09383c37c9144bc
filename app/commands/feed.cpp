#include "commands/feed.h"

#include "commands/streams.h"
#include "kernel/evaluation/iso230_4/contouringfeed.h"
#include "language/decimals.h"

#include <array>
#include <cmath>

namespace palmer {

namespace {

constexpr std::array options{
    Option{"specified-diameter", "MM", REPORT_TEXT("report", "diameter the feed was specified for")},
    Option{"specified-feed", "MM/MIN", REPORT_TEXT("report", "contouring feed specified for it")},
    Option{"diameter", "MM", REPORT_TEXT("report", "diameter of the test")},
};

double positiveNumber(const Invocation &invocation, const Option &option) {
    const auto word = invocation.value(QLatin1StringView(option.name));
    if (!word)
        throw UsageError({REPORT_TEXT("report", "the command %1 needs the option --%2 %3"),
                          {std::string("feed"), std::string(option.name), std::string(option.value)}});
    bool isNumber = false;
    const double number = word->toDouble(&isNumber);
    if (!isNumber || !std::isfinite(number) || number <= 0)
        throw UsageError({REPORT_TEXT("report", "--%1 has to be a number above 0, not %2"),
                          {std::string(option.name), word->toStdString()}});
    return number;
}

int run(const Invocation &invocation) {
    const auto &[specifiedDiameter, specifiedFeed, diameter] = options;
    const auto feed = iso230_4::contouringFeed({positiveNumber(invocation, specifiedDiameter),
                                                positiveNumber(invocation, specifiedFeed),
                                                positiveNumber(invocation, diameter)});
    if (!feed)
        throw UsageError({REPORT_TEXT("report", "there is no feed for numbers this large or small"), {}});
    printOut(invocation.language.quantity(*feed, Quantity::feed, feedDecimals(*feed)) + u'\n');
    return done;
}

} // namespace

Command feedCommand() {
    return {"feed", "",
            REPORT_TEXT("report", "contouring feed for a circle of another diameter (ISO 230-4, annex C)"),
            options, run};
}

} // namespace palmer
