// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"

#include <QDate>
#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

namespace palmer::ui {

/// A file opened or saved before, with its description on the welcome page.
struct RecentFile {
    QString path;
    QString machine;
    QString axes; ///< "X, Y, XY"
    QDate date;   ///< of the latest test; null if not stated
    bool circular = false;
    std::optional<Verdict> verdict;            ///< on the limits, as in the report
    std::optional<Accordance> accordance = {}; ///< the worst of the tests it is based on; null if unknown

    bool operator==(const RecentFile &) const = default;
};

/// Description of a document for the welcome page.
[[nodiscard]] RecentFile describeFile(const QString &path, const EvaluatedDocument &evaluated);

/// Recently opened files, latest first, without missing ones; stored in the user's settings.
[[nodiscard]] std::vector<RecentFile> recentFiles();

/// File name with as many folders as needed to distinguish it from the others.
[[nodiscard]] QString shortName(const RecentFile &file, const std::vector<RecentFile> &others);

/// Empties the list.
void forgetFiles();

/// Moves a file to the front of the list, which is limited to twelve.
void rememberFile(const RecentFile &file);

} // namespace palmer::ui
