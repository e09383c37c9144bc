// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/test.h"
#include "kernel/words/text.h"

namespace palmer {

/// Words of a kind of test; %1 is the axis or the axes.
struct KindWords {
    Text name;   ///< as a heading
    Text listed; ///< above its results on the command line
    Text brief;  ///< in a summary; %2 is the radius
    Text model;  ///< model of its uncertainty budget; may be empty
    Text budget; ///< name of that budget among other methods
};

[[nodiscard]] const KindWords &kindWords(const Test &test);

} // namespace palmer
