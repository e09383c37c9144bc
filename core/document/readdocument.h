// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "document/documenterror.h"

#include <QByteArray>

namespace palmer {

/// Returns the document in the bytes of a test file (JSON in UTF-8, UTF-16 or UTF-32, with or without byte
/// order mark). Throws Error with place and expectation for everything the format does not allow: unknown
/// keys and words, wrong types, arrays of different lengths, references to missing ids, a newer version, more
/// than 10⁷ readings. Missing data required by a standard are not an error here. Older versions are migrated.
[[nodiscard]] Document readDocument(const QByteArray &bytes);

} // namespace palmer
