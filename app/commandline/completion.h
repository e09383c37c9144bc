// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "language/language.h"

#include <QString>
#include <QStringList>

namespace palmer {

/// Completions of the last word of a command line: one per line, followed by a tab and its meaning. Empty if
/// any text or a file name may follow. For the shells (resources/linux/completions).
[[nodiscard]] QString completion(const QStringList &words, const Language &language);

} // namespace palmer
