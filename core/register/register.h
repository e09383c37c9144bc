// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "register/database.h"

#include <QString>
#include <optional>

namespace palmer {

/// An index of folders of test files: machines, tests, results, and their files. Built from the files and can
/// be rebuilt at any time with the same content. Never writes to a listed file. Belongs to the thread that
/// opened it.
class Register {
public:
    enum class Open { read, keep, rebuild };

    /// Opens the register at that address (see Database), creates an empty one, or migrates an older one to
    /// the current schema step by step. A newer schema is refused. `read`: writes nothing, and all that is
    /// read is of one moment; refused if there is none. `rebuild`: empties it first, whatever its schema;
    /// others see it as it was until finish(). Throws Error.
    explicit Register(const QString &address, Open open = Open::keep);

    /// Ends a rebuild: what was written since becomes the register.
    void finish();
    [[nodiscard]] bool isMadeAnew() const { return m_rebuild.has_value(); }

    [[nodiscard]] Database &database() { return m_database; }

    /// Returns the default path of the user's register, in the user's data folder.
    [[nodiscard]] static QString standardPath();

private:
    void makePlace();
    void lockBeginners();
    void makeSchema();
    void keepIntervals();
    void empty();
    void openToRead(const QString &address);
    void migrate(const QString &address) const;
    [[nodiscard]] int schemaVersion();

    /// Removes the file of a register that could not be created.
    class NewFile {
    public:
        explicit NewFile(const QString &address);
        ~NewFile();
        NewFile(const NewFile &) = delete;
        NewFile &operator=(const NewFile &) = delete;
        void keep() { m_path.clear(); }

    private:
        QString m_path; ///< empty: it existed before, is only read, or is on a server
    };

    NewFile m_newFile; ///< destroyed after its users
    Database m_database;
    std::optional<Transaction> m_rebuild;
};

} // namespace palmer
