// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "language/language.h"

#include <QByteArray>

namespace palmer {

/// Readings and results of one test as CSV, UTF-8: a line for each thing the test states ("# edition,ISO
/// 230-2:2014"), the readings with the statistics of each target (what the figure draws), then the
/// parameters. Lengths in mm, of rotary axes degrees, all digits, with the decimal mark given; `;` between
/// the cells under a comma, else `,`. Missing ones are empty. The importer reads statements and readings back
/// as they are: their evaluation gives the same results. Headings are the same in every language, as the keys
/// of JSON are, with their unit in parentheses; names of parameters are in `language`.
[[nodiscard]] QByteArray readingsCsv(const EvaluatedDocument &evaluated, std::size_t index,
                                     const Language &language, char decimalMark);

/// The results as resultsJson gives them, each test with its readings: `targets` and `runs`, `arcs`, or
/// `times` and `deviations`, as in a test file.
[[nodiscard]] QByteArray readingsJson(const EvaluatedDocument &evaluated, const QString &fileName,
                                      const Language &language);

} // namespace palmer
