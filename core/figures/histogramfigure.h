// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "kernel/evaluation/testevaluation.h"
#include "kernel/measurement/test.h"
#include "language/language.h"

#include <optional>

namespace palmer {

/// Simulated distribution of a parameter (µm; rotary: arc seconds): histogram, shortest interval that
/// contains 95.45 % of the values, their mean, and the value evaluated from the readings. The axis covers the
/// counted values and the evaluated one. Null if the parameter was not simulated. `resolution`: the finest of
/// the instruments (mm, rotary: degrees); numbers are printed as in the tables.
[[nodiscard]] std::optional<HistogramFigure>
histogramFigure(const Test &test, const TestEvaluation &evaluation, const Parameter &parameter,
                const Language &language, std::optional<double> resolution = {});

} // namespace palmer
