// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QString>

namespace palmer {

/// Makes the four faces of Liberation Sans that the program carries known to Qt, once per process, and checks
/// that every sign of figures and reports is in them (µ ± ↑ ↓ x̄ ° ″ é − …). Needs a QGuiApplication. Throws
/// std::runtime_error when the resource is missing or damaged. Called at start and by who draws.
void loadFonts();

/// The one family of figures and reports.
[[nodiscard]] QString paperFamily();

/// The paper's font at a size in pixels of the painter it is used with; a painter scaled to points makes them
/// points. Whole sizes and no hinting: the same text is equally wide on every device.
[[nodiscard]] QFont paperFont(int pixelSize, bool bold = false, bool italic = false);

} // namespace palmer
