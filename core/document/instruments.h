// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "kernel/words/quantity.h"

namespace palmer {

/// What the resolution of an instrument is a deviation of: mm, or degrees where the first test of an axis
/// that names the instrument is of a rotary one.
[[nodiscard]] Quantity resolutionQuantity(const Document &document, const Instrument &instrument);

} // namespace palmer
