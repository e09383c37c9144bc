// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/words/message.h"

#include <QByteArray>
#include <QStringView>
#include <cstddef>
#include <optional>

namespace palmer {

struct Document;

// Limits for the values in a test file: what a line, a report and a graph can show, so that the cost of
// processing stays bounded. Schema, reader and fields of the window use the same limits.

inline constexpr std::size_t mostOfLine = 4096;     ///< characters of a single-line text
inline constexpr std::size_t mostOfText = 65536;    ///< characters of remarks, agreements, an address
inline constexpr double mostOfReading = 1e6;        ///< magnitude of a reading, mm (rotary: degrees)
inline constexpr double leastTemperature = -273.15; ///< °C
inline constexpr double mostOfExpansion = 100;      ///< magnitude of a coefficient, µm/(m·°C)
inline constexpr double leastOfExpansion = 0.001;   ///< a smaller one other than 0 is one per °C

/// Returns why a number exceeds the bounds of these Demand bits; null if it does not.
[[nodiscard]] std::optional<Message> beyondBounds(double value, unsigned demands);

/// Returns what is expected instead of a value that its statement cannot have by the bits `positive`,
/// `notNegative`, `percentage` and `coefficient`; null if it can.
[[nodiscard]] std::optional<Text> expectedInstead(double value, unsigned demands);

/// Returns the number of characters as in JSON Schema: code points.
[[nodiscard]] std::size_t lengthOf(QStringView text);

/// Throws an Error with the place of a value beyond the bounds; valid documents can be read again.
void requireBounds(const Document &document);

/// Like readDocument, without the bounds: reference data for numerical tests have readings of any size.
[[nodiscard]] Document readUnbounded(const QByteArray &bytes);

} // namespace palmer
