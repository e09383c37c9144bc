// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/templatefile.h"

#include <QString>
#include <QStringList>
#include <vector>

namespace palmer::ui {

/// A user template and its file.
struct StoredTemplate {
    QString path;
    Template content;
};

// The user's templates: one file each in the folder "templates" of the program's data folder
// (QStandardPaths::AppDataLocation), in the format of templatefile.h.

/// All templates, sorted by name. Files that cannot be read are skipped and listed in `unreadable`.
[[nodiscard]] std::vector<StoredTemplate> storedTemplates(QStringList *unreadable = nullptr);

/// Stores a template, replacing one of the same name and kind. Throws Error(unwritable).
void storeTemplate(const Template &content);

/// Reads a template file from any folder. Throws Error.
[[nodiscard]] Template openTemplate(const QString &path);

void removeTemplate(const StoredTemplate &stored);

} // namespace palmer::ui
