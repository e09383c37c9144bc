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

// What survives a crash. While a document has changes that are not saved, a copy of it stands in a folder of
// the user's: one file a window, beside a lock that tells whether the program that wrote it still lives.

/// Where the copy of a document came from.
struct RecoveryOrigin {
    QString path;                       ///< of the user's file; empty: never saved
    QDateTime saved;                    ///< when the copy was written, UTC
    std::optional<FileState> file = {}; ///< of the user's file as the document knew it
};

/// A copy found, and what it holds.
struct Recovery {
    QString file; ///< the copy itself
    RecoveryOrigin origin;
    std::shared_ptr<const Document> document; ///< null: it cannot be read
    QString title;                            ///< of report or machine, to know it by
    std::optional<Error> refusal =
        {}; ///< why it cannot be read; its origin is what its first line says, or the time of the file
};

/// What the user's file was when the document was read from it or saved to it last. Copies of former versions
/// do not say: then a file that is not newer than the copy is taken for it.
[[nodiscard]] FileState knownFile(const RecoveryOrigin &origin);

/// The copy as bytes: a line of JSON about the origin, then the test file.
[[nodiscard]] QByteArray writeRecovery(const Document &document, const RecoveryOrigin &origin);

/// Throws Error for what is no such copy.
[[nodiscard]] Recovery readRecovery(const QByteArray &bytes);

/// The copies in that folder whose programs are gone, the latest first; those that cannot be read, too. What
/// such a program left of a copy it was writing is removed.
[[nodiscard]] std::vector<Recovery> abandonedRecoveries(const QString &folder);

/// Removes a copy and its lock.
void discardRecovery(const QString &file);

/// The lock that belongs to a copy.
[[nodiscard]] QString recoveryLock(const QString &file);

} // namespace palmer
