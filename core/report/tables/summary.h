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

/// The fields that identify a test in such a table.
struct SummaryTest {
    QString file;
    int test = 1; ///< from 1
    std::string machine;
    std::string manufacturer;
    std::string model;
    std::string serialNumber;
    std::string reportNumber;
    std::string axis; ///< or plane
    std::string date; ///< ISO 8601; empty: not stated
    std::string edition;
    Purpose purpose = Purpose::notStated;
    TestRole role = TestRole::notStated;
    std::string zone; ///< of a long axis: "0 … 2000"
    bool angular = false;
};

/// "0 … 2000".
[[nodiscard]] std::string shortText(const Interval &interval);

/// Returns the numbers of "0 … 2000" or "X 10 Z 120" as they are shown, with their unit.
[[nodiscard]] QString lengthsText(const QString &lengths, Quantity quantity, const Language &language);

/// Its cells, the first of each row.
[[nodiscard]] QStringList summaryCells(const SummaryTest &test, SummaryForm form, const Language &language);
/// The last cell.
[[nodiscard]] QString summaryAccordance(Accordance accordance, SummaryForm form, const Language &language);

/// Column titles: those of SummaryTest, then parameter, value, U, limit, unit, limits, accordance.
[[nodiscard]] QStringList summaryHead(SummaryForm form, const Language &language);

/// The cells of all rows of a file.
[[nodiscard]] std::vector<QStringList> summaryRows(const EvaluatedDocument &evaluated, const QString &file,
                                                   SummaryForm form, const Language &language);

/// The rows as a CSV file; cells after those of summaryHead() are numbers where they are written as one.
[[nodiscard]] QByteArray summaryCsv(const std::vector<QStringList> &rows, char decimalMark = '.');

/// Head and rows in aligned columns, without empty ones; if a row would be wider than `width`, texts are
/// wrapped, but never numbers, and what tells machines and reports apart is left out.
[[nodiscard]] QString summaryText(const QStringList &head, const std::vector<QStringList> &rows,
                                  std::optional<int> width = {});

} // namespace palmer
