#pragma once

#include "document/document.h"
#include "document/documenterror.h"
#include "kernel/evaluation/edition.h"

#include <QByteArray>
#include <string>
#include <variant>

namespace palmer {

/// A set of limits with the rule they are judged by, for tests of one kind. Every limit names the edition it
/// was agreed for.
struct LimitSet {
    Kind kind = Kind::positioning;
    Limits limits;
    DecisionRule decisionRule;

    bool operator==(const LimitSet &) const = default;
};

/// What is always the same and entered once: the own machine, the own laser, the company head, agreed limits.
struct Template {
    std::string name;
    std::variant<Machine, Instrument, Laboratory, LimitSet> content;

    bool operator==(const Template &) const = default;
};

// The template file, JSON in UTF-8 like the test file and checked by its reader, so that keys, words and
// versions are those of the test file:
//
//     {"format": "palmer template", "version": 1, "name": "DMU 50",
//      "machine": {…}}                  as `machine` of a test file, or
//      "instrument": {…}                as one of `instruments`, or
//      "laboratory": {…}                as `report.laboratory`, or
//      "kind": "positioning" | "circular", "limits": {…}, "decisionRule": {…}   as in a test
//
// Exactly one of the four. Anything else, an unknown key among it, is refused.

/// Throws Error with place and expectation for everything the format does not allow.
[[nodiscard]] Template readTemplate(const QByteArray &bytes);

[[nodiscard]] QByteArray writeTemplate(const Template &content);

/// The limits of a test as a set: what names no edition was agreed for that of the test. Empty for drift
/// tests.
[[nodiscard]] LimitSet limitSetOf(const Test &test);

/// Puts a set of limits in the place of those of the test; false, and no change, for a test of another kind.
bool applyLimitSet(Test &test, const LimitSet &set);

} // namespace palmer
