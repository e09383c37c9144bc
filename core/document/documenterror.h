// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/words/message.h"

#include <exception>
#include <string>

namespace palmer {

/// The only exception: an external resource cannot be used as it is. Thrown where a file is read or written,
/// caught where it was opened, which adds the file's name. `place`: `tests[0].runs[1].deviations[3]` (counted
/// from 0), `line:column` for syntax, or empty.
/// `message`: what is wrong and what was expected.
class Error : public std::exception {
public:
    enum class Kind { unreadable, syntax, format, newerVersion, content, tooLarge, unwritable };

    Error(Kind errorKind, Message sentence, std::string where = {})
        : kind(errorKind)
        , message(std::move(sentence))
        , place(std::move(where)) {}

    [[nodiscard]] const char *what() const noexcept override { return message.text.source; }

    Kind kind;
    Message message;
    std::string place;
};

} // namespace palmer
