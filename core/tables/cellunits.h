// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tables/numbercell.h"
#include "tables/units.h"

#include <cstddef>
#include <optional>
#include <string_view>

namespace palmer {

/// A number with its unit in one cell.
struct CellWithUnit {
    double value = 0;
    const Unit *unit = nullptr;
    std::size_t size = 0; ///< of the number, bytes; 0: degrees, minutes and seconds
};

/// Reads "1.234 mm", "-2,1µm", "0.5″", "12°30′15.5″", "12°30'"; null for any other text. Minutes and seconds
/// of degrees are below 60 and unsigned.
[[nodiscard]] std::optional<CellWithUnit> cellWithUnit(std::string_view cell, DecimalMark mark);

/// The number of such a cell in another unit: decimals are moved in the text, angles divided once. Null if
/// that is not exact.
[[nodiscard]] std::optional<double> numberIn(const Unit &wanted, std::string_view cell, DecimalMark mark);

/// True if `text` is a unit sign that may follow a number after a blank: "mm", "µm", "°".
[[nodiscard]] bool isUnitSign(std::string_view text);

} // namespace palmer
