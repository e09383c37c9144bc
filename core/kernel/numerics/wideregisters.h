// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace palmer {

namespace registers {

/// Registers of 16, 32 and 64 bytes.
struct Narrow {
    using Value = double __attribute__((vector_size(16)));
    using Index = std::int64_t __attribute__((vector_size(16)));
};
struct Wide {
    using Value = double __attribute__((vector_size(32)));
    using Index = std::int64_t __attribute__((vector_size(32)));
};
struct Widest {
    using Value = double __attribute__((vector_size(64)));
    using Index = std::int64_t __attribute__((vector_size(64)));
};

} // namespace registers

/// Functions marked so are compiled for 32- or 64-byte registers; call them only if the processor has these.
/// The project is compiled without fused multiply-add: results equal those of the narrow function to the last
/// bit.
#if defined(__x86_64__) && defined(__GNUC__)
#define PALMER_WIDE __attribute__((target("avx2")))
inline bool hasWideRegisters() {
    static const bool has = __builtin_cpu_supports("avx2");
    return has;
}
#else
#define PALMER_WIDE
inline bool hasWideRegisters() {
    return false;
}
#endif

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define PALMER_WIDEST __attribute__((target("avx512f,avx512dq,avx512vl,avx512bw,prefer-vector-width=512")))
inline bool hasWidestRegisters() {
    static const bool has = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                            __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
    return has;
}
#else
#define PALMER_WIDEST PALMER_WIDE
inline bool hasWidestRegisters() {
    return false;
}
#endif

template <class Work>
PALMER_WIDE void inWideRegisters(const Work &work) {
    work(registers::Wide());
}

template <class Work>
PALMER_WIDEST void inWidestRegisters(const Work &work) {
    work(registers::Widest());
}

/// Calls `work(registers)`, compiled for the widest registers of the processor: a lambda that is always
/// inlined, with plain loops that the compiler can vectorise, or with values of these registers.
template <class Work>
void inAvailableRegisters(const Work &work) {
    if (hasWidestRegisters())
        inWidestRegisters(work);
    else if (hasWideRegisters())
        inWideRegisters(work);
    else
        work(registers::Narrow());
}

} // namespace palmer
