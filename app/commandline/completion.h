// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "language/language.h"

#include <QString>
#include <QStringList>

namespace palmer {

/// What may follow the words of a command line, the last of which is being typed: one a line, a tab and what
/// it means. Nothing where any text or the name of a file may follow. For the shells
/// (resources/linux/completions).
[[nodiscard]] QString completion(const QStringList &words, const Language &language);

} // namespace palmer
