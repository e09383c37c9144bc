// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/test.h"
#include "kernel/words/message.h"

#include <vector>

namespace palmer {

/// A stated input of the uncertainty.
struct StatedInput {
    Text name;
    Number value;
};

/// Returns every stated budget input of a test, whether its method uses it or not, except coverage factors of
/// 2 and directly entered uncertainties.
[[nodiscard]] std::vector<StatedInput> statedInputs(const Test &test);

} // namespace palmer
