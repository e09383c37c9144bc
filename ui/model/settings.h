// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palmer::ui {

/// Makes QSettings store the user's settings as JSON, written completely or not at all: its own format
/// silently loses everything if the disk is full. Imports settings in the former format. Call once, after
/// setting the names of organisation and application and before using QSettings.
void useSafeSettings();

/// True if unsaved changes are copied in case of a crash; default true.
[[nodiscard]] bool keepsCopies();
void setKeepsCopies(bool keeps);

/// True if saving keeps the former version as a backup file; default false.
[[nodiscard]] bool keepsBackups();
void setKeepsBackups(bool keeps);

} // namespace palmer::ui
