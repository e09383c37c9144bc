// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/test.h"

#include <QString>

namespace palmer::ui {

/// What the window calls a test: its title, else its axis or plane, else its id.
[[nodiscard]] QString testName(const Test &test);

} // namespace palmer::ui
