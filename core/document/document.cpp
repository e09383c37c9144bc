// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/document.h"

#include <algorithm>

namespace palmer {

bool operator==(const Document &a, const Document &b) {
    const auto same = [](const TestPointer &x, const TestPointer &y) {
        return x == y || (x && y && *x == *y);
    };
    return a.writtenBy == b.writtenBy && a.report == b.report && a.machine == b.machine &&
           a.instruments == b.instruments && a.extensions == b.extensions &&
           std::equal(a.tests.begin(), a.tests.end(), b.tests.begin(), b.tests.end(), same);
}

} // namespace palmer
