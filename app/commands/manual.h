// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "language/language.h"

#include <QString>

namespace palmer {

/// The manual page of palmer-cli, section 1, generated from the same tables as --help.
[[nodiscard]] QString manualPage(const Language &language);

} // namespace palmer
