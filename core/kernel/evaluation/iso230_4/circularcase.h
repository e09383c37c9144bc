// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/edition.h"
#include "kernel/evaluation/surroundings.h"
#include "kernel/evaluation/testevaluation.h"

#include <optional>

namespace palmer {

/// A circular test and all that its parameters and requirements look at. Owns nothing.
struct CircularCase {
    const Test &test;
    const CircularMeasurement &measurement;
    const Surroundings &surroundings;
    const Edition &edition;
    const CircularResults &results;
    std::string withoutUncertainty = {}; ///< as resultsWithoutUncertainty

    [[nodiscard]] const CircularConditions &conditions() const { return measurement.conditions; }
    [[nodiscard]] const Conditions &common() const { return measurement.conditions.common; }
    [[nodiscard]] bool feedback() const { return measurement.source == SignalSource::feedback; }

    /// The path of that sense; null where none was measured.
    [[nodiscard]] const EvaluatedPath *path(Sense sense) const;
    /// Of a path of each sense there are points enough to evaluate.
    [[nodiscard]] bool bothSenses() const;
    /// Both senses, both full circles.
    [[nodiscard]] bool twoFullCircles() const;
    /// A result the parties asked for; all where they asked for none.
    [[nodiscard]] bool isRequired(const Term &term) const;
    /// The parties say which results they ask for: by name, or by the limits they agreed.
    [[nodiscard]] bool resultsStated() const;
    /// The edition has such a result, or one of both paths, and the parties ask for it; for all where they do
    /// not say.
    [[nodiscard]] bool asksFor(OfCircle what) const;
    [[nodiscard]] bool asksForPair() const;
    /// F or D is asked for and can be: the reference length counts, the temperature too.
    [[nodiscard]] bool needsLength() const;
    /// The reference length is stated to be uncalibrated: F and D are refused.
    [[nodiscard]] bool notCalibrated() const;

private:
    [[nodiscard]] bool asksForRow(const struct CircularRow &row) const;
};

/// One parameter of an edition of ISO 230-4.
struct CircularRow {
    Term term;
    bool external = false;             ///< of an external instrument; else of the feedback signal
    bool dependsOnTemperature = false; ///< a length: corrected to 20 °C
    /// Value in mm; null where it cannot be had. `path` is null for a pair.
    std::optional<double> (*value)(const CircularCase &, const EvaluatedPath *path) = nullptr;
};

using CircularRequirement = RequirementOf<CircularCase>;

/// What an edition of ISO 230-4 computes and asks for.
struct CircularRules {
    std::span<const CircularRow> rows;
    std::span<const CircularRequirement> requirements;
};

} // namespace palmer
