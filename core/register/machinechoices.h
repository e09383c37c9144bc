// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "language/language.h"
#include "register/queries.h"
#include "register/scan.h"

#include <QByteArray>
#include <QStringList>
#include <map>

namespace palmer {

// Which machines are one, and the intervals of their tests, is said by users in this JSON file of a scanned
// folder, or of the user's data folder where that cannot be written. The register keeps what it read last,
// for folders that are not there.
inline const QString machineFileName = QStringLiteral("palmer-machines.json");

/// The content of such files, by identities.
struct MachineChoices {
    std::map<QString, QString> joined; ///< each to another
    std::map<QString, int> months;     ///< 0: no interval

    /// Adds what a file says; an empty one says nothing. Throws Error.
    void add(const QByteArray &json);
    /// Returns the identity of the machine that a stated one belongs to, directly or through others.
    [[nodiscard]] QString machineOf(const QString &identity) const;
    /// In months, of it or of one joined to it; null: none.
    [[nodiscard]] std::optional<int> interval(const QString &identity) const;
};

inline constexpr int longestInterval = 1200; ///< months

/// Returns the file with another machine (null: none) joined to one, or its interval (0: none; null: stays).
[[nodiscard]] QByteArray withChoice(const QByteArray &json, const MachineFields &machine,
                                    const MachineFields *other, std::optional<int> months);

/// Returns the file without what joins a machine, given by its identity, to that one; the same if nothing
/// does.
[[nodiscard]] QByteArray withoutJoin(const QByteArray &json, const QString &machine, const QString &part);

/// Texts of such files, by folder.
using MachineFiles = std::map<QString, QString>;
[[nodiscard]] MachineFiles keptMachineFiles(Database &database);
void keepMachineFile(Database &database, const QString &folder, const QString &text);
void forgetMachineFile(Database &database, const QString &folder);
[[nodiscard]] MachineChoices keptChoices(Database &database);

/// Returns the files that say something else than the register keeps: of the folders it knows, of these, and
/// of the user's data folder.
[[nodiscard]] MachineFiles changedMachineFiles(Database &database, const QStringList &folders,
                                               std::vector<Unreadable> &unreadable);

/// The same in the files of a machine and in the register. Returns a sentence for each folder that cannot be
/// written. Throws Error.
QStringList chooseMachine(Register &reg, const ListedMachine &machine, const ListedMachine *other,
                          std::optional<int> months, const Language &language);

/// Takes back that one of its joined machines is the same, in all files that say so and in the register.
/// Throws Error, also where such a file cannot be written: they stay joined then.
void separateMachine(Register &reg, const ListedMachine &machine, const MachineFields &part,
                     const Language &language);

} // namespace palmer
