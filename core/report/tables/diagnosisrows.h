// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/diagnosis/diagnosis.h"
#include "language/language.h"

#include <QString>
#include <optional>
#include <vector>

namespace palmer {

/// What a row of a diagnosis is.
enum class DiagnosisRowKind {
    source,   ///< with a value
    sum,      ///< of sources that cannot be told apart
    notTold,  ///< without a value, with the reason
    fitCircle ///< centre or radius: taken out before any deviation is stated
};

/// A source as it is read in the window, on paper and in a terminal.
struct DiagnosisRow {
    DiagnosisRowKind kind = DiagnosisRowKind::source;
    std::vector<std::size_t> sources; ///< places in the diagnosis: all that make its trace
    QString name;                     ///< "Backlash X", "Lateral play X + Backlash Y"
    QString value;                    ///< with the digits u allows; empty: none
    QString u;
    Quantity quantity = Quantity::number; ///< of value and u
    QString unit;
    std::optional<double> contribution; ///< to G(b), alone, mm
    QString meaning;                    ///< a sentence: what it is; or why it has no value
    QString advice;                     ///< a sentence: what to look at on the machine; may be empty
};

/// Sources and sums, the largest contribution first; then what is not told; centre and radius last.
[[nodiscard]] std::vector<DiagnosisRow> diagnosisRows(const Diagnosis &diagnosis, const Language &language);

/// Digits after the point of a value with that standard uncertainty: two significant ones of u; 0 … 4.
[[nodiscard]] int decimalsOfEstimate(double standardUncertainty);

} // namespace palmer
