// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kernel/evaluation/circulardata.h"
#include "document/evaluateddocument.h"

#include <memory>

/// Documents with circular tests for tests of the window.
namespace palmer::testdata {

inline EvaluatedDocument evaluatedCircles(const Test &test) {
    auto document = std::make_shared<Document>();
    document->tests.push_back(std::make_shared<const Test>(test));
    return evaluate(std::move(document));
}

/// The ballbar pair with limits, feed and a time of 31.4 ms between points.
inline Test decidedPair() {
    Test test = ballbarPair();
    test.title = "XY – cercle R 150";
    test.limits["G(b)"].value = 0.030;
    test.limits["G"].value = 0.022;
    test.limits["F"].value = 0.018;
    circular(test).feed = 1000;
    for (Arc &arc : circular(test).arcs)
        arc.sampleInterval = 0.0314;
    return test;
}

} // namespace palmer::testdata
