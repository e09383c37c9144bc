// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "system/workers.h"

#include <cstdint>

namespace palmer {

/// Header of an answer of a worker; the bytes that it counts follow.
struct WorkerAnswer {
    static constexpr std::int32_t atWork = -1; ///< in place of a code: the input was started

    std::int32_t input = 0;
    std::int32_t code = atWork;
    std::int64_t printed = 0; ///< bytes on stdout
    std::int64_t errors = 0;  ///< bytes on stderr
    std::int64_t rows = 0;
};

[[nodiscard]] QByteArray bytesOf(const WorkerAnswer &answer);

/// Bytes of a finished input.
[[nodiscard]] QByteArray bytesOf(int input, const FinishedJob &job);

/// Moves the complete answers out of the bytes of a worker. `input`: the one it works on.
void takeAnswers(QByteArray &bytes, std::optional<int> &input, FinishedJobs &ended);

} // namespace palmer
