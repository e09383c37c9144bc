#pragma once

#include "kernel/planning/cycleprogram.h"
#include "language/language.h"

#include <QByteArray>

namespace palmer {

enum class Dialect { iso, siemens, heidenhain };

/// A program that runs through the measuring cycle once: to the point before the first target, each stop with
/// its dwell, over-travel by the approach distance where the direction turns, so that every target is reached
/// from its own side. Only the axis under test moves; positions are absolute. The instrument is triggered by
/// the dwell (a rest recognised by the measuring program). Comments in ASCII, in the language given.
/// ISO: DIN 66025 (G0/G1, G4 in seconds with X, of FANUC and its kin), Siemens: SINUMERIK (G4 F), Heidenhain:
/// Klartext (L, CYCL DEF 9.0).
/// Empty for a program that cannot be: no targets, no runs, a dwell or approach distance not above 0, an axis
/// that is no letter with digits.
[[nodiscard]] QByteArray partProgram(const CycleProgram &program, Dialect dialect, const Language &language);

} // namespace palmer
