// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/qtforward.h"

#include <QString>

namespace palmer::ui {

/// Asks where a PDF document is to be saved, which then ends with ".pdf"; empty if nowhere. `name` is
/// proposed.
[[nodiscard]] QString askForPdf(QWidget *parent, const QString &title, const QString &name);

/// Says in the status bar of the window of a widget, or of the one behind it, where a file was saved.
void saySaved(QWidget *from, const QString &path);

} // namespace palmer::ui
