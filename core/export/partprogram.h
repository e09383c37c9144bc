// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/planning/cycleprogram.h"
#include "language/language.h"

#include <QByteArray>
#include <span>

namespace palmer {

enum class Dialect { iso, siemens, heidenhain, linuxcnc, haas };

/// A dialect as it is chosen: its word on the command line, its name, the usual ending of its files.
struct DialectName {
    Dialect dialect = Dialect::iso;
    const char *word = nullptr;
    const char *name = nullptr;
    const char *ending = nullptr;
};

/// All dialects, in the order they are offered.
[[nodiscard]] std::span<const DialectName> dialects();

/// A program that runs through the measuring cycle once: to the point before the first target, each stop with
/// its dwell, over-travel by the approach distance where the direction turns, so that every target is reached
/// from its own side. Only the axis under test moves; positions are absolute, in the work offset G54
/// (Heidenhain: the active datum), which the program names. The instrument is triggered by the dwell (a rest
/// recognised by the measuring program). Comments in ASCII, in the language given.
/// ISO: DIN 66025 (G0/G1, G4 in seconds with X, of FANUC and its kin), Siemens: SINUMERIK (G4 F), Heidenhain:
/// Klartext (L, CYCL DEF 9.0), LinuxCNC and Haas (G4 P in seconds, at a Haas only with a decimal point).
/// Throws Error(content) for a program that cannot be: no targets, targets that the decimals do not tell
/// apart, no runs, a dwell, feed or approach distance not above 0, a name of the axis that the dialect does
/// not know: an axis with a number has an unmistakable form only at a SINUMERIK ("X1=10").
[[nodiscard]] QByteArray partProgram(const CycleProgram &program, Dialect dialect, const Language &language);

} // namespace palmer
