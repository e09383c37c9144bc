// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace palmer::laws {

/// What the law of choices found.
struct ChoiceCounts {
    int files = 0;
    int refused = 0; ///< cannot be read, so that there is nothing to ask
    int answers = 0; ///< given, one at a time
    int failures = 0;
    std::map<std::string, int> asked;   ///< questions by the key of their choice
    std::map<std::string, int> settled; ///< choices by key

    /// The keys of the import that no file had: as a question if they are ever asked.
    [[nodiscard]] std::vector<std::string> missing() const;
};

/// *choices*: each answer that a question of an import offers is accepted and not asked again; the proposed
/// one gives the same document as none; one that is not offered is refused. `rounds` files of each kind from
/// that seed on; what does not hold is reported with its law.
ChoiceCounts
followChoices(int rounds, std::uint64_t seed,
              const std::function<void(const std::string &law, const std::string &what)> &report);

} // namespace palmer::laws
