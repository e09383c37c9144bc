// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/templatefile.h"

#include <QString>
#include <QStringList>
#include <vector>

namespace palmer::ui {

/// A template of the user's own and the file it stands in.
struct StoredTemplate {
    QString path;
    Template content;
};

// The templates of the user: one file each in the folder "templates" below the program's data folder
// (QStandardPaths::AppDataLocation), in the format of templatefile.h.

/// All of them by name. Files that cannot be read are left out and told in `unreadable`.
[[nodiscard]] std::vector<StoredTemplate> storedTemplates(QStringList *unreadable = nullptr);

/// Keeps a template; one of the same name and kind is replaced. Throws Error(unwritable).
void storeTemplate(const Template &content);

/// Reads a template file of anywhere. Throws Error.
[[nodiscard]] Template openTemplate(const QString &path);

void removeTemplate(const StoredTemplate &stored);

} // namespace palmer::ui
