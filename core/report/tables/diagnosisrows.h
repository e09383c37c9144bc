// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/diagnosis/diagnosis.h"
#include "kernel/measurement/test.h"
#include "language/language.h"

#include <QStringList>
#include <optional>
#include <vector>

namespace palmer {

enum class DiagnosisRowKind {
    source,   ///< has a value
    sum,      ///< sum of inseparable sources
    notTold,  ///< has no value, but a reason
    fitCircle ///< centre or radius: removed before deviations are stated
};

/// A source as shown in the window, on paper and in a terminal.
struct DiagnosisRow {
    DiagnosisRowKind kind = DiagnosisRowKind::source;
    std::vector<std::size_t> sources;     ///< indices in the diagnosis: all that contribute to its trace
    QString name;                         ///< "Backlash X", "Lateral play X + Backlash Y"
    QString value;                        ///< with the digits that u allows; may be empty
    QString expanded;                     ///< half its 95 % interval; empty for an indication
    Quantity quantity = Quantity::number; ///< of value and interval
    QString unit;
    std::optional<double> contribution; ///< to G(b), of this source alone, mm
    QString meaning;                    ///< a sentence: what it is, or why it has no value
    QString advice;                     ///< a sentence: what to check on the machine; may be empty
};

/// Returns what has to be said before any source: a rotation, and what in the rest no noise explains.
[[nodiscard]] QStringList diagnosisWarnings(const Diagnosis &diagnosis, const Language &language);

/// Sources and sums, the largest contribution first; then those without a value; centre and radius last.
[[nodiscard]] std::vector<DiagnosisRow> diagnosisRows(const Diagnosis &diagnosis, const Language &language);

/// Decimals of a value with that standard uncertainty: two significant digits of u; 0 … 4.
[[nodiscard]] int decimalsOfEstimate(double standardUncertainty);

/// A machine fault stated by the program of the instrument, compared with our own diagnosis.
struct StatedSource {
    QString name; ///< as in its file: "AF_SQUARENESS"
    QString stated;
    QString statedUnit;
    QString source;   ///< "Squareness X–Y"
    QString here;     ///< empty if the circle does not determine it
    QString expanded; ///< half its 95 % interval; empty for an indication
    QString unit;
    QString positive; ///< a sentence: meaning of a positive value of ours
};

/// Results of the imported files of a test that are recognised by name. Their signs are those of the file,
/// which states no convention.
[[nodiscard]] std::vector<StatedSource> statedSources(const Test &test, const Diagnosis &diagnosis,
                                                      const Language &language);

} // namespace palmer
