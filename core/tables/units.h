// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/words/unit.h"

#include <string>
#include <string_view>

namespace palmer {

/// The unit named by a heading or comment: "Dev (µm)", "P [mm]", "unité : µm", "Temp °C"; µ, μ, Âµ and u are
/// equivalent. Single letters count only in brackets. Null if there is none or it is scaled: "tenths of µm".
[[nodiscard]] const Unit *unitIn(std::string_view text);

/// The unit stated by a heading or comment: a known one, or the words of another.
struct SaidUnit {
    const Unit *unit = nullptr;
    std::string foreign = {}; ///< "ppm", "1/10 µm", "µm/m": a unit without conversion

    [[nodiscard]] bool isSaid() const { return unit || !foreign.empty(); }
    [[nodiscard]] std::string words() const { return unit ? unit->sign : foreign; }
    bool operator==(const SaidUnit &) const = default;
};
[[nodiscard]] SaidUnit saidUnit(std::string_view text);

/// The text without a unit in brackets: "Dev (µm)" → "Dev".
[[nodiscard]] std::string withoutUnit(std::string_view text);

} // namespace palmer
