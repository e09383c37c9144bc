#pragma once

#include <string_view>

namespace palmer {

/// Whether a wrong guess of that choice would be a wrong number or direction: it is a question then.
[[nodiscard]] bool isAsked(std::string_view choice);

} // namespace palmer
