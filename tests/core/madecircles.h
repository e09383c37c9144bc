// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/diagnosedtest.h"
#include "kernel/diagnosis/synthesize.h"

#include <memory>
#include <string>
#include <vector>

/// Circular tests with known truth for tests.
namespace palmer::testdata {

/// A file with a test of each.
inline std::shared_ptr<Document> madeCircles(const std::vector<CircularSynthesis> &asked) {
    auto document = std::make_shared<Document>();
    for (std::size_t i = 0; i < asked.size(); ++i) {
        Test test;
        test.id = "made-" + std::to_string(i + 1);
        test.edition = "ISO 230-4:2005";
        test.measurement = synthesizeCircular(asked[i]);
        document->tests.push_back(std::make_shared<const Test>(std::move(test)));
    }
    return document;
}

/// Both senses of 360 points with scale mismatch, servo mismatch and backlash of X, the largest first.
inline CircularSynthesis mixedCircle() {
    CircularSynthesis asked;
    asked.points = 360;
    asked.sources = {{InfluenceId::scaleMismatch, PlaneAxis::none, 60e-6},
                     {InfluenceId::servoMismatch, PlaneAxis::none, 0.4e-3},
                     {InfluenceId::backlash, PlaneAxis::first, 0.004},
                     {InfluenceId::radius, PlaneAxis::none, 0.03}};
    asked.noise = {5e-5, 0, 0, 3};
    return asked;
}

/// Three feeds of a machine that lags.
inline std::vector<CircularSynthesis> threeFeeds() {
    std::vector<CircularSynthesis> result;
    for (const double feed : {3000.0, 500.0, 6000.0}) { // not in order
        CircularSynthesis asked = mixedCircle();
        asked.feed = feed;
        asked.sources.push_back({InfluenceId::commonLag, PlaneAxis::none, 0.02 * 0.02});
        asked.noise.seed += static_cast<long long>(feed);
        result.push_back(asked);
    }
    return result;
}

} // namespace palmer::testdata
