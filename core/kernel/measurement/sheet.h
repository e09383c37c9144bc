// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace palmer {

/// The tolerance of a row of the acceptance sheet, in its unit. Without `low`, `high` ≥ 0 limits the
/// magnitude; with it, the signed value lies between both. Nothing is permitted without `high`.
struct Permitted {
    std::optional<double> low;
    std::optional<double> high;

    bool operator==(const Permitted &) const = default;
};

/// The parameter of a test of the file that a row takes its value, U, limit and unit from.
struct SheetSource {
    std::string test;      ///< its id
    std::string parameter; ///< id, as in the results: "A", "G(b)_XY", also without the axes: "G(b)"

    bool operator==(const SheetSource &) const = default;
};

/// A row of the acceptance sheet: something checked on the machine that need not be a test of this file.
/// Numbers are in `unit`, which is only printed; texts are the user's.
struct SheetRow {
    std::string number; ///< "G1"; unique in the sheet unless empty
    std::string object;
    Permitted permitted;
    std::optional<double> measured;
    std::optional<double> uncertainty; ///< U, k = 2
    std::string unit;
    std::string instrument;
    std::string remark;
    std::string standard;
    std::string notApplicable;       ///< the reason; empty: the row applies
    std::optional<SheetSource> from; ///< excludes own numbers and unit

    bool operator==(const SheetRow &) const = default;
};

} // namespace palmer
