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

/// How far the reading of a file has come: written by the thread that reads, looked at by the one that waits.
struct ReadProgress {
    enum class Unit : std::uint8_t {
        bytes, ///< of the file
        trials ///< of the simulations that a report states, which are done anew
    };

    std::atomic<Unit> unit = Unit::bytes;
    std::atomic<long long> done = 0;
    std::atomic<long long> of = 0; ///< 0: not known
};

/// As readBytes of savedocument, counting the bytes. When stopped it ends with those read so far.
[[nodiscard]] QByteArray readBytes(const QString &path, ReadProgress &progress,
                                   const std::stop_token &stop = {});

} // namespace palmer
