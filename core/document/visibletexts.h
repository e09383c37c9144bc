// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"

#include <QByteArray>
#include <memory>

namespace palmer {

/// The document as a page shows it: each text as visibleText makes it. `file` is what writeDocument makes of
/// it. The same document where there is nothing to show.
[[nodiscard]] std::shared_ptr<const Document> withVisibleTexts(std::shared_ptr<const Document> document,
                                                               const QByteArray &file);

} // namespace palmer
