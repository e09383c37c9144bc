// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

namespace palmer {

/// Where in a file something stands, as a chain up to the root; made text only when an error needs it.
/// Keys are borrowed: they have to live as long as the place.
class Place {
public:
    Place() = default;
    Place(const Place &parent, std::string_view key)
        : m_parent(&parent)
        , m_key(key) {}
    Place(const Place &parent, std::size_t index)
        : m_parent(&parent)
        , m_index(index) {}

    /// `tests[0].runs[1].deviations[3]`, counted from 0; a key that is no identifier as `limits["G(b)"]`.
    /// Empty for the root; the end is cut off beyond sense.
    [[nodiscard]] std::string text() const;

private:
    static constexpr std::size_t noIndex = std::numeric_limits<std::size_t>::max();

    void append(std::string &text) const;

    const Place *m_parent = nullptr;
    std::string_view m_key;
    std::size_t m_index = noIndex;
};

/// What a file says, fit for one line of an error: control characters escaped, the end cut off beyond sense.
[[nodiscard]] std::string excerpt(std::string_view text);

} // namespace palmer
