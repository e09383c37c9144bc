#pragma once

#include "kernel/measurement/positioning.h"

#include <QByteArray>
#include <QString>
#include <random>

namespace palmer::testdata {

/// A table as people in workshops make them, with what was measured: it knows nothing of the reader.
struct WorkshopTable {
    QByteArray bytes;
    QString text; ///< what the bytes say
    QString description; ///< language, layout, form: for the one who looks for a fault
    std::vector<double> targets; ///< mm, ascending
    std::vector<std::vector<double>> positive; ///< deviations in µm of the runs ↑, in their order
    std::vector<std::vector<double>> negative;
};

/// One of them: five languages, targets down or across, the directions side by side, alternating, in blocks,
/// stacked under a column of directions, or one reading a line; a title, further columns, decimal marks,
/// separators, units, encodings, line ends. The same for the same state of the generator, on every system.
[[nodiscard]] WorkshopTable workshopTable(std::mt19937 &random);

} // namespace palmer::testdata
