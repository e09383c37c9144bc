// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/diagnosis/diagnosis.h"

namespace palmer {

/// "Backlash X"
[[nodiscard]] Message sourceName(const SourceEstimate &source);
/// What it is, by its sign ("X loses motion at each reversal"); or why it has no value.
[[nodiscard]] Message sourceMeaning(const Diagnosis &diagnosis, const SourceEstimate &source);
/// What a positive value of a source means, whatever its value is; an empty text for centre and radius.
[[nodiscard]] Message positiveMeaning(const Diagnosis &diagnosis, const SourceEstimate &source);
/// What to look at on the machine; an empty text for centre and radius.
[[nodiscard]] Message sourceAdvice(const Diagnosis &diagnosis, const SourceEstimate &source);
/// "squareness", "backlash:X": as scripts write it.
[[nodiscard]] std::string sourceId(const SourceEstimate &source);

} // namespace palmer
