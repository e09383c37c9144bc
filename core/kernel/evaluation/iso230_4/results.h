// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/iso230_4/circularcase.h"

#include <string>
#include <vector>

namespace palmer::iso230_4 {

/// Paths, circles and correction of a measurement: all that its parameters are computed from.
[[nodiscard]] CircularResults circularResults(const CircularMeasurement &measurement);

/// A parameter that a test has: a row of its edition for a path, or for the pair (null).
struct ListedParameter {
    const CircularRow *row = nullptr;
    const EvaluatedPath *path = nullptr;
    std::string index;
};

/// The parameters of a test in the order of its edition. They point into the results of the case.
[[nodiscard]] std::vector<ListedParameter> listedParameters(const CircularCase &test);

/// The value of one of them, mm; null where it cannot be had.
[[nodiscard]] std::optional<double> value(const ListedParameter &parameter, const CircularCase &test);

/// The standard deviation of each listed parameter over the repeated circles of a test, mm: the second path
/// of each sense is evaluated as the first is, and so on. Null where nothing was repeated.
[[nodiscard]] std::vector<std::optional<double>> repeatabilities(const CircularCase &test);

} // namespace palmer::iso230_4
