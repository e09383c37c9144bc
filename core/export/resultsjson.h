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

/// Readings and results of one test as CSV, UTF-8: one line per statement of the test ("# edition,ISO
/// 230-2:2014"), the readings with the statistics of each target (the content of the figure), then the
/// parameters. Lengths in mm, for rotary axes degrees, all digits, with the given decimal mark; cells are
/// separated by `;` with a decimal comma, otherwise by `,`. Missing values are empty. The importer reads
/// statements and readings back unchanged, so they evaluate to the same results. Headings, like JSON keys,
/// are the same in every language, with the unit in parentheses; names of parameters are in `language`.
[[nodiscard]] QByteArray readingsCsv(const EvaluatedDocument &evaluated, std::size_t index,
                                     const Language &language, char decimalMark);

/// The results of resultsJson(), each test with its readings: `targets` and `runs`, `arcs`, or `times` and
/// `deviations`, as in a test file.
[[nodiscard]] QByteArray readingsJson(const EvaluatedDocument &evaluated, const QString &fileName,
                                      const Language &language);

} // namespace palmer
