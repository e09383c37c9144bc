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

/// A file that was opened or saved, with what the welcome page says of it.
struct RecentFile {
    QString path;
    QString machine;
    QString axes; ///< "X, Y, XY"
    QDate date;   ///< of the latest test; null: not stated
    bool circular = false;
    std::optional<Verdict> verdict;            ///< on the limits, of the report
    std::optional<Accordance> accordance = {}; ///< the worst of the tests it rests on; null: not known

    bool operator==(const RecentFile &) const = default;
};

/// What a document says of itself on the welcome page.
[[nodiscard]] RecentFile describeFile(const QString &path, const EvaluatedDocument &evaluated);

/// The files opened last, the latest first, without those that are gone; kept in the settings of the user.
[[nodiscard]] std::vector<RecentFile> recentFiles();

/// The name of a file, with as many of its folders as tell it from the others.
[[nodiscard]] QString shortName(const RecentFile &file, const std::vector<RecentFile> &others);

/// Empties the list.
void forgetFiles();

/// Puts a file first in the list; twelve are kept.
void rememberFile(const RecentFile &file);

} // namespace palmer::ui
