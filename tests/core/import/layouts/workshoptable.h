// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/positioning.h"

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <random>
#include <vector>

namespace palmer::testdata {

/// A table as people in workshops make them, with what was measured: it knows nothing of the reader.
struct WorkshopTable {
    QByteArray bytes;
    QString text;                              ///< what the bytes say
    QString description;                       ///< language, layout, form: for the one who looks for a fault
    std::vector<double> targets;               ///< mm, ascending
    std::vector<std::vector<double>> positive; ///< deviations in µm of the runs ↑, in their order
    std::vector<std::vector<double>> negative;
    bool statesUnits = true;
};

/// One of them: five languages, targets down or across, the directions side by side, alternating, in blocks,
/// stacked under a column of directions, or one reading a line; a title, further columns, decimal marks,
/// separators, units, encodings, line ends. The same for the same state of the generator, on every system.
[[nodiscard]] WorkshopTable workshopTable(std::mt19937 &random);

/// A table of one block as rows of cells, headings first, in English; its numbers with a point.
struct PlainTable {
    std::vector<QStringList> rows;
};
[[nodiscard]] PlainTable plainTable(std::mt19937 &random);

/// Any words, numbers and delimiters: no table of anything.
[[nodiscard]] QByteArray randomText(std::mt19937 &random);

} // namespace palmer::testdata
