// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Keywords of the CSV format in which readings are written and read back (see readingsCsv).
namespace palmer::palmercsv {

inline constexpr const char *mark = "# ";       ///< before statements: "# unit,mm"
inline constexpr const char *format = "format"; ///< key of the first line
inline constexpr const char *formatWord = "palmer readings";
inline constexpr const char *unit = "unit";           ///< of all lengths, or of all angles of a rotary axis
inline constexpr const char *sign = "sign";           ///< of the deviations of an axis
inline constexpr const char *target = "P";            ///< heading of the target column
inline constexpr const char *deviation = "deviation"; ///< heading of readings: "deviation 2 ↑ (mm)"
inline constexpr const char *temperature =
    "temperature"; ///< heading of those of a drift test: "temperature 1 (°C)"
inline constexpr const char *parameter = "parameter"; ///< first heading of the results

} // namespace palmer::palmercsv
