// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/diagnosis/diagnosis.h"

namespace palmer {

/// Returns the name of a source: "Backlash X".
[[nodiscard]] Message sourceName(const SourceEstimate &source);
/// The same of a part of a sum, which may be another quantity.
[[nodiscard]] Message summandName(const Diagnosis &diagnosis, const SourceSum::Part &part);
/// Returns the meaning of a source by its sign ("X loses motion at each reversal"), or why it has no value.
[[nodiscard]] Message sourceMeaning(const Diagnosis &diagnosis, const SourceEstimate &source);
/// Returns the meaning of a positive value of a source, whatever its value; empty for centre and radius.
[[nodiscard]] Message positiveMeaning(const Diagnosis &diagnosis, const SourceEstimate &source);
/// Returns what to inspect on the machine; empty for centre and radius.
[[nodiscard]] Message sourceAdvice(const Diagnosis &diagnosis, const SourceEstimate &source);
/// Returns the id used by scripts: "squareness", "backlash:X".
[[nodiscard]] std::string sourceId(const SourceEstimate &source);

/// Returns what a rotation that counts means; null for any other.
[[nodiscard]] std::optional<Message> rotationStatement(const Rotation &rotation);

/// Returns remarks on the diagnosis as a whole.
[[nodiscard]] std::vector<Message> diagnosisRemarks(std::span<const DiagnosedCircle> circles,
                                                    const DiagnosisOptions &options,
                                                    const Diagnosis &diagnosis);

} // namespace palmer
