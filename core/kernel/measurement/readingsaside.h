// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/positioning.h"

#include <cstddef>
#include <vector>

namespace palmer {

/// The readings of a measurement that are set aside, by their place: for those who ask for many places.
/// Borrows the measurement, whose list must not change.
class ReadingsAside {
public:
    explicit ReadingsAside(const PositioningMeasurement &measurement);

    /// `run` and `target` count from 0. Null where none is set aside.
    [[nodiscard]] const ExcludedReading *at(std::size_t run, std::size_t target) const;

private:
    std::vector<const ExcludedReading *> m_inOrder; ///< of run and target
};

} // namespace palmer
