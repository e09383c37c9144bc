// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/commands.h"

#include "commandline/inputs.h"
#include "commandline/optionvalues.h"
#include "commandline/streams.h"
#include "commandline/terminal.h"
#include "document/comparedtests.h"
#include "export/comparisonjson.h"
#include "kernel/measurement/testfacts.h"
#include "report/blocks/plaintext.h"
#include "report/parts/comparedtests.h"

#include <algorithm>

namespace palmer {

namespace {

constexpr auto compareOptions = optionList(
    Option{
        "test", "N[,M]",
        REPORT_TEXT("report",
                    "which test of A, and of B, from 1; without it the first of A that has its like in B")},
    Option{
        "laboratories", "",
        REPORT_TEXT("report", "two laboratories measured one machine: E_n, only α of the machine is shared")},
    Option{
        "tolerance", "VALUE",
        REPORT_TEXT("report", "agreed tolerance of a change, µm (rotary: arc seconds): unchanged within it")},
    Option{"set-up-untouched", "",
           REPORT_TEXT("report", "the instrument stood as it had been aligned: the misalignment is shared")},
    Option{"json", "", REPORT_TEXT("report", "the comparison as JSON")});

std::optional<EvaluatedDocument> evaluatedFrom(const QString &file, const Invocation &invocation) {
    std::optional<Document> document = documentFrom(file, invocation);
    if (!document)
        return std::nullopt;
    return evaluate(std::make_shared<const Document>(std::move(*document)));
}

/// The tests to be compared, by index. Throws UsageError.
std::pair<std::size_t, std::size_t> pairOf(const Invocation &invocation, const EvaluatedDocument &a,
                                           const EvaluatedDocument &b) {
    if (const auto asked = invocation.value("test")) {
        const QStringList numbers = asked->split(u',');
        if (numbers.size() > 2)
            refuse("test", *asked, compareOptions[0].value);
        return {testIndex(numbers.first(), a.tests.size()), testIndex(numbers.last(), b.tests.size())};
    }
    for (std::size_t i = 0; i < a.tests.size(); ++i) {
        if (!isJudged(*a.document->tests[i]))
            continue;
        if (const auto j = counterpart({&a, i}, b))
            return {i, *j};
    }
    throw UsageError(
        {REPORT_TEXT("report",
                     "no test of the first file has its like in the second: same axis or plane, directions "
                     "and radius; --test names two"),
         {}});
}

/// The first test that the file compares with another one, and how.
std::pair<std::size_t, std::size_t> statedPair(const EvaluatedDocument &file, ComparisonOptions &options) {
    for (std::size_t i = 0; i < file.tests.size(); ++i) {
        const auto &stated = file.document->tests[i]->comparedWith;
        if (!stated)
            continue;
        options.tolerance = stated->tolerance;
        options.setUpUntouched = stated->setUpUntouched;
        const auto other =
            std::ranges::find(file.document->tests, stated->test, [](const TestPointer &t) { return t->id; });
        const auto j = static_cast<std::size_t>(other - file.document->tests.begin());
        return precedes(*file.document->tests[i], **other) ? std::pair(i, j) : std::pair(j, i);
    }
    throw UsageError({REPORT_TEXT("report", "no test of the file states what it is compared with "
                                            "(“comparedWith”); --test names two"),
                      {}});
}

bool isDifference(const ComparedParameter &parameter) {
    return parameter.word && (statesDifference(*parameter.word) || *parameter.word == ChangeWord::notProven);
}

/// Also where nothing was compared, or no word is said.
bool isOpenOrDiffers(const TestComparison &comparison) {
    return comparison.refusal || std::ranges::any_of(comparison.parameters, isDifference) ||
           std::ranges::none_of(comparison.parameters, [](const auto &one) { return one.word.has_value(); });
}

int runCompare(const Invocation &invocation) {
    if (invocation.arguments.isEmpty() || invocation.arguments.size() > 2)
        throw UsageError(
            {REPORT_TEXT("report", "the command %1 takes one or two files"), {std::string("compare")}});
    const QString &earlier = invocation.arguments.front();
    const QString &later = invocation.arguments.back();
    const bool alone = invocation.arguments.size() == 1;
    std::optional<EvaluatedDocument> a;
    std::optional<EvaluatedDocument> b;
    for (const auto &[file, place] : {std::pair{&earlier, &a}, std::pair{&later, &b}}) {
        if (alone && place == &b) {
            b = a;
            break;
        }
        const int code = codeOf(*file, invocation.language, [&, file = file, place = place]() -> int {
            *place = evaluatedFrom(*file, invocation);
            return *place ? done : cannotRead;
        });
        if (code != done)
            return code;
    }
    ComparisonOptions options;
    const auto [i, j] =
        alone && !invocation.has("test") ? statedPair(*a, options) : pairOf(invocation, *a, *b);
    const PlacedTest before{&*a, i};
    const PlacedTest after{&*b, j};
    if (invocation.has("laboratories"))
        options.role = ComparisonRole::laboratories;
    options.setUpUntouched = options.setUpUntouched || invocation.has("set-up-untouched");
    if (const auto given = invocation.value("tolerance"))
        options.tolerance =
            numberAbove("tolerance", *given, 0) / unitScale(deviationQuantity(after.test()), DisplayUnits());
    const TestComparison comparison = compare(before, after, options);
    if (invocation.has("json"))
        printOut(comparisonJson(comparison, before, earlier, after, later, options, namesLanguage(invocation),
                                JsonForm::pretty));
    else
        printOut(
            plainText(composeComparison(comparison, before, after, invocation.language, options.tolerance),
                      textColumns()));
    return isOpenOrDiffers(comparison) ? difference : done;
}

} // namespace

Command compareCommand() {
    return {
        "compare", "A [B]",
        REPORT_TEXT("report", "what has changed from test A to test B: differences with their uncertainty"),
        compareOptions, runCompare};
}

} // namespace palmer
