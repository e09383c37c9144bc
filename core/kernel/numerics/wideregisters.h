// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palmer {

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

} // namespace palmer
