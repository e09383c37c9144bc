// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/parameter.h"
#include "validation/referenceset.h"

#include <QString>
#include <optional>
#include <vector>

namespace palmer {

/// A computed value beside the expected one, in the unit of the set (mm, or none).
struct Comparison {
    Expectation expectation;
    QString of;        ///< the edition, or the file of the points
    Symbol symbol;     ///< "A↑"
    std::string index; ///< of the plane "XY", of the target "10"
    std::optional<double> computed;
    std::optional<double> difference; ///< computed − expected; relative where the tolerance is
    bool agrees = false;
};

struct SetValidation {
    QString name;
    QString origin;
    Quantity quantity = Quantity::deviation;
    std::vector<Comparison> comparisons;
    bool points = false; ///< of sets of points, not of tests

    [[nodiscard]] bool agrees() const;
};

/// Evaluates a reference set, as any test is evaluated, under the editions it has expectations for.
[[nodiscard]] SetValidation validate(const ReferenceSet &set);

/// Compares a number with what is expected of it. `relative`: the difference too.
void compareWith(Comparison &comparison, double computed);

/// Evaluates all embedded reference data: what `selftest` and the help show. Throws Error if one cannot be
/// read.
[[nodiscard]] std::vector<SetValidation> validateAll();

} // namespace palmer
