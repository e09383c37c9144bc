// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/filenotes.h"
#include "import/imported.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace palmer {

/// The lines of an instrument's file that are no readings and that its reader has no field for. Their
/// statements are read as those around a table, what they say of the numbers is asked for, and the rest is
/// listed.
class OtherLines {
public:
    /// Adds a line that may state something of the test; `ofPositions`: its unit is that of the targets.
    void add(std::size_t line, std::string_view text, bool ofPositions = false);
    /// Adds a line of another part of the file, of an instrument, say.
    void list(std::size_t line, std::string_view text);

    /// The facts that they state, with the remaining lines as unused.
    [[nodiscard]] FileNotes notes() const;
    /// The line that names a direction, if there is one.
    [[nodiscard]] const std::string &direction() const { return m_direction; }
    /// Asks for the kind if a line, or the title, names another quantity; `question` quotes its word.
    void askForKind(std::string_view title, Text question, Remarks &remarks) const;

private:
    struct Line {
        std::size_t number = 0;
        std::string text;
    };
    bool takeUnit(std::size_t line, std::string_view text, bool ofPositions);

    std::vector<Line> m_lines;
    std::vector<Line> m_listed;
    std::string m_direction;
    SaidUnit m_unit;
    SaidUnit m_positionUnit;
    std::vector<Line> m_used;
};

/// The unit of two statements; if they differ, the words of both, which is no unit.
[[nodiscard]] SaidUnit unitOfBoth(const SaidUnit &first, const SaidUnit &second);

/// Settles a unit that the format fixes: another one, stated in the file, contradicts it.
const Unit *resolveFixedUnit(std::string_view choice, const SaidUnit &said, const Unit &fixed,
                             Choices &choices, Remarks &remarks);

/// Settles a unit that the file may state; `usual` where it states none.
const Unit *resolveStatedUnit(std::string_view choice, const SaidUnit &said, const Unit &usual,
                              Choices &choices, Remarks &remarks);

/// Settles the sign that is usual for the format: another one, stated in the file, is to be confirmed.
std::string resolveSaidSign(const SaidSign &said, std::string_view usual, Origin origin, Choices &choices,
                            Remarks &remarks);

/// Asks for one of several measurements in a file, each named with its lines; returns the index of the one to
/// read.
std::size_t resolveMeasurement(const std::vector<std::string> &measurements, Choices &choices,
                               Remarks &remarks);

/// True if the type in the head of a file is that of a displacement or an angle, or is no word.
[[nodiscard]] bool isKnownType(std::string_view type);
/// True if that type is of a rotary axis.
[[nodiscard]] bool isRotaryType(std::string_view type);

} // namespace palmer
