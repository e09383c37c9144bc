// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editing/pastedtable.h"
#include "kernel/measurement/agreement.h"
#include "kernel/words/quantity.h"
#include "language/units.h"

#include <QString>
#include <cstddef>
#include <string>
#include <vector>

namespace palmer {

/// ID of a parameter that may have a limit, and its usual symbol: "A↑", "G(b)".
struct LimitName {
    std::string id;
    QString symbol;

    bool operator==(const LimitName &) const = default;
};

/// The limits with those of a block put in.
struct PastedLimits : Pasted {
    Limits limits;
};

/// Puts limits that a spreadsheet or a contract lists, one a line, among those agreed: a symbol (or id) and
/// its limit, or limits alone, which belong to the `names` from `first` on in their order. Cells are parted
/// by tabs, else by ";" or "|", else by blanks. A number is in the unit that stands with it, else in that of
/// the heading, else in that of `quantity` as it is shown; `answers` may say another than the heading. An
/// edition beside a limit is the one it is agreed for; other texts do not count. Lines above the first limit
/// without a number are headings; a symbol without a limit leaves its limit as it is. Throws Error with the
/// line for what is no limit: then nothing is taken.
[[nodiscard]] PastedLimits pasteLimits(Limits limits, const std::vector<LimitName> &names, std::size_t first,
                                       const QString &block, Quantity quantity,
                                       const DisplayUnits &units = {}, const ImportOptions &answers = {});

} // namespace palmer
