// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QString>

namespace palmer {

/// Registers the four embedded faces of Liberation Sans with Qt, once per process, and checks that they
/// contain every character of figures and reports (µ ± ↑ ↓ x̄ ° ″ é − …). Requires a QGuiApplication. Throws
/// std::runtime_error if the resource is missing or damaged. Called at start and before drawing.
void loadFonts();

/// The font family of figures and reports, by a name of the program's own that no font of the system has.
[[nodiscard]] QString paperFamily();

/// The name that others give it, for files that name their fonts instead of carrying them.
[[nodiscard]] QString printedFamily();

/// The paper font at a size in pixels of its painter, which are points if the painter is scaled to points.
/// Whole sizes and no hinting: the same text has the same width on every device.
[[nodiscard]] QFont paperFont(int pixelSize, bool bold = false, bool italic = false);

} // namespace palmer
