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

/// Progress of a scan.
struct ScanProgress {
    int done = 0;
    int total = 0; ///< number of files to be read
    bool simulating = false;
};

struct ScanOptions {
    int jobs = 0;       ///< files read in parallel; 0: one per processor
    bool prune = false; ///< remove files that are not found any more
    bool force = false; ///< also where that takes more than half of a folder's tests
    std::stop_token stop = {};
    std::function<void(const ScanProgress &)> progress = {};
    QStringList left = {}; ///< no longer looked at: their files leave the register, except those of `folders`
};

/// A file or folder that cannot be read, and why (see storedsentence.h).
struct Unreadable {
    QString path;
    QString error;
};

/// Result of a scan of the folders.
struct ScanResult {
    int files = 0;    ///< existing test files and reports
    int read = 0;     ///< new or changed ones among them
    int notFound = 0; ///< registered, but no longer existing
    int pruned = 0;
    int tests = 0;    ///< in the whole register
    int machines = 0; ///< likewise
    bool stopped = false;
    std::vector<Unreadable> unreadable;
    QStringList notPruned; ///< folders that would have lost more than half of their tests
};

/// Returns the document of a test file or a report; null for a PDF of another program. Throws Error.
[[nodiscard]] std::optional<Document> documentOfFile(const QString &path);

/// Updates the register from the folders: reads new and changed files (by size and time, then by SHA-256),
/// evaluates them, and writes in transactions, so that an interrupted scan continues where it was. Vanished
/// files become "not found", unless a parent folder is unreadable. A file in `folders` is scanned by itself.
/// Then runs missing simulations of tests with Monte Carlo as their method, and finishes a rebuild. Throws
/// Error for problems of the register, never for those of files.
[[nodiscard]] ScanResult scan(Register &reg, const QStringList &folders, const ScanOptions &options = {});

} // namespace palmer
