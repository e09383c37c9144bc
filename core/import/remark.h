// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/words/message.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace palmer {

enum class RemarkGrade {
    problem,    ///< something in the file could not be used as it stands
    assumption, ///< something was guessed and wants to be confirmed
    note,       ///< what was understood or ignored
};

/// What the reader of a measurement file understood, assumed or ignored; shown before anything is accepted.
struct Remark {
    RemarkGrade grade = RemarkGrade::note;
    Message message;
    std::size_t line = 0;                  ///< of the file or sheet, from 1; 0: the whole
    std::size_t column = 0;                ///< cell of the line, from 1; 0: the whole line
    std::string choice = {};               ///< key of the choice it is about, or empty
    std::size_t times = 1;                 ///< how often it holds; it is said once
    std::vector<std::size_t> further = {}; ///< lines of the further times
    std::vector<std::string> answers = {}; ///< of a question: the words there are, where the choice has none
    bool isOwed = false;                   ///< of a question: what was read is no answer

    bool operator==(const Remark &) const = default;
};

/// `line` and `choice` as above.
inline void addRemark(std::vector<Remark> &remarks, RemarkGrade grade, Message message, std::size_t line = 0,
                      std::string choice = {}) {
    remarks.push_back({grade, std::move(message), line, 0, std::move(choice)});
}

/// Lines of text that nothing is made of: counted, the first of them quoted.
class UnusedLines {
public:
    void add(std::size_t line, std::string_view text);
    /// A note, where there are any.
    void remark(std::vector<Remark> &remarks) const;

private:
    std::size_t m_count = 0;
    std::string m_quoted;
};

} // namespace palmer
