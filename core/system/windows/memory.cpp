// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/memory.h"

namespace palmer {

void useHugePages(const void *, std::size_t) {}
void keepFreedMemory(std::size_t) {}
void returnMemoryEarly() {}
void returnFreeMemory() {}

} // namespace palmer
