// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/documenterror.h"

#include <QString>
#include <QVariant>
#include <QtSql/QSqlDatabase>
#include <QtSql/QSqlError>
#include <QtSql/QSqlQuery>
#include <map>
#include <optional>

namespace palmer {

/// A connection to the database of a register: SQLite or PostgreSQL. Belongs to the creating thread.
class Database {
public:
    enum class Use { read, write };

    /// `address`: path of a file, or postgresql://[user[:password]@][host][:port]/name[?sslmode=…]. To write,
    /// creates the file if there is none; to read, permission to read suffices. Throws Error if it cannot be
    /// opened or is not a register, and leaves it unchanged.
    explicit Database(const QString &address, Use use = Use::write);
    ~Database();
    Database(const Database &) = delete;
    Database &operator=(const Database &) = delete;

    /// Runs a statement; values are bound, never part of it. The query stays prepared: read it to its end, or
    /// finish it, before running the statement again. Throws Error.
    QSqlQuery &run(const QString &statement, const QVariantList &values = {});
    /// Inserts a row; `columns`: "place (source, position, test)".
    void insert(const QString &columns, const QVariantList &values);
    /// Returns the first value of a statement's result; null without a row.
    std::optional<QVariant> first(const QString &statement, const QVariantList &values = {});
    /// Runs a statement without values once: schema, transactions.
    void execute(const QString &statement);
    /// For statements with varying parts.
    [[nodiscard]] QSqlQuery prepare(const QString &statement);
    void run(QSqlQuery &prepared, const QVariantList &values);

    /// One within another belongs to it.
    void begin();
    void commit();
    void rollBack();
    /// All that is read from now on is of one moment.
    void beginReading();

    [[nodiscard]] bool isServer() const { return m_isServer; }
    [[nodiscard]] QStringList tables() const;

private:
    [[noreturn]] void fail(const QSqlError &error) const;

    QString m_name;
    bool m_isServer = false;
    int m_depth = 0; ///< of transactions
    std::map<QString, QSqlQuery> m_prepared;
};

/// True if the address is that of a server.
[[nodiscard]] bool isServerAddress(const QString &address);

/// Throws Error: the first scan makes it.
[[noreturn]] void refuseMissingRegister();

/// Returns the address for display, without the password.
[[nodiscard]] QString withoutPassword(const QString &address);

/// A transaction, rolled back unless committed.
class Transaction {
public:
    explicit Transaction(Database &database)
        : m_database(database) {
        m_database.begin();
    }
    ~Transaction() {
        if (!m_done)
            m_database.rollBack();
    }
    Transaction(const Transaction &) = delete;
    Transaction &operator=(const Transaction &) = delete;
    void commit() {
        m_database.commit();
        m_done = true;
    }

private:
    Database &m_database;
    bool m_done = false;
};

} // namespace palmer
