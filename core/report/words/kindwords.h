// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/test.h"
#include "kernel/words/text.h"

namespace palmer {

/// What a report calls the tests of a kind and what belongs to them; %1 are the axis or the axes.
struct KindWords {
    Text name;   ///< as a heading
    Text listed; ///< above the results on the command line
    Text brief;  ///< in a summary; %2 is the radius
    Text model;  ///< what the budget of its uncertainty is made after; empty without one
    Text budget; ///< that budget beside other methods
};

[[nodiscard]] const KindWords &kindWords(const Test &test);

} // namespace palmer
