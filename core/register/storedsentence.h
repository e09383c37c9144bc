// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/documenterror.h"
#include "language/language.h"

#include <QString>

namespace palmer {

/// Returns why a file could not be read, as stored in the register: the source of the sentence with its
/// arguments, so that it can be translated into any language later.
[[nodiscard]] QString storedSentence(const Error &error);

/// Returns the sentence, preceded by the place in the file. Text in another form is returned unchanged.
[[nodiscard]] QString sentenceFrom(const QString &stored, const Language &language);

} // namespace palmer
