// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/documenterror.h"
#include "language/language.h"

#include <QString>

namespace palmer {

/// Why a file could not be read, as the register keeps it: the source of the sentence with its arguments, so
/// that it can be said in any language later.
[[nodiscard]] QString storedSentence(const Error &error);

/// The sentence, with the place in the file before it. What was not stored so is returned as it stands.
[[nodiscard]] QString sentenceFrom(const QString &stored, const Language &language);

} // namespace palmer
