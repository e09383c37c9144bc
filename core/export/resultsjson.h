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
    oneLine, ///< one object a line, for several
};

/// The results of all tests as JSON, for scripts: every value unrounded in mm or degrees, null where there is
/// none, never NaN. `limitOf` of a parameter: the quantity whose limit stands beside it, null without. Names
/// and sentences in `language`; ids and words are the same in all. `fileName` is echoed. Ends with a line
/// break.
[[nodiscard]] QByteArray resultsJson(const EvaluatedDocument &evaluated, const QString &fileName,
                                     const Language &language, JsonForm form);

/// Those that travel in the PDF of a report, in English.
[[nodiscard]] QByteArray attachedResults(const EvaluatedDocument &evaluated);

/// Of all tests the head and the findings alone, with the same keys.
[[nodiscard]] QByteArray findingsJson(const EvaluatedDocument &evaluated, const QString &fileName,
                                      const Language &language, JsonForm form);

} // namespace palmer
