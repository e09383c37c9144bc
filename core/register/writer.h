// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "register/register.h"
#include "register/registeredtest.h"
#include "register/walk.h"

#include <map>
#include <set>
#include <vector>

namespace palmer {

/// What is known of a file. `notFound`: it was there and is no more; `foreign`: a PDF of another program.
enum class SourceState { read, unreadable, foreign, notFound };
[[nodiscard]] QString sourceWord(SourceState state);

struct KnownSource {
    int id = 0;
    QString path;
    qint64 size = 0;
    qint64 modified = 0; ///< −1: written so short before it was read that it may have changed since
    QString sha256;
    QString program; ///< that read it
    QString state;
    QString error; ///< see storedsentence.h; also of a file that was not found and could not be read before
};

/// Writes into a register; every method within a transaction that began with begin(), so that several writers
/// wait for each other and the counted keys are true.
class RegisterWriter {
public:
    explicit RegisterWriter(Database &database);

    /// To be called first in every transaction.
    void begin();
    /// To be called last: removes tests that no file has any more, renews what the machines are called.
    void finish();

    [[nodiscard]] static std::map<QString, KnownSource> sources(Database &database);

    /// The file as it is now, with its tests in place of those it had.
    void put(const KnownSource &source, const std::vector<RegisteredTest> &tests);
    /// The file with the same content at another time, or found again.
    void refresh(const KnownSource &source);
    void setState(const QString &path, SourceState state);
    void remove(const QString &path);
    /// Results of a test that was simulated.
    void replaceResults(const QString &digest, const RegisteredTest &test);

private:
    int sourceId(const QString &path);
    void releasePlaces(int source);
    int machineId(const RegisteredTest &test);
    int testId(const RegisteredTest &test);
    void insertTest(int id, const RegisteredTest &test);
    void insertResults(int id, const RegisteredTest &test);
    void removeTest(int id);
    int next(const QString &table);

    Database &m_database;
    std::map<QString, int> m_next;
    std::set<int> m_loosened; ///< tests that lost a place
    std::set<int> m_touched;  ///< machines
};

} // namespace palmer
