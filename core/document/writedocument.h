// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "document/documenterror.h"

#include <QByteArray>

namespace palmer {

/// The bytes of the test file of a document: every key, sorted, numbers in their shortest form that says the
/// same. Reading them gives an equal document; a document read from them is written as the same bytes.
/// Throws Error(unwritable) for a number that is not finite, Error for extensions that are no JSON.
[[nodiscard]] QByteArray writeDocument(const Document &document);

} // namespace palmer
