// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace palmer {

/// A text that a user may read, as it stands in the source code (English). What is shown is the translation
/// of it that a Language makes; nothing else reaches a user. Made only by the macros below, which the
/// translation tools know: a bare string is no Text.
/// `comment` tells two equal sources apart whose translations differ (the edition, mostly).
struct Text {
    const char *source = "";
    const char *comment = "";

    [[nodiscard]] constexpr bool empty() const { return *source == 0; }
    friend constexpr bool operator==(const Text &a, const Text &b) {
        return std::string_view(a.source) == b.source && std::string_view(a.comment) == b.comment;
    }
};

} // namespace palmer

/// A text whose words change with the count of its Message, "%n reading(s)": the catalogues, the English one
/// too, have a form for one and one for more.
#define REPORT_TEXT_COUNTED(context, source)                                                                 \
    ::palmer::Text {                                                                                         \
        source, ""                                                                                           \
    }

/// The first argument is always "report", the catalogue all these texts stand in.
#define REPORT_TEXT(context, source)                                                                         \
    ::palmer::Text {                                                                                         \
        source, ""                                                                                           \
    }
#define REPORT_TEXT_FOR(context, source, comment)                                                            \
    ::palmer::Text {                                                                                         \
        source, comment                                                                                      \
    }
