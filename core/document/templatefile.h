// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "document/documenterror.h"
#include "kernel/evaluation/edition.h"

#include <QByteArray>
#include <string>
#include <variant>

namespace palmer {

/// A set of limits with its decision rule, for tests of one kind and motion: the same number is a length on a
/// linear axis and an angle on a rotary one. Each limit names the edition it was agreed for.
struct LimitSet {
    Kind kind = Kind::positioning;
    Limits limits;
    DecisionRule decisionRule;
    Motion motion = Motion::linear;

    bool operator==(const LimitSet &) const = default;
};

/// Conditions that are the same for every test at a site: state of the machine, warm-up, environment; nothing
/// measured. Empty values are not part of it.
struct Declarations {
    Conditions conditions;

    bool operator==(const Declarations &) const = default;
};

/// Data that never change and are entered once: own machine, own laser, company head, agreed limits, how
/// tests are made.
struct Template {
    std::string name;
    std::variant<Machine, Instrument, Laboratory, LimitSet, Declarations> content;

    bool operator==(const Template &) const = default;
};

// The template file, JSON in UTF-8 like the test file and checked by its reader, so that keys, words and
// versions are those of the test file:
//
//     {"format": "palmer template", "version": 1, "name": "DMU 50",
//      "machine": {…}}                  as `machine` of a test file, or
//      "instrument": {…}                as one of `instruments`, or
//      "laboratory": {…}                as `report.laboratory`, or
//      "kind": "positioning" | "circular", "motion": "rotary" (absent: "linear"),
//      "limits": {…}, "decisionRule": {…}   as in a test, or
//      "conditions": {…}                what Declarations holds of `conditions` of a test
//
// Exactly one of the five. Anything else, an unknown key among it, is refused.

/// Throws Error with place and expectation for everything the format does not allow.
[[nodiscard]] Template readTemplate(const QByteArray &bytes);

[[nodiscard]] QByteArray writeTemplate(const Template &content);

/// Returns the limits of a test as a set: a limit without edition was agreed for that of the test. Empty for
/// drift tests.
[[nodiscard]] LimitSet limitSetOf(const Test &test);

/// Returns the declarations of a test; empty for drift tests.
[[nodiscard]] Declarations declarationsOf(const Test &test);

/// Copies what is stated there and leaves the rest unchanged; returns false without change for a drift test.
bool applyDeclarations(Test &test, const Declarations &declarations);

/// True for a test of the kind and motion that the limits are for.
[[nodiscard]] bool fits(const LimitSet &set, const Test &test);

/// Replaces the limits of the test; returns false without change where they do not fit.
bool applyLimitSet(Test &test, const LimitSet &set);

} // namespace palmer
