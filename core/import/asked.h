// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace palmer {

/// Whether a wrong guess of that choice would be a wrong number or direction: it is a question then.
[[nodiscard]] bool isAsked(std::string_view choice);

} // namespace palmer
