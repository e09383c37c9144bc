// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"

#include <cstddef>

namespace palmer {

/// Readings that a window may work on without a noticeable delay.
inline constexpr std::size_t fewReadings = 10'000;

/// While one exists, its thread paints windows and must not be kept from it; see requireBackground().
class WindowThread {
public:
    WindowThread();
    ~WindowThread();
    WindowThread(const WindowThread &) = delete;
    WindowThread &operator=(const WindowThread &) = delete;
};

/// Asserts that so many readings are few, or that this thread paints no windows: composing, reading, writing,
/// importing and evaluating more belong on a background thread.
void requireBackground(std::size_t readings);

/// The same for all readings of a document.
void requireBackground(const Document &document);

} // namespace palmer
