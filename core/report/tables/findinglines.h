// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/testevaluation.h"
#include "language/language.h"
#include "report/blocks/report.h"

namespace palmer {

enum class FindingsOf { all, text, others };

/// The findings as printed: by source, requirements of the text first; one line per clause and state. Those
/// of the text alone have no heading.
[[nodiscard]] FindingsBlock findingLines(const TestEvaluation &evaluation, const Language &language,
                                         FindingsOf which = FindingsOf::all);

} // namespace palmer
