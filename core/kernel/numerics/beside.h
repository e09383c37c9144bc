// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <future>
#include <system_error>
#include <type_traits>
#include <utility>

namespace palmer {

/// Work that is long enough runs on a thread of its own; other work, and all where the system gives no thread
/// (a limit of memory or of threads), when its result is asked for. Either way the result is the same.
template <class Work>
[[nodiscard]] std::future<std::invoke_result_t<Work>> beside(bool isLong, Work work) {
    if (isLong) {
        try {
            return std::async(std::launch::async, work);
        } catch (const std::system_error &) { // the others go on with what there is
        }
    }
    return std::async(std::launch::deferred, std::move(work));
}

} // namespace palmer
