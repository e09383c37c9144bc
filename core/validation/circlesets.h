// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "validation/validation.h"

#include <QByteArray>
#include <vector>

namespace palmer {

/// Fits circles to the embedded point sets (`reference/circles`) and compares them with their known circles:
/// centre and radius by least squares, and width, with its certificate, of the minimum zone. NIST sets first,
/// then constructed ones. Throws Error if the data cannot be read.
[[nodiscard]] std::vector<SetValidation> validateCircles();

} // namespace palmer
