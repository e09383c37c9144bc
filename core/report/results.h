// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "language/language.h"
#include "report/blocks/report.h"

namespace palmer {

/// The results of all tests in short, as a terminal shows them: of each test head, results with their limits,
/// statistics per target, verdict in its two parts, findings.
[[nodiscard]] Report composeResults(const EvaluatedDocument &evaluated, const Language &language);

/// The findings of all tests alone, with the accordance of each test with its edition.
[[nodiscard]] Report composeFindings(const EvaluatedDocument &evaluated, const Language &language);

} // namespace palmer
