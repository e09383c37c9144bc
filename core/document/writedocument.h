// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "document/documenterror.h"

#include <QByteArray>

namespace palmer {

/// Returns the bytes of the test file of a document: every key, sorted, numbers in their shortest round-trip
/// form. Reading them gives an equal document; a document read from them is written as the same bytes. Throws
/// Error(unwritable) for a non-finite number, Error for extensions that are not JSON.
[[nodiscard]] QByteArray writeDocument(const Document &document);

} // namespace palmer
