// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editing/changedreadings.h"

#include <algorithm>
#include <memory>

namespace palmer {

namespace {

using Change = ChangedReadings::Change;

/// The place of the only test that is another one.
std::optional<std::size_t> onlyOtherTest(const Document &before, const Document &after) {
    if (before.tests.size() != after.tests.size())
        return {};
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < before.tests.size(); ++i) {
        if (before.tests[i] == after.tests[i])
            continue;
        if (found)
            return {};
        found = i;
    }
    return found;
}

/// Null where they are of different shape, or more than `most` differ.
std::optional<std::vector<Change>> differences(const PositioningMeasurement &before,
                                               const PositioningMeasurement &after, std::size_t most) {
    if (before.runs.size() != after.runs.size())
        return {};
    std::vector<Change> changes;
    for (std::size_t run = 0; run < before.runs.size(); ++run) {
        const auto &was = before.runs[run].deviations;
        const auto &is = after.runs[run].deviations;
        if (was.size() != is.size())
            return {};
        for (std::size_t target = 0; target < was.size(); ++target) {
            if (was[target] == is[target])
                continue;
            if (changes.size() == most)
                return {};
            changes.push_back({{run, target}, was[target], is[target]});
        }
    }
    return changes;
}

Document with(Document document, const ChangedReadings &readings, std::optional<double> Change::*value) {
    auto test = std::make_shared<Test>(*document.tests[readings.test]);
    auto &runs = std::get<PositioningMeasurement>(test->measurement).runs;
    for (const Change &change : readings.changes)
        runs[change.place.run].deviations[change.place.target] = change.*value;
    document.tests[readings.test] = std::move(test);
    return document;
}

} // namespace

std::optional<ChangedReadings> changedReadings(const Document &before, const Document &after,
                                               std::size_t least) {
    const auto test = onlyOtherTest(before, after);
    if (!test)
        return {};
    const auto *was = std::get_if<PositioningMeasurement>(&before.tests[*test]->measurement);
    const auto *is = std::get_if<PositioningMeasurement>(&after.tests[*test]->measurement);
    const std::size_t readings = was ? was->runs.size() * was->targets.size() : 0;
    if (!was || !is || readings < least)
        return {};
    auto changes = differences(*was, *is, readings / 1000);
    if (!changes)
        return {};
    ChangedReadings found{*test, std::move(*changes)};
    const Document back = withReadingsBefore(after, found);
    // Nothing but the readings: the rest of the test, the other tests, machine, head.
    const bool isAll = *back.tests[*test] == *before.tests[*test];
    Document others = back;
    others.tests = before.tests;
    return isAll && others == before ? std::optional(std::move(found)) : std::nullopt;
}

Document withReadingsBefore(Document document, const ChangedReadings &readings) {
    return with(std::move(document), readings, &Change::before);
}

Document withReadingsAfter(Document document, const ChangedReadings &readings) {
    return with(std::move(document), readings, &Change::after);
}

} // namespace palmer
