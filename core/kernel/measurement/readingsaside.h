// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/positioning.h"

#include <cstddef>
#include <vector>

namespace palmer {

/// Index of the readings set aside, for repeated look-ups by position. Borrows the measurement, whose list
/// must not change.
class ReadingsAside {
public:
    explicit ReadingsAside(const PositioningMeasurement &measurement);

    /// Returns the excluded reading at zero-based `run` and `target`, or null.
    [[nodiscard]] const ExcludedReading *at(std::size_t run, std::size_t target) const;

private:
    std::vector<const ExcludedReading *> m_inOrder; ///< sorted by run and target
};

} // namespace palmer
