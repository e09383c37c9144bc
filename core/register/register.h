// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "register/database.h"

#include <QString>
#include <QVariant>
#include <vector>

namespace palmer {

/// An index of folders of test files: machines, tests, results, and their files. Built from the files and can
/// be rebuilt at any time with the same content; only the intervals of machines are its own. Never writes to
/// a listed file. Belongs to the thread that opened it.
class Register {
public:
    enum class Open { keep, rebuild };

    /// Opens the register at that address (see Database), creates an empty one, or migrates an older one to
    /// the current schema step by step. A newer schema is refused. `rebuild`: empties it first, whatever its
    /// schema; the intervals of machines are kept. Throws Error.
    explicit Register(const QString &address, Open open = Open::keep);

    [[nodiscard]] Database &database() { return m_database; }
    [[nodiscard]] const QString &address() const { return m_address; }

    /// Returns the default path of the user's register, in the user's data folder.
    [[nodiscard]] static QString standardPath();

private:
    void makeSchema();
    void rebuild();
    [[nodiscard]] int schemaVersion();
    [[nodiscard]] std::vector<QVariantList> keptIntervals();

    /// Removes the file of a register that could not be created.
    class NewFile {
    public:
        explicit NewFile(const QString &address);
        ~NewFile();
        NewFile(const NewFile &) = delete;
        NewFile &operator=(const NewFile &) = delete;
        void keep() { m_path.clear(); }

    private:
        QString m_path; ///< empty: it existed before, or is on a server
    };

    QString m_address;
    NewFile m_newFile; ///< destroyed after its users
    Database m_database;
};

} // namespace palmer
