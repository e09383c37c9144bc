// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "register/machinechoices.h"
#include "register/registeredtest.h"
#include "register/walk.h"

#include <map>
#include <set>
#include <vector>

namespace palmer {

/// State of a file. `notFound`: it existed and no longer does; `foreign`: a PDF of another program.
enum class SourceState { read, unreadable, foreign, notFound };
[[nodiscard]] QString sourceWord(SourceState state);

struct KnownSource {
    int id = 0;
    QString path;
    qint64 size = 0;
    qint64 modified = 0; ///< −1: written so shortly before reading that it may have changed since
    QString sha256;
    QString program; ///< program that read it
    QString state;
    QString error; ///< see storedsentence.h; kept for a file that is not found and was unreadable before
    QString number = {}; ///< of the report
};

/// Writes to a register; every method requires a transaction started with begin(), so that several writers
/// wait for each other and numbered keys are correct.
class RegisterWriter {
public:
    explicit RegisterWriter(Database &database);

    /// Must be called first in every transaction.
    void begin();
    /// Must be called last: removes tests without files and updates the names of the machines.
    void finish();

    [[nodiscard]] static std::map<QString, KnownSource> sources(Database &database);

    /// Stores the file as it is now, replacing its tests.
    void put(const KnownSource &source, const std::vector<RegisteredTest> &tests);
    /// Updates a file with the same content but another time, or found again.
    void refresh(const KnownSource &source);
    void setState(const QString &path, SourceState state);
    void remove(const QString &path);
    /// A transaction of its own: keeps what users said of machines, and has every test belong to the machine
    /// that follows from it.
    /// `gone`: folders that are no more, of which nothing is kept.
    void takeMachineFiles(const MachineFiles &changed, const QStringList &gone = {});
    /// Replaces the results of a simulated test.
    void replaceResults(const QString &digest, const RegisteredTest &test);

private:
    int sourceId(const QString &path);
    void releasePlaces(int source);
    int machineId(const MachineFields &machine, const QString &location);
    void assignMachines();
    void nameMachine(int machine);
    int testId(const RegisteredTest &test);
    void insertTest(int id, const RegisteredTest &test);
    void insertResults(int id, const RegisteredTest &test);
    void removeTest(int id);
    int next(const QString &table);

    Database &m_database;
    MachineChoices m_choices;
    std::map<QString, int> m_next;
    std::set<int> m_loosened; ///< tests that lost a place
    std::set<int> m_touched;  ///< machines
};

} // namespace palmer
