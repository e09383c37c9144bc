// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/test.h"

#include <QString>

namespace palmer::ui {

/// Displayed name of a test: its title, otherwise its axis or plane, otherwise its ID.
[[nodiscard]] QString testName(const Test &test);

} // namespace palmer::ui
