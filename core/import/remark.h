// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tables/contenterror.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace palmer {

enum class RemarkGrade {
    problem,    ///< something in the file could not be used as written
    assumption, ///< a guess to be confirmed
    note,       ///< what was understood or ignored
};

/// A remark on what a file's reader understood, assumed or ignored; shown before the measurement is accepted.
struct Remark {
    RemarkGrade grade = RemarkGrade::note;
    Message message;
    std::size_t line = 0;                  ///< of the file or sheet, from 1; 0: not a line
    std::size_t column = 0;                ///< cell in the line, from 1; 0: the whole line
    std::string choice = {};               ///< key of the choice it is about; may be empty
    std::size_t times = 1;                 ///< number of occurrences, reported once
    std::vector<std::size_t> further = {}; ///< lines of the further occurrences
    std::vector<std::string> answers = {}; ///< of a question: possible answers, if the choice defines none
    bool isOwed = false;                   ///< of a question: what was read is not an answer

    bool operator==(const Remark &) const = default;
};

/// Subject of a remark: the key of a choice and a line, as in Remark.
struct About {
    About() = default;
    About(const char *key, std::size_t at = 0)
        : choice(key)
        , line(at) {}
    About(std::string_view key)
        : choice(key) {}

    std::string choice;
    std::size_t line = 0;
};

/// The remarks of a reader, in the order they were made.
class Remarks : public std::vector<Remark> {
public:
    using std::vector<Remark>::vector;

    Remark &add(RemarkGrade grade, const About &about, Message message) {
        return emplace_back(Remark{grade, std::move(message), about.line, 0, about.choice});
    }
    template <class... Arguments>
    Remark &problem(const About &about, Text text, Arguments... arguments) {
        return add(RemarkGrade::problem, about, messageOf(text, std::move(arguments)...));
    }
    template <class... Arguments>
    Remark &assumption(const About &about, Text text, Arguments... arguments) {
        return add(RemarkGrade::assumption, about, messageOf(text, std::move(arguments)...));
    }
    /// A line of data that was not read.
    void unlike(std::size_t line) {
        problem({"unread", line},
                REPORT_TEXT("report", "This line is not like the others and was not read."));
    }
    template <class... Arguments>
    Remark &note(const About &about, Text text, Arguments... arguments) {
        return add(RemarkGrade::note, about, messageOf(text, std::move(arguments)...));
    }
};

/// Counts lines of text and quotes them.
class QuotedLines {
public:
    void add(std::size_t line, std::string_view text, std::string_view sheet = {});
    /// Adds a note that they were read, if there are any.
    void remarkUsed(Remarks &remarks) const;
    /// Adds a note that they were not used, if there are any.
    void remarkUnused(Remarks &remarks) const;

private:
    std::size_t m_count = 0;
    std::string m_quoted;
};

} // namespace palmer
