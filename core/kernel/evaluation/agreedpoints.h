#pragma once

#include "kernel/evaluation/edition.h"
#include "kernel/measurement/test.h"

#include <string_view>
#include <vector>

namespace palmer {

/// What the parties wrote about a point; null: nothing.
[[nodiscard]] const AgreedPoint *agreedPoint(const Test &test, std::string_view point);

/// The parties agreed on the point.
[[nodiscard]] bool isAgreed(const Test &test, std::string_view point);

/// A recommendation for each point of the edition that is not agreed.
void findNotAgreed(const Edition &edition, const Test &test, std::vector<Finding> &findings);

} // namespace palmer
