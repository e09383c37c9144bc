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

/// A connection to the database of a register: SQLite in a file, or PostgreSQL. Of the thread that made it.
class Database {
public:
    /// `address`: path of a file, or postgresql://[user[:password]@][host][:port]/name[?sslmode=…]. A file is
    /// made where there is none. Throws Error where it cannot be opened, or is no register: then it is left
    /// as it is.
    explicit Database(const QString &address);
    ~Database();
    Database(const Database &) = delete;
    Database &operator=(const Database &) = delete;

    /// Runs a statement; values are bound, never part of it. The query stays prepared for the next time: it
    /// is to be read to its end, or finished, before the statement is run again. Throws Error.
    QSqlQuery &run(const QString &statement, const QVariantList &values = {});
    /// The first value that a statement gives; nothing where it gives no row.
    std::optional<QVariant> first(const QString &statement, const QVariantList &values = {});
    /// Runs a statement once that takes no values: of the schema, of transactions.
    void execute(const QString &statement);
    /// For statements that are made of varying parts.
    [[nodiscard]] QSqlQuery prepare(const QString &statement);
    void run(QSqlQuery &prepared, const QVariantList &values);

    void begin();
    void commit();
    void rollBack();

    [[nodiscard]] bool isServer() const { return m_isServer; }
    [[nodiscard]] QStringList tables() const;

private:
    [[noreturn]] void fail(const QSqlError &error) const;

    QString m_name;
    bool m_isServer = false;
    std::map<QString, QSqlQuery> m_prepared;
};

/// Whether an address is that of a server.
[[nodiscard]] bool isServerAddress(const QString &address);

/// The address as a user may read it: without the password.
[[nodiscard]] QString withoutPassword(const QString &address);

/// A transaction: undone unless it is committed.
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
