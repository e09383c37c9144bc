// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace palmer {

/// While it lives, what libqpdf unpacks on this thread is counted against `most` bytes; a stream that would
/// take more ends there, with an error of the library. Streams are unpacked by FlateDecode alone, with its
/// PNG predictors: what other filters pack stays packed. The library itself knows no bound.
class UnpackingBound {
public:
    explicit UnpackingBound(std::int64_t most);
    ~UnpackingBound();
    UnpackingBound(const UnpackingBound &) = delete;
    UnpackingBound &operator=(const UnpackingBound &) = delete;

    /// Whether something was larger.
    [[nodiscard]] static bool isExceeded();
};

} // namespace palmer
