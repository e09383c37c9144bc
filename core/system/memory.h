// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace palmer {

// Hints to the allocator, which change no result. A system without them ignores them.

/// Reserved memory that will be filled (long texts and tables) is to use large pages: their first use costs
/// less than that of many small ones. Blocks shorter than a large page are unchanged.
void useHugePages(const void *reserved, std::size_t bytes);

/// Memory freed from now on is reused instead of returned to the system, which would clear each page again;
/// the next `bytes` that are allocated use large pages. For programs that end soon.
void keepFreedMemory(std::size_t bytes);

/// Memory freed from now on is returned to the system early: edits copy large tests in many small blocks.
void returnMemoryEarly();

/// Returns what is free now: the temporary memory of an edit of 10⁶ readings.
void returnFreeMemory();

} // namespace palmer
