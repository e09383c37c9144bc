// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "language/language.h"
#include "report/blocks/report.h"

namespace palmer {

/// Short results of all tests for a terminal: for each test head, results with their limits, statistics per
/// target, verdict in its two parts, findings.
[[nodiscard]] Report composeResults(const EvaluatedDocument &evaluated, const Language &language);

/// Only the findings of all tests, with the accordance of each test with its edition.
[[nodiscard]] Report composeFindings(const EvaluatedDocument &evaluated, const Language &language);

} // namespace palmer
