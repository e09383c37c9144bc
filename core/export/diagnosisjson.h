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

/// The diagnosis of a circular test as JSON: values in the unit of each source, other lengths in mm, null if
/// unknown; null if the test gives no diagnosis. Sentences in `language`.
[[nodiscard]] nlohmann::ordered_json diagnosisJson(const Test &test, const TestEvaluation &evaluation,
                                                   const Language &language);

/// Joint diagnoses of the tests of one plane at several feeds: a list of {tests (from 1), diagnosis}; may be
/// empty.
[[nodiscard]] nlohmann::ordered_json feedDiagnosesJson(const EvaluatedDocument &evaluated,
                                                       const Language &language);

/// The true parameters of a synthetic measurement, for checking an evaluation: ids, units and signs of the
/// diagnosis. Ends with a line break.
[[nodiscard]] QByteArray truthJson(const CircularSynthesis &asked, std::span<const double> feeds);
[[nodiscard]] QByteArray truthJson(const PositioningSynthesis &asked);
[[nodiscard]] QByteArray truthJson(const DriftSynthesis &asked);

} // namespace palmer
