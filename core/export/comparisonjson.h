// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/comparedtests.h"
#include "export/resultsjson.h"

#include <nlohmann/json_fwd.hpp>

namespace palmer {

/// The keys that a comparison has wherever it is written: values unrounded in mm or degrees, null if unknown;
/// names and conditions in `language`.
[[nodiscard]] nlohmann::ordered_json comparisonKeys(const TestComparison &comparison,
                                                    const PlacedTest &before, const PlacedTest &after,
                                                    const ComparisonOptions &options,
                                                    const Language &language);

/// A comparison as a file of its own: format "palmer comparison" (palmer-comparison-1.schema.json).
[[nodiscard]] QByteArray comparisonJson(const TestComparison &comparison, const PlacedTest &before,
                                        const QString &fileBefore, const PlacedTest &after,
                                        const QString &fileAfter, const ComparisonOptions &options,
                                        const Language &language, JsonForm form);

} // namespace palmer
