// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/words/message.h"

#include <optional>
#include <string>
#include <vector>

namespace palmer {

/// requirement: the standard says "shall"; recommendation: "should" (fr. « il convient »); note: worth
/// knowing.
enum class Grade { requirement, recommendation, note };

/// Where a finding comes from. text: the clause that is cited, of the edition of the test. practice: the
/// field's practice or another edition, not verified in this one. laboratory: good practice of a laboratory,
/// decision rules. program: what the computation needs, lacks or assumes. Only requirements of the text count
/// for accordance; a clause is known of the text alone.
enum class Source { text, practice, laboratory, program };

/// unmet: false, contradicted by the data, or a statement that the report must contain and does not;
/// undeclared: not stated, which is neither a fault nor an accordance.
enum class State { unmet, undeclared };

/// What a finding speaks of: where it is mended.
enum class Subject {
    readings,
    conditions,
    agreedPoints,
    limits,
    uncertainty,
    machine,
    instruments,
    namedInstruments,
    report
};

/// What else of the report a finding explains: the report repeats it there.
enum class Explains { nothing, missingValues, missingUncertainty, substituteReadings };

/// Something the edition asks for and this test does not have, or what a reader of the results must know.
struct Finding {
    Grade grade = Grade::note;
    Source source = Source::program;
    std::optional<State> state = {}; ///< of a requirement, also one of practice; null for all else
    Subject subject = Subject::readings;
    std::string clause = {};            ///< empty where it is not known
    std::string id = {};                ///< stable, for scripts
    std::vector<std::string> keys = {}; ///< fields of the file, from the test or the document on
    /// What is not declared, not stated or not agreed, in words; `message` is then a text that takes one, or
    /// several and how many they are ("Not declared%2: %1."). Empty where the message stands for itself.
    Text name = {};
    std::string letter = {};  ///< of a point to be agreed: stands before its name
    std::string results = {}; ///< that it is missing of, "A, R": stand behind its name
    Explains explains = Explains::nothing;
    bool missing = false; ///< something the file lacks and the user may state
    Message message = {};

    bool operator==(const Finding &) const = default;
};

} // namespace palmer
