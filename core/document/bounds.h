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

// How much of a value a test file holds: what a line, a report and a graph can show, so that no work on it
// grows beyond all measure. Schema, reader and fields of the window keep to the same bounds.

inline constexpr std::size_t mostOfLine = 4096;  ///< characters of a text of one line
inline constexpr std::size_t mostOfText = 65536; ///< characters of remarks, of what is agreed, of an address
inline constexpr double mostOfReading = 1e6;     ///< size of a reading, mm (rotary: degrees)
inline constexpr double leastTemperature = -273.15; ///< °C
inline constexpr double mostOfExpansion = 100;      ///< size of a coefficient, µm/(m·°C)

/// Why a number is beyond what these bits of Demand allow; nothing: it is not.
[[nodiscard]] std::optional<Message> beyondBounds(double value, unsigned demands);

/// Characters as JSON Schema counts them: code points.
[[nodiscard]] std::size_t lengthOf(QStringView text);

/// Throws an Error that names the place of what is beyond them; what passes can be written and read again.
void demandBounds(const Document &document);

/// As readDocument, without them: reference data that try numerics hold readings of any size.
[[nodiscard]] Document readUnbounded(const QByteArray &bytes);

} // namespace palmer
