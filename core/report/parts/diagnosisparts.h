// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/diagnosis/diagnosis.h"
#include "language/language.h"
#include "report/blocks/report.h"
#include "report/parts/testpart.h"

namespace palmer {

/// The diagnosis of a circle as text: heading that declares it an interpretation and no result of the
/// standard, quality of the separation, the sources with value, u, part of G(b) and meaning, remarks. Empty
/// if the circle gives no diagnosis.
[[nodiscard]] std::vector<Block> diagnosisParts(const Diagnosis &diagnosis, const Language &language);

/// Adds the diagnosis page of a report with figures: measured and synthetic path, the sources with advice for
/// the machine, the residual. The last of several tests of a plane at different feeds is followed by a page
/// of the joint diagnosis. Nothing unless the report includes it.
void addDiagnosis(std::vector<Block> &blocks, const CircularPart &part);

} // namespace palmer
