// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace palmer {

/// True if a wrong guess of that choice would give a wrong number or direction, so that it is a question.
[[nodiscard]] bool isAsked(std::string_view choice);

} // namespace palmer
