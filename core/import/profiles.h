// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/documenterror.h"
#include "import/choices.h"

#include <QString>

namespace palmer {

/// Named choices for a kind of file, as the user keeps them.
using ImportProfiles = std::map<std::string, ImportOptions>;

/// Where they are kept: import-profiles.json in the user's configuration folder.
[[nodiscard]] QString importProfilesPath();

/// The profiles of the file at that path; none if there is no file. Throws Error for what is no such file,
/// and for choices that are unknown. Files of earlier programs held guesses beside answers: what would be
/// asked is left out of them, and asked again.
[[nodiscard]] ImportProfiles readImportProfiles(const QString &path);

/// Writes them in one step; the folder is made. Throws Error(unwritable).
void saveImportProfiles(const ImportProfiles &profiles, const QString &path);

} // namespace palmer
