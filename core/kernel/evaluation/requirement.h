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

/// State of a requirement. `sentence`: what is wrong if unmet; null: the name of its row says it.
struct Judgement {
    std::optional<State> state = {}; ///< null: met
    std::optional<Message> sentence = {};
    Text name = {};           ///< missing fields of a row with several; empty: all of them
    std::string results = {}; ///< results it is missing for; empty: the test

    [[nodiscard]] static Judgement met() { return {}; }
    [[nodiscard]] static Judgement unmet() { return {State::unmet}; }
    [[nodiscard]] static Judgement unmet(Message message) { return {State::unmet, std::move(message)}; }
    [[nodiscard]] static Judgement undeclared() { return {State::undeclared}; }
    /// For a row with several fields: `missing` has a bit for each missing field, `names` their names indexed
    /// by these bits (empty or absent: the name of the row).
    [[nodiscard]] static Judgement lacking(State state, unsigned missing, std::span<const Text> names) {
        if (missing == 0)
            return met();
        return {state, {}, missing < names.size() ? names[missing] : Text{}};
    }
    /// For a condition that is declared or not.
    [[nodiscard]] static Judgement of(std::optional<bool> condition) {
        return !condition ? undeclared() : *condition ? met() : unmet();
    }
    /// Met unless there is a sentence saying what is wrong.
    [[nodiscard]] static Judgement of(std::optional<Message> wrong) {
        return wrong ? unmet(std::move(*wrong)) : met();
    }
};

/// One requirement of an edition; `Case` is a test with its results and surroundings.
template <class Case>
struct RequirementOf {
    const char *id = nullptr;
    Source source = Source::text;
    const char *clause = nullptr;        ///< of the text; otherwise empty
    Grade modality = Grade::requirement; ///< shall, should, or worth knowing, as in the clause
    Subject subject = Subject::readings;
    bool (*applies)(const Case &) = nullptr; ///< null: always
    Judgement (*judge)(const Case &) = nullptr;
    Text name = {};     ///< what is required: "Not declared: …", "Not stated in the report: …"
    Text sentence = {}; ///< if unmet and the judgement has no sentence of its own
    std::array<const char *, 3> keys = {};
    Explains explains = Explains::nothing;
};

/// Returns the sentence of a finding that names what is missing, by source and state.
[[nodiscard]] Text missingText(Source source, std::optional<State> state);

/// Returns the finding of a row that is not met.
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

/// Judges a test by the rows in their order.
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

/// Returns the same rows for an edition whose text was not read: practice, without clauses.
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

/// Returns the sentence that says what is wrong, or null if nothing is.
[[nodiscard]] inline std::optional<Message> sentenceIf(bool wrong, const Text &text) {
    return wrong ? std::optional(Message{text}) : std::nullopt;
}

// ---- Words for tables ------------------------------------------------------------------------------------

/// Converts a check that returns a sentence into a judgement.
template <auto wrong, class Case>
Judgement unless(const Case &test) {
    return Judgement::of(std::optional<Message>(wrong(test)));
}

/// Returns a bit for each missing statement, the lowest for the first.
template <class... Statements>
[[nodiscard]] constexpr unsigned missingOf(const Statements &...stated) {
    unsigned bits = 0;
    unsigned bit = 1;
    ((bits |= stated ? 0 : bit, bit <<= 1), ...);
    return bits;
}

/// Converts a bool check into a judgement: unmet if false.
template <auto stated, class Case>
Judgement stating(const Case &test) {
    return stated(test) ? Judgement::met() : Judgement::unmet();
}

} // namespace palmer
