// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "language/language.h"

#include <QByteArray>
#include <vector>

namespace palmer {

/// The name of the certificate as an attachment of a report.
inline constexpr const char *dccFileName = "dcc.xml";

/// Returns what the schema of digital calibration certificates obliges and the document does not state; and U
/// where a simulation that is to give it was not run. Before the evaluation only what the document lacks.
[[nodiscard]] std::vector<Text> missingForDcc(const EvaluatedDocument &evaluated);

/// Throws Error with one sentence that names all of it, in `language`.
void requireForDcc(const EvaluatedDocument &evaluated, const Language &language);

/// How D-SI writes the unit in which a quantity is shown: "\micro\metre".
[[nodiscard]] const char *dsiUnit(Quantity quantity);

/// The results as a digital calibration certificate: DCC 3.2.0 of the Physikalisch-Technische Bundesanstalt
/// with D-SI 2.1.0, XML in UTF-8, names and sentences in French and English. Every value, U and limit is
/// unrounded, in the unit shown (µm, arc seconds). Each limit has a statement of conformity; a test has one
/// only where its accordance with the edition allows a verdict. Precondition: nothing is missing.
[[nodiscard]] QByteArray dcc(const EvaluatedDocument &evaluated);

} // namespace palmer
