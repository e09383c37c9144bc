// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "language/language.h"

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

namespace palmer {

/// Table of the results of many files: one row per parameter, and one for a test without parameters.
enum class SummaryForm {
    csv, ///< for programs: unrounded numbers in mm or degrees with a point, language-independent words
    text ///< for a terminal: numbers and words as printed in reports
};

/// Column titles: file, test (from 1), machine, axis or plane, date, edition, role, parameter, value, U,
/// limit, unit, limits, accordance.
[[nodiscard]] QStringList summaryHead(SummaryForm form, const Language &language);

/// The cells of all rows of a file.
[[nodiscard]] std::vector<QStringList> summaryRows(const EvaluatedDocument &evaluated, const QString &file,
                                                   SummaryForm form, const Language &language);

/// The rows as a CSV file.
[[nodiscard]] QByteArray summaryCsv(const std::vector<QStringList> &rows);

/// Head and rows in aligned columns; if a row would be wider than `width`, texts are wrapped, but never
/// numbers.
[[nodiscard]] QString summaryText(const QStringList &head, const std::vector<QStringList> &rows,
                                  std::optional<int> width = {});

} // namespace palmer
