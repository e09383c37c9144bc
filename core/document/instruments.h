// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "kernel/words/quantity.h"

namespace palmer {

/// Returns the quantity of an instrument's resolution: mm, or degrees if the first axis test that names the
/// instrument is of a rotary axis.
[[nodiscard]] Quantity resolutionQuantity(const Document &document, const Instrument &instrument);

} // namespace palmer
