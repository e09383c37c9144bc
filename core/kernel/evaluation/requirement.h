// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/finding.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace palmer {

/// How a requirement stands. `sentence`: of an unmet one what is wrong; null: the subject of its row says it.
struct Judgement {
    std::optional<State> state = {}; ///< null: met
    std::optional<Message> sentence = {};
    Text name = {}; ///< of a row made of several fields those that are missing; empty: all that it asks for
    std::string results = {}; ///< what it is missing of; empty: the test

    [[nodiscard]] static Judgement met() { return {}; }
    [[nodiscard]] static Judgement unmet() { return {State::unmet}; }
    [[nodiscard]] static Judgement unmet(Message message) { return {State::unmet, std::move(message)}; }
    [[nodiscard]] static Judgement undeclared() { return {State::undeclared}; }
    /// Of a row made of several fields: `missing` has a bit for each that is, `names` their names by these
    /// bits (an empty one, or none: the name of the row).
    [[nodiscard]] static Judgement lacking(State state, unsigned missing, std::span<const Text> names) {
        if (missing == 0)
            return met();
        return {state, {}, missing < names.size() ? names[missing] : Text{}};
    }
    /// Of a condition that is declared or not.
    [[nodiscard]] static Judgement of(std::optional<bool> condition) {
        return !condition ? undeclared() : *condition ? met() : unmet();
    }
    /// Met unless there is a sentence that says what is wrong.
    [[nodiscard]] static Judgement of(std::optional<Message> wrong) {
        return wrong ? unmet(std::move(*wrong)) : met();
    }
};

/// One row of what an edition asks of a test; `Case` is a test and all that is known of it.
template <class Case>
struct RequirementOf {
    const char *id = nullptr;
    Source source = Source::text;
    const char *clause = nullptr;        ///< of the text; else empty
    Grade modality = Grade::requirement; ///< what the clause says: shall, should, or worth knowing
    Subject subject = Subject::readings;
    bool (*applies)(const Case &) = nullptr; ///< null: always
    Judgement (*judge)(const Case &) = nullptr;
    Text name = {};     ///< what it asks for: "Not declared: …", "Not stated in the report: …"
    Text sentence = {}; ///< when it is unmet and the judgement says nothing of its own
    std::array<const char *, 2> keys = {};
    Explains explains = Explains::nothing;
};

/// The sentence of a finding that names what is missing, by its source and state.
[[nodiscard]] Text missingText(Source source, std::optional<State> state);

/// The finding of a row that is not met.
template <class Case>
[[nodiscard]] Finding findingOf(const RequirementOf<Case> &row, Judgement judgement) {
    const bool counted =
        row.modality == Grade::requirement && (row.source == Source::text || row.source == Source::practice);
    Finding finding;
    finding.grade = row.source == Source::text ? row.modality : Grade::note;
    finding.source = row.source;
    if (counted)
        finding.state = judgement.state;
    finding.subject = row.subject;
    finding.clause = row.clause;
    finding.id = row.id;
    finding.explains = row.explains;
    for (const char *key : row.keys) {
        if (key)
            finding.keys.emplace_back(key);
    }
    if (judgement.sentence) {
        finding.message = std::move(*judgement.sentence);
    } else if (judgement.state == State::unmet && !row.sentence.empty()) {
        finding.message = {row.sentence};
    } else {
        finding.name = judgement.name.empty() ? row.name : judgement.name;
        finding.results = std::move(judgement.results);
        finding.missing = true;
        finding.message = {missingText(row.source, judgement.state), {finding.name, std::string()}};
    }
    return finding;
}

/// Judges a test by the rows, in their order.
template <class Case>
void judge(std::span<const RequirementOf<Case>> rows, const Case &test, std::vector<Finding> &findings) {
    for (const RequirementOf<Case> &row : rows) {
        if (row.applies && !row.applies(test))
            continue;
        Judgement judgement = row.judge(test);
        if (judgement.state)
            findings.push_back(findingOf(row, std::move(judgement)));
    }
}

/// The same rows where the text of the edition was not read: practice, without clauses.
template <class Case>
[[nodiscard]] std::vector<RequirementOf<Case>>
asPractice(std::span<const RequirementOf<Case>> rows, std::initializer_list<std::string_view> without = {}) {
    std::vector<RequirementOf<Case>> result;
    for (RequirementOf<Case> row : rows) {
        if (std::find(without.begin(), without.end(), row.id) != without.end())
            continue;
        if (row.source == Source::text)
            row.source = Source::practice;
        row.clause = "";
        result.push_back(row);
    }
    return result;
}

// ---- Words for tables ------------------------------------------------------------------------------------

/// Turns a question whose answer is the sentence of what is wrong into a judgement.
template <auto wrong, class Case>
Judgement unless(const Case &test) {
    return Judgement::of(std::optional<Message>(wrong(test)));
}

/// A bit for each statement that is missing, the first the lowest.
template <class... Statements>
[[nodiscard]] constexpr unsigned missingOf(const Statements &...stated) {
    unsigned bits = 0;
    unsigned bit = 1;
    ((bits |= stated ? 0 : bit, bit <<= 1), ...);
    return bits;
}

/// Turns a question into a judgement: unmet where the answer is no.
template <auto stated, class Case>
Judgement stating(const Case &test) {
    return stated(test) ? Judgement::met() : Judgement::unmet();
}

} // namespace palmer
