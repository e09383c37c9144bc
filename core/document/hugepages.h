// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <sys/mman.h>

namespace palmer {

/// Hint to use large pages for reserved memory that will be filled (long texts and tables): their first use
/// costs less than that of many small ones. Blocks shorter than a large page are unchanged.
inline void inHugePages([[maybe_unused]] const void *reserved, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
    constexpr std::uintptr_t page = std::uintptr_t(2) << 20U;
    // NOLINTBEGIN(cppcoreguidelines-pro-type-reinterpret-cast,performance-no-int-to-ptr): addresses of pages
    const auto begin = reinterpret_cast<std::uintptr_t>(reserved);
    const std::uintptr_t from = (begin + page - 1) / page * page;
    const std::uintptr_t to = (begin + bytes) / page * page;
    if (from < to)
        madvise(reinterpret_cast<void *>(from), to - from, MADV_HUGEPAGE);
        // NOLINTEND(cppcoreguidelines-pro-type-reinterpret-cast,performance-no-int-to-ptr)
#endif
}

} // namespace palmer
