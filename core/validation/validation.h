// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "validation/referenceset.h"

#include <QByteArray>
#include <QString>
#include <optional>
#include <vector>

namespace palmer {

/// A computed value and the expected one, in the unit of the set (mm, or none).
struct Comparison {
    Expectation expectation;
    QString place; ///< what it is of, in the words of the file: "test 3 A budget"
    std::optional<double> computed = {};
    std::string word = {};                 ///< computed, where a word is expected
    std::optional<double> difference = {}; ///< computed − expected; relative if the tolerance is
    bool agrees = false;
};

struct SetValidation {
    Words name;
    Words origin;
    Quantity quantity = Quantity::deviation;
    std::vector<Comparison> comparisons;
    QByteArray file = {}; ///< its bytes

    [[nodiscard]] bool agrees() const;
};

/// Evaluates a reference set like any tests, with the variants and editions it has expectations for;
/// simulates those of method monteCarlo.
[[nodiscard]] SetValidation validate(const ReferenceSet &set);

/// Evaluates files of reference data. Throws Error if one cannot be read.
[[nodiscard]] std::vector<SetValidation> validateFiles(const QStringList &names);

/// The self-test that a report states: true if the quick sets agree. Run once in a process, on any thread.
[[nodiscard]] bool selfTestPasses();

} // namespace palmer
