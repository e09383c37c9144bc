// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace palmer {

/// While it exists, libqpdf may unpack at most `most` bytes on this thread; a stream that exceeds this ends
/// with an error of the library. Only FlateDecode with its PNG predictors is unpacked; other filters are left
/// packed. libqpdf itself has no such limit.
class UnpackingBound {
public:
    explicit UnpackingBound(std::int64_t most);
    ~UnpackingBound();
    UnpackingBound(const UnpackingBound &) = delete;
    UnpackingBound &operator=(const UnpackingBound &) = delete;

    /// True if a stream exceeded the limit.
    [[nodiscard]] static bool isExceeded();
};

} // namespace palmer
