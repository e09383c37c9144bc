// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "register/database.h"

#include <QString>
#include <QVariant>
#include <vector>

namespace palmer {

/// An index over folders of test files: machines, tests, results, and from which files they came. Made from
/// the files and made anew at any time with the same content; only the intervals of machines are its own.
/// Never writes into a file it lists. Of the thread that opened it.
class Register {
public:
    enum class Open { keep, rebuild };

    /// Opens the register at that address (see Database), makes an empty one, or brings an older one to this
    /// schema step by step. A newer schema is refused. `rebuild`: empties it first, whatever its schema; the
    /// intervals of machines stay. Throws Error.
    explicit Register(const QString &address, Open open = Open::keep);

    [[nodiscard]] Database &database() { return m_database; }
    [[nodiscard]] const QString &address() const { return m_address; }

    /// Where the register of this user stands when none is named: in the folder of his data.
    [[nodiscard]] static QString standardPath();

private:
    void makeSchema();
    void rebuild();
    [[nodiscard]] int schemaVersion();
    [[nodiscard]] std::vector<QVariantList> keptIntervals();

    /// Removes the file of a register that could not be made.
    class NewFile {
    public:
        explicit NewFile(const QString &address);
        ~NewFile();
        NewFile(const NewFile &) = delete;
        NewFile &operator=(const NewFile &) = delete;
        void keep() { m_path.clear(); }

    private:
        QString m_path; ///< empty: it was there before, or is on a server
    };

    QString m_address;
    NewFile m_newFile; ///< lives longer than what has it open
    Database m_database;
};

} // namespace palmer
