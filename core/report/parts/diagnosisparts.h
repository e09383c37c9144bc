// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/diagnosis/diagnosis.h"
#include "language/language.h"
#include "report/blocks/report.h"
#include "report/parts/testpart.h"

namespace palmer {

/// The diagnosis of a circle to be read: heading that says what it is (an interpretation, no result of the
/// standard), how well the circle tells its sources, the sources with value, u and part of G(b), what each
/// means, remarks. Nothing for a circle that gives no diagnosis.
[[nodiscard]] std::vector<Block> diagnosisParts(const Diagnosis &diagnosis, const Language &language);

/// The page of a report that says the same with figures: measured and synthetic path, the sources with what
/// to look at on the machine, what they leave. Behind the last of several tests of a plane at different feeds
/// a page of what these say together. Nothing unless the report asks for it.
void addDiagnosis(std::vector<Block> &blocks, const CircularPart &part);

} // namespace palmer
