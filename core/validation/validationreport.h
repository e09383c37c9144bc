// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "language/language.h"
#include "report/blocks/report.h"
#include "validation/validation.h"

#include <QByteArray>
#include <vector>

namespace palmer {

/// For each set, method and source: number of values, tolerance and the largest difference; the values that
/// differ; the origins. For selftest and help.
[[nodiscard]] Report composeValidation(const std::vector<SetValidation> &sets, const Language &language);

/// The validation document of this build: the same with version, compiler, processor, day, SHA-256 of the
/// program. Other machines print other bytes.
[[nodiscard]] Report composeValidationDocument(const std::vector<SetValidation> &sets,
                                               const Language &language);

/// The same for scripts, value by value, in English.
[[nodiscard]] QByteArray validationJson(const std::vector<SetValidation> &sets);

} // namespace palmer
