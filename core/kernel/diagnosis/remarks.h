// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/diagnosis/diagnosis.h"

namespace palmer {

/// Returns remarks on the diagnosis as a whole.
[[nodiscard]] std::vector<Message> diagnosisRemarks(std::span<const DiagnosedCircle> circles,
                                                    const DiagnosisOptions &options,
                                                    const Diagnosis &diagnosis);

} // namespace palmer
