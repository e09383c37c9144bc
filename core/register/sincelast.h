// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/comparedtests.h"
#include "language/language.h"
#include "register/queries.h"

#include <memory>
#include <nlohmann/json_fwd.hpp>

namespace palmer {

/// The changes of a test since the last one of its axis or plane.
struct SinceLast {
    TestPlace last; ///< place of the last one
    std::optional<std::string> date;
    TestComparison comparison;
};

/// Returns the newest test before `of` with the same kind and axis or plane but other readings, among the
/// tests of a machine in the order of tests(). Null: none.
[[nodiscard]] std::optional<std::size_t> lastBefore(const std::vector<ListedTest> &tests, std::size_t of);

/// Compares two tests as their files have them. Null if a file cannot be read any more or has changed.
[[nodiscard]] std::shared_ptr<const SinceLast> sinceLast(const ListedTest &before, const ListedTest &now);

/// Sets `sinceLast` of each of the tests of a machine in the order of tests().
void findChanges(std::vector<ListedTest> &tests);

/// Returns what is said of one result ("A", "G_XY"); null: it is not compared.
[[nodiscard]] const ComparedParameter *changeOf(const SinceLast &change, const std::string &result);

/// Returns `difference`, `expandedUncertainty` (mm or degrees) and `word`, after the keys of `head`.
[[nodiscard]] nlohmann::ordered_json changeJson(nlohmann::ordered_json head, const ComparedParameter &change);

/// "changed, worse", or why nothing is said.
[[nodiscard]] QString sinceLastWord(const SinceLast &change, const Language &language);

} // namespace palmer
