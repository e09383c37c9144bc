// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/planning/cycleprogram.h"
#include "language/language.h"

#include <QByteArray>
#include <span>

namespace palmer {

enum class Dialect { iso, siemens, heidenhain, linuxcnc, haas };

/// A dialect: its word on the command line, its name, the usual ending of its files.
struct DialectName {
    Dialect dialect = Dialect::iso;
    const char *word = nullptr;
    const char *name = nullptr;
    const char *ending = nullptr;
};

/// All dialects, in the order of selection lists.
[[nodiscard]] std::span<const DialectName> dialects();

/// A program that runs through the measuring cycle once: to the point before the first target, each stop with
/// its dwell, over-travel by the approach distance at reversals, so that every target is reached from its own
/// side. Only the axis under test moves; positions are absolute, in the work offset G54 (Heidenhain: the
/// active datum), which the program names. The dwell triggers the instrument (a rest recognised by the
/// measuring program). Comments in ASCII, in the given language.
/// ISO: DIN 66025 (G0/G1, G4 in seconds with X; FANUC and similar), Siemens: SINUMERIK (G4 F), Heidenhain:
/// Klartext (L, CYCL DEF 9.0), LinuxCNC and Haas (G4 P in seconds, for Haas only with a decimal point).
/// Throws like requireProgrammable().
[[nodiscard]] QByteArray partProgram(const CycleProgram &program, Dialect dialect, const Language &language);

/// Throws Error(content) for an impossible program: no targets, targets that the decimals do not distinguish,
/// no runs, a dwell, feed or approach distance not above 0, an axis name unknown to the dialect: only a
/// SINUMERIK has an unambiguous form for an axis with a number ("X1=10").
void requireProgrammable(const CycleProgram &program, Dialect dialect);

} // namespace palmer
