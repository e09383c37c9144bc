// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kernel/evaluation/positioningdata.h"
#include "document/evaluateddocument.h"

#include <memory>

/// Documents for tests of the window.
namespace palmer::testdata {

inline EvaluatedDocument evaluatedDocument(const Test &test, const char *edition = "") {
    auto document = std::make_shared<Document>();
    document->tests.push_back(std::make_shared<const Test>(test));
    return evaluate(std::move(document), nullptr, edition);
}

/// The worked example with limits under ISO 14253-1: A and B conform, R is not proven, M does not conform.
inline Test decidedExample() {
    Test test = example1988("ISO 230-2:2006");
    test.title = "X – état initial";
    test.limits["A"].value = 0.020;
    test.limits["E"].value = 0.018;
    test.limits["R"].value = 0.010;
    test.limits["M"].value = 0.008;
    test.limits["B"].value = 0.006;
    test.decisionRule.rule = Rule::iso14253_1;
    auto &uncertainty = measurement(test).uncertainty;
    uncertainty.method = UncertaintyMethod::direct;
    uncertainty.expanded = {{"A", 3.0}, {"A+", 3.0}, {"A-", 3.0}, {"E", 2.7},  {"E+", 2.7}, {"E-", 2.7},
                            {"M", 2.7}, {"R", 1.5},  {"R+", 1.9}, {"R-", 1.9}, {"B", 0.61}, {"Bmean", 0.61}};
    return test;
}

/// 400 targets, 10 runs each way: as large as a table gets.
inline Test largeTest() {
    std::vector<double> targets;
    std::vector<std::vector<double>> up(10);
    std::vector<std::vector<double>> down(10);
    for (int i = 0; i < 400; ++i) {
        targets.push_back(i * 5.0);
        for (int j = 0; j < 10; ++j) {
            up[static_cast<std::size_t>(j)].push_back(0.1 * ((i * 37 + j * 101) % 113) - 5);
            down[static_cast<std::size_t>(j)].push_back(0.1 * ((i * 53 + j * 71) % 97) - 3);
        }
    }
    return positioningTest("ISO 230-2:2006", targets, up, down);
}

} // namespace palmer::testdata
