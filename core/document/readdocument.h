// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "document/documenterror.h"

#include <QByteArray>

namespace palmer {

/// The document that the bytes of a test file say (JSON in UTF-8, UTF-16 or
/// UTF-32, with or without byte order mark).
/// Throws Error with place and expectation for everything the format does not allow: unknown keys and words,
/// wrong types, arrays of different lengths, names of what is absent, a newer version, more than 10⁷
/// readings. What a standard requires and the file lacks is no error here. Older versions are migrated.
[[nodiscard]] Document readDocument(const QByteArray &bytes);

} // namespace palmer
