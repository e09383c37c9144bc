// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/layouts/phrases.h"
#include "kernel/measurement/circular.h"

#include <optional>
#include <string>
#include <string_view>

namespace palmer {

/// The senses of contouring named by words: ccw, cw, G2, G3, horaire, antihoraire.
struct NamedSenses {
    bool clockwise = false;
    bool counterclockwise = false;
};
[[nodiscard]] NamedSenses sensesIn(std::string_view text);
/// The one that is named; null also if both are.
[[nodiscard]] std::optional<Sense> senseIn(std::string_view text);

/// Seconds of the day for "10:25" or "10:25:30,5", also after a date; null for any other text.
[[nodiscard]] std::optional<double> clockTime(std::string_view text);

/// The sign of deviations stated by a text.
struct SaidSign {
    std::string sign;  ///< a word of the choice; empty if none is stated
    std::string words; ///< the words of the text that state it
};

/// Reads "Deviation = actual - target", "Abweichung (Soll − Ist)", or "moins" and "minus" for the dash, in
/// the languages of headings. A dash without blanks counts only in brackets or after an equals sign: a
/// "Soll-Ist-Vergleich" compares both without stating a sign.
[[nodiscard]] SaidSign saidSign(std::string_view text);

/// "Soll-Ist", "Target/Actual" in the heading of readings: words for both sides, joined without saying which
/// is subtracted from which. Empty if there are none.
[[nodiscard]] std::string unclearDifference(std::string_view heading);

} // namespace palmer
