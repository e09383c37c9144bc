// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"

namespace palmer {

/// True if a test has a verdict other than "conforms"; if rejection must be proven, only for "does not
/// conform". Tests as found do not count if there are others.
[[nodiscard]] bool hasRejection(const EvaluatedDocument &evaluated);

} // namespace palmer
