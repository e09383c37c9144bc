// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"

#include <QString>
#include <QStringList>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

namespace palmer {

class Register;

/// How far a scan is.
struct ScanProgress {
    int done = 0;
    int total = 0; ///< files that have to be looked into
    bool simulating = false;
};

struct ScanOptions {
    int jobs = 0;       ///< files read at a time; 0: one a processor
    bool prune = false; ///< take out files that are not found any more
    std::stop_token stop = {};
    std::function<void(const ScanProgress &)> progress = {};
};

/// A file or folder that cannot be read, and why (see storedsentence.h).
struct Unreadable {
    QString path;
    QString error;
};

/// What a scan found in the folders.
struct ScanResult {
    int files = 0;    ///< test files and reports that are there
    int read = 0;     ///< of them new or changed
    int notFound = 0; ///< listed, but there no more
    int pruned = 0;
    int tests = 0;    ///< in the whole register
    int machines = 0; ///< likewise
    bool stopped = false;
    std::vector<Unreadable> unreadable;
};

/// The document of a test file or of a report; null for a PDF of another program. Throws Error.
[[nodiscard]] std::optional<Document> documentOfFile(const QString &path);

/// Brings the register to what the folders hold: reads what is new or has changed (by size and time, then by
/// SHA-256), evaluates it, and writes it in transactions, so that a scan that is ended goes on where it was.
/// Files that vanished become "not found", unless a folder on their way cannot be read. A file among
/// `folders` is looked at alone. Then it simulates what has Monte Carlo for its method. Throws Error for
/// troubles of the register, never for those of files.
[[nodiscard]] ScanResult scan(Register &reg, const QStringList &folders, const ScanOptions &options = {});

} // namespace palmer
