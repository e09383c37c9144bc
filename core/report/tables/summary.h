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

/// The results of many files in one table: a row per parameter, a test without parameters has one, too.
enum class SummaryForm {
    csv, ///< for programs: numbers unrounded in mm or degrees, with a point; words of files, the same in all
         ///< languages
    text ///< for a terminal: numbers and words as a report prints them
};

/// The titles of the columns: file, test (from 1), machine, axis or plane, date, edition, role, parameter,
/// value, U, limit, unit, limits, accordance.
[[nodiscard]] QStringList summaryHead(SummaryForm form, const Language &language);

/// The cells of the rows of a file.
[[nodiscard]] std::vector<QStringList> summaryRows(const EvaluatedDocument &evaluated, const QString &file,
                                                   SummaryForm form, const Language &language);

/// A file of the rows.
[[nodiscard]] QByteArray summaryCsv(const std::vector<QStringList> &rows);

/// The head and the rows in columns; texts are broken into several lines where a row would be wider than
/// `width`, numbers never.
[[nodiscard]] QString summaryText(const QStringList &head, const std::vector<QStringList> &rows,
                                  std::optional<int> width = {});

} // namespace palmer
