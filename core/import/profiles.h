// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/documenterror.h"
#include "import/choices.h"

#include <QString>

namespace palmer {

/// Named choices of the user for a kind of file.
using ImportProfiles = std::map<std::string, ImportOptions>;

/// Path of the profiles: import-profiles.json in the user's configuration folder.
[[nodiscard]] QString importProfilesPath();

/// Reads the profiles at that path; empty if there is no file. Throws Error for another kind of file and for
/// unknown choices. Earlier programs stored guesses with answers: choices that would be asked are dropped
/// from their files and asked again.
[[nodiscard]] ImportProfiles readImportProfiles(const QString &path);

/// Writes atomically, creating the folder if needed. Throws Error(unwritable).
void saveImportProfiles(const ImportProfiles &profiles, const QString &path);

} // namespace palmer
