// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/test.h"
#include "kernel/words/message.h"

#include <vector>

namespace palmer {

/// An input of the uncertainty that a test states.
struct StatedInput {
    Text name;
    Number value;
};

/// Every input of a budget that the test states, whatever its method uses; coverage factors of 2 are no
/// statement. The uncertainties entered directly are not among them.
[[nodiscard]] std::vector<StatedInput> statedInputs(const Test &test);

} // namespace palmer
