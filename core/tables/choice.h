// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palmer {

/// How a choice of an importer came about.
enum class Origin {
    recognised, ///< the file says so, or nothing hangs on it
    guessed,    ///< assumed: to be shown as a guess and confirmed
    chosen,     ///< by the user
};

template <class T>
struct Choice {
    T value{};
    Origin origin = Origin::recognised;

    bool operator==(const Choice &) const = default;
};

} // namespace palmer
