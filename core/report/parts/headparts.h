// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/parts/testpart.h"

namespace palmer {

/// The title of the report: its own, or "Acceptance test report".
[[nodiscard]] QString reportTitle(const Writer &write, const ReportHead &head);

/// Running head of the pages of a test.
[[nodiscard]] RunningHead runningHead(const TestPart &part);

/// The head of a positioning test.
[[nodiscard]] TestHead positioningHead(const PositioningPart &part);

/// The head of a circular test.
[[nodiscard]] TestHead circularHead(const CircularPart &part);

/// The head of a report whose tests have no pages of their own.
[[nodiscard]] TestHead driftHead(const Writer &write, const Document &document);

/// The head of the first page of a report over several tests.
[[nodiscard]] TestHead summaryHead(const std::vector<TestPart> &parts);

} // namespace palmer
