// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"

#include <QByteArray>
#include <memory>

namespace palmer {

/// Returns the document as a page shows it: each text converted by visibleText. `file` is the output of
/// writeDocument. Returns the same document if there is nothing to convert.
[[nodiscard]] std::shared_ptr<const Document> withVisibleTexts(std::shared_ptr<const Document> document,
                                                               const QByteArray &file);

} // namespace palmer
