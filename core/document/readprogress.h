// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/documenterror.h"

#include <QByteArray>
#include <QString>
#include <atomic>
#include <cstdint>
#include <stop_token>

namespace palmer {

/// Progress of reading a file: written by the reading thread, read by the waiting one.
struct ReadProgress {
    enum class Unit : std::uint8_t {
        bytes, ///< of the file
        trials ///< of the simulations stated in a report, which are repeated
    };

    std::atomic<Unit> unit = Unit::bytes;
    std::atomic<long long> done = 0;
    std::atomic<long long> of = 0; ///< 0: unknown
};

/// Like readBytes of savedocument, counting the bytes. If stopped, returns those read so far.
[[nodiscard]] QByteArray readBytes(const QString &path, ReadProgress &progress,
                                   const std::stop_token &stop = {});

} // namespace palmer
