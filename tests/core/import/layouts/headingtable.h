// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <random>
#include <vector>

namespace palmer::testdata {

/// A table with a row above its headings that tells groups of columns apart, and what each group holds. It
/// knows nothing of the reader.
struct GroupedTable {
    QByteArray text;             ///< the bytes of a workbook, where it is a sheet
    std::vector<double> targets; ///< mm
    /// The columns of each group, ↑ and ↓ in turn, with the numbers of the file; each number stands once.
    std::vector<std::vector<std::vector<double>>> groups;
};

/// Words, axes, units, years, states above two or three groups; semicolons, commas, tabs or columns of fixed
/// width, sheets of a workbook with merged cells; the word once or over each column. The same for the same
/// state of the generator.
[[nodiscard]] GroupedTable groupedTable(std::mt19937 &random);

/// Lines that stand above tables and say nothing of their columns: temperatures, instruments, settings.
[[nodiscard]] const std::vector<QByteArray> &conditionBlocks();

} // namespace palmer::testdata
