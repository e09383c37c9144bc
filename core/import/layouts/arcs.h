// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/choices.h"
#include "import/remark.h"
#include "kernel/measurement/circular.h"

#include <optional>
#include <string>
#include <vector>

namespace palmer {

/// Settles the common properties of circular tests: plane, feed, calibrated length, correction to 20 °C,
/// edition. `plane`, `feed`: from the file, or empty.
void resolveCircle(CircularMeasurement &measurement, std::string &edition, std::string_view plane,
                   std::optional<double> feed, Choices &choices, Remarks &remarks);

/// True for words of the choice "layout" that describe points of a circle.
[[nodiscard]] bool isLayoutOfCircles(std::string_view word);

/// Angles made continuous: no step beyond 180°.
void unwrap(std::vector<double> &degrees);

/// The sense in which a path's angles run.
[[nodiscard]] Sense senseOf(const std::vector<double> &unwrapped);

} // namespace palmer
