// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

namespace palmer {

/// Position of a value in a file, as a chain up to the root; converted to text only for an error. Keys are
/// borrowed: they must live as long as the place.
class Place {
public:
    Place() = default;
    Place(const Place &parent, std::string_view key)
        : m_parent(&parent)
        , m_key(key) {}
    Place(const Place &parent, std::size_t index)
        : m_parent(&parent)
        , m_index(index) {}

    /// Returns `tests[0].runs[1].deviations[3]`, counted from 0; a key that is not an identifier as
    /// `limits["G(b)"]`. Empty for the root; very long texts are truncated.
    [[nodiscard]] std::string text() const;

private:
    static constexpr std::size_t noIndex = std::numeric_limits<std::size_t>::max();

    void append(std::string &text) const;

    const Place *m_parent = nullptr;
    std::string_view m_key;
    std::size_t m_index = noIndex;
};

/// Returns text from a file for use in an error: control characters escaped, very long texts truncated.
[[nodiscard]] std::string excerpt(std::string_view text);

} // namespace palmer
