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

/// Source of a finding. text: the cited clause of the edition of the test. practice: the field's practice or
/// another edition, not verified in this one. laboratory: good laboratory practice, decision rules. program:
/// what the computation needs, lacks or assumes. Only requirements of the text count for accordance, and only
/// they have a clause.
enum class Source { text, practice, laboratory, program };

/// unmet: false, contradicted by the data, or a statement that the report must contain and does not;
/// undeclared: not stated, which is neither a fault nor accordance.
enum class State { unmet, undeclared };

/// Subject of a finding, i.e. where it can be corrected.
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

/// Part of the report that a finding explains: the report repeats it there.
enum class Explains { nothing, missingValues, missingUncertainty, substituteReadings };

/// Something the edition asks for and this test lacks, or something a reader of the results must know.
struct Finding {
    Grade grade = Grade::note;
    Source source = Source::program;
    std::optional<State> state = {}; ///< for requirements, also of practice; null for all others
    Subject subject = Subject::readings;
    std::string clause = {};            ///< empty if unknown
    std::string id = {};                ///< stable, for scripts
    std::vector<std::string> keys = {}; ///< fields of the file, relative to the test or the document
    /// Name of what is not declared, not stated or not agreed; `message` then is a text that takes one or
    /// several names and their number ("Not declared%2: %1."). Empty if the message is complete by itself.
    Text name = {};
    std::string letter = {};  ///< of a point to be agreed: precedes its name
    std::string results = {}; ///< results it is missing for, "A, R": follow its name
    Explains explains = Explains::nothing;
    bool missing = false; ///< the file lacks something the user can state
    Message message = {};

    bool operator==(const Finding &) const = default;
};

} // namespace palmer
