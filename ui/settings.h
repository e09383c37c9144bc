// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palmer::ui {

/// Makes QSettings keep what the user has chosen as JSON, written whole or not at all: its own format loses
/// everything where the disk is full and says nothing. Takes over what stands in the former format. To be
/// called once, after the names of organisation and application are set and before the first QSettings.
void useSafeSettings();

/// Whether a copy of unsaved changes is kept against a crash; if nothing was chosen, yes.
[[nodiscard]] bool keepsCopies();
void setKeepsCopies(bool keeps);

/// Whether the version before stays beside a file that is saved; if nothing was chosen, no.
[[nodiscard]] bool keepsBackups();
void setKeepsBackups(bool keeps);

} // namespace palmer::ui
