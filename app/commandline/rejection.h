// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"

namespace palmer {

/// Whether a test has a verdict other than "conforms"; where rejection has to be proven, only "does not
/// conform". Tests as found do not count where there are others.
[[nodiscard]] bool hasRejection(const EvaluatedDocument &evaluated);

} // namespace palmer
