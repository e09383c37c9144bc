// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "kernel/diagnosis/diagnosis.h"
#include "kernel/diagnosis/synthesize.h"
#include "language/language.h"

#include <nlohmann/json_fwd.hpp>

#include <QByteArray>

namespace palmer {

/// The diagnosis of a circular test as JSON: values in the unit of each source, lengths of the whole in mm,
/// null where there is none; null for a test that gives no diagnosis. Sentences in `language`.
[[nodiscard]] nlohmann::ordered_json diagnosisJson(const Test &test, const TestEvaluation &evaluation,
                                                   const Language &language);

/// What the tests of one plane at several feeds say together: a list of {tests (from 1), diagnosis}; empty
/// where there are none.
[[nodiscard]] nlohmann::ordered_json feedDiagnosesJson(const EvaluatedDocument &evaluated,
                                                       const Language &language);

/// What a measurement was made from, for whoever tests an evaluation against it: ids, units and signs of the
/// diagnosis. Ends with a line break.
[[nodiscard]] QByteArray truthJson(const CircularSynthesis &asked, std::span<const double> feeds);
[[nodiscard]] QByteArray truthJson(const PositioningSynthesis &asked);

} // namespace palmer
