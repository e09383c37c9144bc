// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/iso230_4/circularcase.h"

#include <string>
#include <vector>

namespace palmer::iso230_4 {

/// Returns paths, circles and correction of a measurement, from which its parameters are computed.
[[nodiscard]] CircularResults circularResults(const CircularMeasurement &measurement);

/// A parameter of a test: a row of its edition for a path, or for the pair (null).
struct ListedParameter {
    const CircularRow *row = nullptr;
    const EvaluatedPath *path = nullptr;
    std::string index;
};

/// Returns the parameters of a test in the order of its edition. They point into the results of the case.
[[nodiscard]] std::vector<ListedParameter> listedParameters(const CircularCase &test);

/// Returns the value of a parameter, mm; null if unavailable.
[[nodiscard]] std::optional<double> value(const ListedParameter &parameter, const CircularCase &test);

/// Returns the standard deviation of each listed parameter over the repeated circles of a test, mm: the
/// second path of each sense is evaluated like the first, and so on. Null if nothing was repeated.
[[nodiscard]] std::vector<std::optional<double>> repeatabilities(const CircularCase &test);

} // namespace palmer::iso230_4
