// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "language/language.h"

#include <QByteArray>
#include <QString>

namespace palmer {

enum class JsonForm {
    pretty,  ///< indented, for one file
    oneLine, ///< one object per line, for several files
};

/// The results of all tests as JSON, for scripts: every value unrounded in mm or degrees, null if unknown,
/// never NaN. `limitOf` of a parameter: the quantity whose limit is given with it, or null. Names and
/// sentences in `language`; ids and words do not depend on it. `fileName` is echoed. Ends with a line break.
[[nodiscard]] QByteArray resultsJson(const EvaluatedDocument &evaluated, const QString &fileName,
                                     const Language &language, JsonForm form);

/// The results attached to the PDF of a report, in English.
[[nodiscard]] QByteArray attachedResults(const EvaluatedDocument &evaluated);

/// Only the head and the findings of all tests, with the same keys.
[[nodiscard]] QByteArray findingsJson(const EvaluatedDocument &evaluated, const QString &fileName,
                                      const Language &language, JsonForm form);

} // namespace palmer
