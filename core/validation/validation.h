// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/parameter.h"
#include "validation/referenceset.h"

#include <QByteArray>
#include <QString>
#include <optional>
#include <vector>

namespace palmer {

/// A computed value and the expected one, in the unit of the set (mm, or none).
struct Comparison {
    Expectation expectation;
    QString of;        ///< the edition, or the file of the points
    Symbol symbol;     ///< "A↑"
    std::string index; ///< "XY" for the plane, "10" for the target
    std::optional<double> computed;
    std::optional<double> difference; ///< computed − expected; relative if the tolerance is
    bool agrees = false;
};

struct SetValidation {
    QString name;
    QString origin;
    Quantity quantity = Quantity::deviation;
    std::vector<Comparison> comparisons;
    bool points = false; ///< for point sets, not tests

    [[nodiscard]] bool agrees() const;
};

/// Evaluates a reference set like any test, under the editions it has expectations for.
[[nodiscard]] SetValidation validate(const ReferenceSet &set);

/// Compares a number with its expectation. `relative`: so is the difference.
void compareWith(Comparison &comparison, double computed);

/// Evaluates all embedded reference data, for `selftest` and the help. Throws Error if one cannot be read.
[[nodiscard]] std::vector<SetValidation> validateAll();

/// Fits circles to the embedded point sets (`reference/circles`) and compares them with their known circles:
/// centre and radius by least squares, and width, with its certificate, of the minimum zone. NIST sets first,
/// then constructed ones. Throws Error if the data cannot be read.
[[nodiscard]] std::vector<SetValidation> validateCircles();

} // namespace palmer
