// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <future>
#include <system_error>
#include <type_traits>
#include <utility>

namespace palmer {

/// Runs long work on its own thread; other work, and all work if the system provides no thread (limit of
/// memory or threads), runs when its result is requested. The result is the same either way.
template <class Work>
[[nodiscard]] std::future<std::invoke_result_t<Work>> runInBackground(bool isLong, Work work) {
    if (isLong) {
        try {
            return std::async(std::launch::async, work);
        } catch (const std::system_error &) { // run deferred instead
        }
    }
    return std::async(std::launch::deferred, std::move(work));
}

} // namespace palmer
