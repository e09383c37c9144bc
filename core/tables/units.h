// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/words/unit.h"

#include <string>
#include <string_view>

namespace palmer {

/// The unit a heading or comment names: "Dev (µm)", "P [mm]", "unité : µm", "Temp °C"; µ, μ, Âµ and u are
/// one. Single letters count in brackets only. Null if there is none, or one that is scaled: "tenths of µm".
[[nodiscard]] const Unit *unitIn(std::string_view text);

/// What a heading or comment says of a unit: one of those known here, or the words of another.
struct SaidUnit {
    const Unit *unit = nullptr;
    std::string foreign = {}; ///< "ppm", "1/10 µm", "µm/m": a unit, but none that numbers are converted from

    [[nodiscard]] bool isSaid() const { return unit || !foreign.empty(); }
    [[nodiscard]] std::string words() const { return unit ? unit->sign : foreign; }
    bool operator==(const SaidUnit &) const = default;
};
[[nodiscard]] SaidUnit saidUnit(std::string_view text);

/// The text without a unit in brackets: "Dev (µm)" → "Dev".
[[nodiscard]] std::string withoutUnit(std::string_view text);

} // namespace palmer
