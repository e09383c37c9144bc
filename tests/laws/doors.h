// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

namespace palmer::laws {

/// What the law of doors found.
struct DoorCounts {
    int tables = 0;
    int asked = 0;                        ///< want an answer of their own, at every door
    int refused = 0;                      ///< cannot be read, at any door
    int equal = 0;                        ///< comparisons of two doors with the same outcome
    std::map<std::string, int> differing; ///< by door
};

/// *doors*: the same numbers under the same headings give the same readings, or the same question, whether
/// they come as a text file, a workbook, a copied text, HTML or RTF, or are pasted into the table that is
/// open (readings, drift, arcs, targets); limits against --set. `tables` of each kind from that seed on; a
/// difference is reported with its door.
DoorCounts followDoors(int tables, std::uint64_t seed,
                       const std::function<void(const std::string &door, const std::string &what)> &report);

} // namespace palmer::laws
