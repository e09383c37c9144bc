#pragma once

namespace palmer::ui {

/// Makes QSettings keep what the user has chosen as JSON, written whole or not at all: its own format loses
/// everything where the disk is full and says nothing. Takes over what stands in the former format. To be
/// called once, after the names of organisation and application are set and before the first QSettings.
void useSafeSettings();

} // namespace palmer::ui
