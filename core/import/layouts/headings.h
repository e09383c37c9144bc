// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/layouts/phrases.h"
#include "kernel/measurement/circular.h"

#include <optional>
#include <string>
#include <string_view>

namespace palmer {

/// The sense of contouring a word or heading names: ccw, cw, G2, G3, horaire, antihoraire.
[[nodiscard]] std::optional<Sense> senseIn(std::string_view text);

/// Seconds of the day of "10:25", "10:25:30,5", also behind a date; nothing for any other text.
[[nodiscard]] std::optional<double> clockTime(std::string_view text);

/// What a text says of the sign of deviations.
struct SaidSign {
    std::string sign;  ///< as of the choice; empty: nothing
    std::string words; ///< of the text that say it
};

/// "Deviation = actual - target", "Abweichung (Soll − Ist)", "moins" or "minus" for the dash, in the
/// languages of headings. A dash without blanks counts in brackets or behind an equals sign only: a
/// "Soll-Ist-Vergleich" compares both and says nothing.
[[nodiscard]] SaidSign saidSign(std::string_view text);

} // namespace palmer
