// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/comparedtests.h"
#include "export/resultsjson.h"

namespace palmer {

/// A comparison as JSON, for scripts: format "palmer comparison" (palmer-comparison-1.schema.json). Values
/// unrounded in mm or degrees, null if unknown; conditions in `language`.
[[nodiscard]] QByteArray comparisonJson(const TestComparison &comparison, const PlacedTest &before,
                                        const QString &fileBefore, const PlacedTest &after,
                                        const QString &fileAfter, std::optional<double> tolerance,
                                        const Language &language, JsonForm form);

} // namespace palmer
