// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "register/queries.h"

namespace palmer::testdata {

/// A test as the register lists it, without a file.
inline ListedTest made(const std::string &date, double value, Purpose purpose = Purpose::periodic,
                       TestRole role = TestRole::asFound) {
    static int next = 0;
    ListedTest listed;
    listed.id = ++next;
    listed.places = {{QStringLiteral("/files/%1.palmer").arg(next), 1, QStringLiteral("read")}};
    RegisteredTest &test = listed.test;
    test.digest = QString::number(next);
    test.fingerprint = test.digest;
    test.axis = "X";
    test.edition = "ISO 230-2:2014";
    test.date = date;
    test.feed = 6000;
    test.travel = 1000;
    test.purpose = purpose;
    test.role = role;
    test.parts = {{"device LSR-1/C-1;", 0.0004}};
    RegisteredResult result;
    result.id = "A";
    result.value = value / 1000;
    result.expandedUncertainty = 0.001;
    result.limit = 0.016;
    result.own = 0.0003;
    result.shared = 1;
    test.results = {result};
    return listed;
}

/// Six tests from a repair on, as in the picture of the window.
inline std::vector<ListedTest> sinceRepair() {
    return {made("2023-05-16", 9.9),
            made("2023-11-21", 10.6),
            made("2024-02-13", 19.3, Purpose::afterCollision),
            made("2024-04-16", 9.4, Purpose::afterRepair, TestRole::asLeft),
            made("2024-11-19", 10.5),
            made("2025-05-20", 10.7),
            made("2025-11-18", 11.8),
            made("2026-05-19", 12.0),
            made("2026-11-17", 12.9)};
}

} // namespace palmer::testdata
