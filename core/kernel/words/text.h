// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string_view>

namespace palmer {

/// A text for the user in source form (English). Only its translation by a Language is shown. Created only by
/// the macros below, which the translation tools know: a bare string is not a Text. `comment` distinguishes
/// two equal sources whose translations differ (mostly by edition).
struct Text {
    const char *source = "";
    const char *comment = "";

    [[nodiscard]] constexpr bool empty() const { return *source == 0; }
    friend constexpr bool operator==(const Text &a, const Text &b) {
        return std::string_view(a.source) == b.source && std::string_view(a.comment) == b.comment;
    }
};

/// Returns what belongs to an enumerator, mostly its text; `all` is in the order of its enumeration.
template <class Enumeration, class Value>
[[nodiscard]] constexpr Value inOrder(Enumeration value, std::initializer_list<Value> all) {
    return all.begin()[static_cast<std::size_t>(value)];
}

} // namespace palmer

/// A text that varies with the count of its Message, "%n reading(s)": every catalogue, English included, has
/// a singular and a plural form.
#define REPORT_TEXT_COUNTED(context, source)                                                                 \
    ::palmer::Text {                                                                                         \
        source, ""                                                                                           \
    }

#define REPORT_TEXT_COUNTED_FOR(context, source, comment)                                                    \
    ::palmer::Text {                                                                                         \
        source, comment                                                                                      \
    }

/// The first argument is always "report", the catalogue of all these texts.
#define REPORT_TEXT(context, source)                                                                         \
    ::palmer::Text {                                                                                         \
        source, ""                                                                                           \
    }
#define REPORT_TEXT_FOR(context, source, comment)                                                            \
    ::palmer::Text {                                                                                         \
        source, comment                                                                                      \
    }
