// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/documenterror.h"
#include "document/place.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace palmer {

/// Throws the Error for wrong content at a place in the file.
[[noreturn]] inline void refuseAt(const Place &place, Text text, std::vector<Argument> arguments = {}) {
    throw Error(Error::Kind::content, {text, std::move(arguments), {}}, place.text());
}

/// Returns a count as an argument.
[[nodiscard]] inline Number countOf(std::size_t things) {
    return {static_cast<double>(things), Quantity::count, 0};
}

} // namespace palmer
