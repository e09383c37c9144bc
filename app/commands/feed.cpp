// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/commands.h"

#include "commandline/optionvalues.h"
#include "commandline/streams.h"
#include "export/answersjson.h"
#include "kernel/evaluation/iso230_4/contouringfeed.h"
#include "language/decimals.h"

#include <array>

namespace palmer {

namespace {

constexpr std::array feedOptions{
    Option{"specified-diameter", "MM", REPORT_TEXT("report", "diameter the feed was specified for")},
    Option{"specified-feed", "MM/MIN", REPORT_TEXT("report", "contouring feed specified for it")},
    Option{"diameter", "MM", REPORT_TEXT("report", "diameter of the test")},
    Option{"json", "", REPORT_TEXT("report", "the feed as JSON, with all digits")},
};

double positiveNumber(const Invocation &invocation, const Option &option) {
    const auto word = invocation.value(option.name);
    if (!word)
        throw UsageError({REPORT_TEXT("report", "the command %1 needs the option --%2 %3"),
                          {std::string("feed"), std::string(option.name), std::string(option.value)}});
    return numberAbove(option.name, *word, 0);
}

int runFeed(const Invocation &invocation) {
    const auto &[specifiedDiameter, specifiedFeed, diameter, json] = feedOptions;
    const auto feed = iso230_4::contouringFeed({positiveNumber(invocation, specifiedDiameter),
                                                positiveNumber(invocation, specifiedFeed),
                                                positiveNumber(invocation, diameter)});
    if (!feed)
        throw UsageError({REPORT_TEXT("report", "there is no feed for numbers this large or small"), {}});
    if (invocation.has(json.name))
        printOut(feedJson(*feed));
    else
        printOut(invocation.language.quantity(*feed, Quantity::feed, feedDecimals(*feed)) + u'\n');
    return done;
}

} // namespace

Command feedCommand() {
    return {"feed", "",
            REPORT_TEXT("report", "contouring feed for a circle of another diameter (ISO 230-4, annex C)"),
            feedOptions, runFeed};
}

} // namespace palmer
