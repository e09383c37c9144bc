// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palmer {

/// Origin of an importer's choice.
enum class Origin {
    recognised, ///< stated in the file, or it does not matter
    guessed,    ///< assumed: shown as a guess to be confirmed
    chosen,     ///< by the user
};

template <class T>
struct Choice {
    T value{};
    Origin origin = Origin::recognised;

    bool operator==(const Choice &) const = default;
};

} // namespace palmer
