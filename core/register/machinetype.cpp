// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/machinetype.h"

#include "kernel/measurement/testfacts.h"

#include <algorithm>
#include <array>

namespace palmer {

namespace {

/// The newest test of each machine in a series, by the id of the machine.
struct Candidate {
    TrendSeries series;
    std::map<int, const ListedTest *> newest;
    std::string date;
};

std::vector<Candidate> candidatesOf(const std::vector<const ListedTest *> &tests) {
    std::vector<Candidate> result;
    for (auto listed = tests.rbegin(); listed != tests.rend(); ++listed) { // the newest names its series
        const RegisteredTest &test = (*listed)->test;
        auto found = std::ranges::find_if(
            result, [&](const Candidate &one) { return !differenceOf(one.series, test).any(); });
        if (found == result.end()) {
            result.push_back({{test.edition, test.feed, test.travel, test.correction, test.setUp, {}, {}},
                              {},
                              test.date.value_or("")});
            found = std::prev(result.end());
        }
        found->newest.emplace((*listed)->machine, *listed);
    }
    return result;
}

} // namespace

std::vector<ListedMachine> machinesOfType(const std::vector<ListedMachine> &machines, const QString &words) {
    const QString wanted = asCompared(words);
    std::vector<ListedMachine> result;
    std::ranges::copy_if(machines, std::back_inserter(result), [&](const ListedMachine &machine) {
        return !machine.model.isEmpty() &&
               (asCompared(machine.model) == wanted ||
                asCompared(machine.manufacturer + u' ' + machine.model) == wanted);
    });
    return result;
}

bool hasTypeTest(const std::string &parameter) {
    constexpr std::array isSigned{"Bmean", "D", "Fmax", "Fmin"};
    return std::ranges::find(isSigned, quantityOf(parameter)) == isSigned.end();
}

TypeTest typeTest(const std::vector<ListedMachine> &machines, const std::vector<ListedTest> &tests,
                  const std::string &axis, const std::string &parameter, const Tolerance &tolerance,
                  TypeDistribution distribution) {
    TypeTest result{axis, parameter, false, {}, tolerance, distribution, {}, {}, {}};
    std::vector<const ListedTest *> usable;
    std::map<int, const ListedTest *> newest;
    for (const ListedTest &listed : tests) {
        const RegisteredResult *found = listed.test.axis == axis && traitsOf(listed.test.kind).isJudged
                                            ? resultOf(listed.test, parameter)
                                            : nullptr;
        if (!found || !found->value)
            continue;
        usable.push_back(&listed);
        newest[listed.machine] = &listed;
    }
    std::vector<Candidate> candidates = candidatesOf(usable);
    const auto best = std::ranges::max_element(
        candidates, {}, [](const Candidate &one) { return std::pair(one.newest.size(), one.date); });
    if (best == candidates.end())
        return result;
    result.series = best->series;
    std::vector<double> values;
    for (const ListedMachine &machine : machines) {
        const auto member = best->newest.find(machine.id);
        if (member != best->newest.end()) {
            const ListedTest &test = *member->second;
            result.angular = test.test.angular;
            result.members.push_back({machine, test, *resultOf(test.test, parameter)});
            values.push_back(*result.members.back().result.value);
        } else if (const auto other = newest.find(machine.id); other != newest.end()) {
            result.outsiders.push_back(
                {machine, *other->second, differenceOf(best->series, other->second->test)});
        }
    }
    std::ranges::stable_sort(result.members, {}, [](const TypeMember &one) { return *one.result.value; });
    result.statistics = typeStatistics(values, tolerance);
    return result;
}

} // namespace palmer
