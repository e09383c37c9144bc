// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace palmer {

/// Rising indices that mostly follow one another, as those of the evaluated points of an arc: kept as
/// stretches without a gap, so that 10⁶ of them take the room of one.
class RisingIndices {
public:
    struct Stretch {
        std::size_t first = 0; ///< index
        std::size_t size = 0;
        std::size_t place = 0; ///< of the first among all

        bool operator==(const Stretch &) const = default;
    };

    /// 0 … size − 1.
    [[nodiscard]] static RisingIndices upTo(std::size_t size);

    /// An index above all there are.
    void add(std::size_t index);

    [[nodiscard]] bool empty() const { return m_stretches.empty(); }
    [[nodiscard]] std::size_t size() const;
    /// Of some.
    [[nodiscard]] std::size_t front() const { return m_stretches.front().first; }
    [[nodiscard]] std::size_t back() const;
    /// place < size(); by bisection of the stretches.
    [[nodiscard]] std::size_t operator[](std::size_t place) const;
    /// The inverse; null of an index that is not there.
    [[nodiscard]] std::optional<std::size_t> placeOf(std::size_t index) const;
    [[nodiscard]] const std::vector<Stretch> &stretches() const { return m_stretches; }

    bool operator==(const RisingIndices &) const = default;

private:
    std::vector<Stretch> m_stretches;
};

} // namespace palmer
