// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QStringList>
#include <vector>

namespace palmer::testdata {

/// Cells of a row, counted from 0, that are one.
struct MergedCells {
    int row = 0;
    int column = 0;
    int span = 1;
};

/// A workbook (.xlsx) of one sheet, not compressed: cells that are numbers with a point are numbers, the
/// others texts, but for "=B1", a formula without its value. `formats`: number formats of the columns from
/// the left on.
[[nodiscard]] QByteArray storedWorkbook(const std::vector<QStringList> &rows,
                                        const std::vector<MergedCells> &merged = {},
                                        const QStringList &formats = {});
/// An .ods of one sheet, and one named Cover: "3.5|3.50 in" is the number 3.5, which is displayed so; other
/// cells are texts. `hidden`: a row of the first, from 0.
[[nodiscard]] QByteArray storedOds(const std::vector<QStringList> &rows,
                                   const std::vector<QStringList> &cover = {}, int hidden = -1);

} // namespace palmer::testdata
