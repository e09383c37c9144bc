// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/axis.h"
#include "kernel/words/message.h"
#include "kernel/words/quantity.h"
#include "kernel/words/text.h"
#include "language/language.h"
#include "language/units.h"

#include <QStringView>
#include <optional>
#include <string>

namespace palmer {

// Text typed into a field, in any usual form. Each value is parsed from the whole text or refused with a
// short reason; nothing is guessed from the locale.

/// `value` in the base unit of its quantity; null for an empty text, or with a refusal.
struct NumberEntry {
    std::optional<double> value;
    std::optional<Text> refusal; ///< "not a number", as part of a sentence
};

/// Parses a number typed in the unit its quantity is shown in (of `units`). The decimal mark is a point or a
/// comma; only spaces separate groups, so "1,234" is 1.234 in every language. "−" is a minus. µm become mm
/// exactly: 5.4 is the double of 0.0054.
[[nodiscard]] NumberEntry enteredNumber(QStringView typed, Quantity quantity, const DisplayUnits &units = {});

/// Two numbers typed with "…", "..", ";", "to" or "à" between them; from < to.
struct IntervalEntry {
    std::optional<Interval> value;
    std::optional<Text> refusal;
};
[[nodiscard]] IntervalEntry enteredInterval(QStringView typed, Quantity quantity,
                                            const DisplayUnits &units = {});

/// As in the file, YYYY-MM-DD or HH:MM; an empty text gives neither value nor refusal.
struct MomentEntry {
    std::optional<std::string> value;
    std::optional<Message> refusal;
};

/// Parses a date: 2026-03-12, 12.03.2026, 12.3.26, "12 mars 2026", "12 March 2026", "today", "aujourd’hui".
/// The day comes first. With slashes or hyphens in English, which is written both ways, a date is refused
/// with both its readings unless only one of them exists. Years of two digits are 1970 to 2069.
[[nodiscard]] MomentEntry enteredDate(QStringView typed, const Language &language);

/// Parses a time of day: 14:02, 14 h 02, 9:05.
[[nodiscard]] MomentEntry enteredTime(QStringView typed);

} // namespace palmer
