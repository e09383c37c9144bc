// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/memory.h"

#include <cstdint>
#include <limits>
#include <malloc.h>
#include <memory>
#include <sys/mman.h>

namespace palmer {

void useHugePages(const void *reserved, std::size_t bytes) {
    constexpr std::uintptr_t page = std::uintptr_t(2) << 20U;
    // NOLINTBEGIN(cppcoreguidelines-pro-type-reinterpret-cast,performance-no-int-to-ptr): addresses of pages
    const auto begin = reinterpret_cast<std::uintptr_t>(reserved);
    const std::uintptr_t from = (begin + page - 1) / page * page;
    const std::uintptr_t to = (begin + bytes) / page * page;
    if (from < to)
        madvise(reinterpret_cast<void *>(from), to - from, MADV_HUGEPAGE);
    // NOLINTEND(cppcoreguidelines-pro-type-reinterpret-cast,performance-no-int-to-ptr)
}

void keepFreedMemory(std::size_t bytes) {
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
    const auto room = std::make_unique_for_overwrite<char[]>(bytes); // NOLINT(*-avoid-c-arrays)
    useHugePages(room.get(), bytes);
}

void returnMemoryEarly() {
    mallopt(M_TRIM_THRESHOLD, 8 << 20);
    // glibc's adaptive value; setting the other threshold would fix it at 128 KiB.
    mallopt(M_MMAP_THRESHOLD, 4 << 20);
}

void returnFreeMemory() {
    malloc_trim(0);
}

} // namespace palmer
