// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/filenotes.h"
#include "import/labelledvalues.h"

#include <QString>
#include <string>

namespace palmer {

/// The text of a statement; "Unit of deviations" | "nm" as "Unit of deviations: nm".
[[nodiscard]] QString statementOf(const LabelledValue &said);

/// "Position units: mm", "Deviations in nm", "Scale factor 0.1", "Signs inverted": what a line says of the
/// form of the numbers. True if it is understood; else its words are kept where they could change the
/// numbers, so that they are asked for.
[[nodiscard]] bool readForm(const LabelledValue &said, FileNotes &notes);

/// True for a label that names a unit, with one: "Unit of the positions: mm".
[[nodiscard]] bool isUnitWithLabel(const LabelledValue &said);

/// Gives a unit of no stated quantity to those without one of their own, and the factor to the readings.
void settleUnits(FileNotes &notes);

/// True for words that doubt the readings: "run 2 is invalid", "aborted", "Strahl unterbrochen".
[[nodiscard]] bool doubtsReadings(const std::string &line);

} // namespace palmer
