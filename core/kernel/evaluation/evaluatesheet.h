// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/parameter.h"
#include "kernel/evaluation/testevaluation.h"
#include "kernel/measurement/sheet.h"

#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace palmer {

/// In the order of Verdict, then what has none.
enum class SheetState { conforms, notProven, doesNotConform, notMeasured, noLimit, notApplicable };

/// Why a row that names a parameter of a test is not measured.
enum class SheetGap { noSuchTest, noSuchParameter, noValue };

/// A row of the acceptance sheet with the numbers it is judged by.
struct SheetResult {
    SheetState state = SheetState::notMeasured;
    std::optional<double> value; ///< in the unit of the row; of a parameter: mm or degrees
    std::optional<double> uncertainty;
    Permitted permitted;
    std::optional<double> guardBand;
    std::optional<SheetGap> gap;          ///< null unless the row names a parameter without a value
    std::optional<std::size_t> test;      ///< index of the named test; null: none
    const Parameter *parameter = nullptr; ///< owned by the evaluation of that test
};

/// A test that rows may name.
struct NamedTest {
    std::string_view id;
    const TestEvaluation *evaluation = nullptr;
};

/// Judges each row: numbers of its own by the decision rule; a row that names a parameter of a test has its
/// value, deciding U, limit and verdict, which also counts the conditions of the test. A range has a guard
/// band at both ends; no U proves nothing where the rule needs one.
[[nodiscard]] std::vector<SheetResult> evaluateSheet(std::span<const SheetRow> rows, const DecisionRule &rule,
                                                     std::span<const NamedTest> tests);

/// Why rows that name a parameter of a test are not measured, one finding each.
[[nodiscard]] std::vector<Finding> findingsOf(std::span<const SheetRow> rows,
                                              std::span<const SheetResult> results);

/// Verdict on a sheet: conforms only if all rows that apply do; does not conform if one does not. Null if no
/// row applies, or none of those that do has a limit or lacks a value.
[[nodiscard]] std::optional<Verdict> verdictOf(std::span<const SheetResult> results);

} // namespace palmer
