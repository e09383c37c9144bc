// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "document/documenterror.h"
#include "document/filestate.h"

#include <QByteArray>
#include <QDateTime>
#include <QString>
#include <optional>
#include <vector>

namespace palmer {

// Crash recovery. While a document has unsaved changes, a copy is kept in a folder of the user: one file per
// window, with a lock that tells whether the program that wrote it is still running.

/// Origin of the copy of a document.
struct RecoveryOrigin {
    QString path;                       ///< path of the user's file; empty: never saved
    QDateTime saved;                    ///< time the copy was written, UTC
    std::optional<FileState> file = {}; ///< state of the user's file as known to the document
};

/// A copy found, and its content.
struct Recovery {
    QString file; ///< the copy itself
    RecoveryOrigin origin;
    std::shared_ptr<const Document> document; ///< null: unreadable
    QString title;                            ///< of report or machine, to identify it
    std::optional<Error> refusal =
        {}; ///< why it cannot be read; the origin then comes from its first line, or from the file time
};

/// Returns the state of the user's file when the document was last read from it or saved to it. Copies of
/// older versions do not record it: a file not newer than the copy is then assumed to match.
[[nodiscard]] FileState knownFile(const RecoveryOrigin &origin);

/// Returns the copy as bytes: a line of JSON about the origin, then the test file.
[[nodiscard]] QByteArray writeRecovery(const Document &document, const RecoveryOrigin &origin);

/// Throws Error if it is not such a copy.
[[nodiscard]] Recovery readRecovery(const QByteArray &bytes);

/// Returns the copies in that folder whose programs have ended, latest first, including unreadable ones.
/// Removes temporary files left by such programs.
[[nodiscard]] std::vector<Recovery> abandonedRecoveries(const QString &folder);

/// Removes a copy and its lock.
void discardRecovery(const QString &file);

/// Returns the lock file of a copy.
[[nodiscard]] QString recoveryLock(const QString &file);

} // namespace palmer
