// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"

#include <cstddef>
#include <optional>

namespace palmer {

/// Copies from another test of the same machine the statements common to all its tests: warm-up,
/// compensation, load and state of the machine, positions of the temperature sensors, α; the agreed points
/// that name no axis; the decision rule; between tests of one kind (and axes of one motion) also instruments,
/// feed and dwell, and the budget inputs on instrument and sensors. Unchanged: measured values (temperatures,
/// pressure, humidity, drift), what belongs to the axis (limits, offsets, positions), dates, remarks. No
/// effect on drift tests, which state no conditions.
void takeStatements(Test &test, const Test &from);

/// Removes what is measured or stated on the day of a test: date, time, temperatures, gradient, pressure,
/// humidity, drift, the declaration on its accordance, remarks.
void forgetDay(Test &test);

/// Fills what is not stated of the machine and of test `index` with what test `from` of the same machine
/// states: instruments, conditions, agreed points, inputs of the budget; for the same axis or plane also its
/// data, limits and decision rule. Overwrites nothing, and takes nothing that is measured on the day of a
/// test.
void fillLike(Document &document, std::size_t index, const Document &source, std::size_t from);

/// True if both tests are of one kind and of the same axis or plane.
[[nodiscard]] bool areOfOneAxis(const Test &test, const Test &other);

/// Returns the newest other test of the document that test `index` can be filled like, rather one of its
/// axis; null if there is none.
[[nodiscard]] std::optional<std::size_t> lastTestLike(const Document &document, std::size_t index);

} // namespace palmer
