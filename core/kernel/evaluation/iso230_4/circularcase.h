// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/edition.h"
#include "kernel/evaluation/surroundings.h"
#include "kernel/evaluation/testevaluation.h"

#include <optional>

namespace palmer {

/// A circular test with all inputs of its parameters and requirements. Owns nothing.
struct CircularCase {
    const Test &test;
    const CircularMeasurement &measurement;
    const Surroundings &surroundings;
    const Edition &edition;
    const CircularResults &results;
    std::string withoutUncertainty = {}; ///< from resultsWithoutUncertainty

    [[nodiscard]] const CircularConditions &conditions() const { return measurement.conditions; }
    [[nodiscard]] const Conditions &common() const { return measurement.conditions.common; }
    [[nodiscard]] bool feedback() const { return measurement.source == SignalSource::feedback; }

    /// Returns the path of that sense; null if not measured.
    [[nodiscard]] const EvaluatedPath *path(Sense sense) const;
    /// True if a path of each sense has enough points to evaluate.
    [[nodiscard]] bool bothSenses() const;
    /// True if both senses were measured as full circles.
    [[nodiscard]] bool twoFullCircles() const;
    /// True if the parties asked for the result, or for none in particular.
    [[nodiscard]] bool isRequired(const Term &term) const;
    /// True if the parties state the results they ask for: by name, or by agreed limits.
    [[nodiscard]] bool resultsStated() const;
    /// True if the edition has such a result, or one of both paths, and the parties ask for it, or for none
    /// in particular.
    [[nodiscard]] bool asksFor(OfCircle what) const;
    [[nodiscard]] bool asksForPair() const;
    /// True if F or D is asked for and possible: reference length and temperature then matter.
    [[nodiscard]] bool needsLength() const;
    /// True if the reference length is stated to be uncalibrated: F and D are refused.
    [[nodiscard]] bool notCalibrated() const;

private:
    [[nodiscard]] bool asksForRow(const struct CircularRow &row) const;
};

/// One parameter of an edition of ISO 230-4.
struct CircularRow {
    Term term;
    bool external = false;             ///< measured by an external instrument; otherwise the feedback signal
    bool dependsOnTemperature = false; ///< a length: corrected to 20 °C
    /// Value in mm; null if unavailable. `path` is null for a pair.
    std::optional<double> (*value)(const CircularCase &, const EvaluatedPath *path) = nullptr;
};

using CircularRequirement = RequirementOf<CircularCase>;

/// Parameters and requirements of an edition of ISO 230-4.
struct CircularRules {
    std::span<const CircularRow> rows;
    std::span<const CircularRequirement> requirements;
};

} // namespace palmer
