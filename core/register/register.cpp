// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/register.h"

#include "register/storedvalues.h"
#include "register/writer.h"

#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>
#include <array>
#include <span>

namespace palmer {

namespace {

/// Step i migrates a register from schema i to schema i + 1. The same statements for SQLite and PostgreSQL;
/// keys are numbered by the writer. Numbers in mm and degrees; words are those of the test file.
constexpr std::array firstStep{
    "create table register (name text primary key, value text not null)",
    "create table machine (id integer primary key, identity text not null unique, identified integer not "
    "null, "
    "name text not null, manufacturer text not null, model text not null, serial text not null, "
    "location text not null, months integer)",
    "create table source (id integer primary key, path text not null unique, size bigint not null, "
    "modified bigint not null, sha256 text not null, program text not null, state text not null, error text)",
    "create table test (id integer primary key, digest text not null unique, "
    "machine integer not null references machine(id), name text not null, manufacturer text not null, "
    "model text not null, serial text not null, location text not null, kind text not null, "
    "title text not null, word text not null, edition text not null, axis text not null, "
    "angular integer not null, date text, time text, feed double precision, travel double precision, "
    "setup text not null, correction text not null, purpose text not null, role text not null, verdict text, "
    "rule text not null, accordance text not null, unmet integer not null, undeclared integer not null, "
    "departures integer not null, fingerprint text not null, parts text not null, awaits integer not null)",
    "create index test_machine on test (machine, axis, date, kind, purpose)",
    "create table place (source integer not null references source(id), position integer not null, "
    "test integer not null references test(id), primary key (source, position))",
    "create index place_test on place (test)",
    "create table result (test integer not null references test(id), position integer not null, "
    "id text not null, value double precision, expanded double precision, k double precision, "
    "bound integer not null, limit_value double precision, guard double precision, verdict text, "
    "own double precision not null, shared integer not null, factor double precision not null, "
    "whole integer not null)",
    "create index result_test on result (test)",
    "create table instrument (test integer not null references test(id), position integer not null, "
    "description text not null, serial text not null, certificate text not null, due text)",
    "create index instrument_test on instrument (test)",
    "create index instrument_due on instrument (description, serial, due)",
    "create table curve (test integer primary key references test(id), points text not null)",
    "insert into register (name, value) values ('writer', '')",
};

/// The printed decimals of a result, which depend on its instruments and its limit.
constexpr std::array secondStep{
    "alter table result add column decimals integer",
    "alter table result add column udecimals integer",
};

/// The number of the report a file is, or belongs to. Identities of machines changed: the intervals are what
/// users said, the rest comes anew from the files.
constexpr std::array thirdStep{
    "alter table source add column number text not null default ''",
};

constexpr std::array<std::span<const char *const>, 3> schemaSteps{firstStep, secondStep, thirdStep};

constexpr int newest = static_cast<int>(schemaSteps.size());

void requireKnown(int version) {
    if (version > newest)
        throw Error(Error::Kind::newerVersion,
                    {REPORT_TEXT("report", "a newer version of Palmer made this register; use that one, or "
                                           "have the register made anew from the files (register scan "
                                           "--rebuild)"),
                     {}});
}

} // namespace

Register::Register(const QString &address, Open open)
    : m_newFile(open == Open::read ? QString() : address)
    , m_database(address, open == Open::read ? Database::Use::read : Database::Use::write) {
    if (m_database.isServer() && open != Open::read)
        makePlace();
    if (m_database.isServer())
        m_database.execute(QStringLiteral("set search_path to palmer_register"));
    if (open == Open::read)
        openToRead(address);
    else if (open == Open::keep)
        makeSchema();
    else
        empty();
    m_newFile.keep();
}

Register::NewFile::NewFile(const QString &address)
    : m_path(isServerAddress(address) || QFileInfo::exists(address) ? QString() : address) {}

Register::NewFile::~NewFile() {
    if (m_path.isEmpty())
        return;
    for (const char *part : {"", "-wal", "-shm", "-journal"})
        QFile::remove(m_path + QLatin1StringView(part));
}

QString Register::standardPath() {
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
           QStringLiteral("/palmer/register.sqlite");
}

int Register::schemaVersion() {
    // Also without the right to read it: who has none is told so, not that there is no register.
    const QString known = m_database.isServer()
                              ? QStringLiteral("select count(*) from pg_catalog.pg_tables where "
                                               "schemaname = 'palmer_register' and tablename = 'register'")
                              : QStringLiteral("select count(*) from sqlite_master where type = 'table' and "
                                               "name = 'register'");
    if (m_database.first(known).value_or(0).toInt() == 0)
        return 0;
    return m_database
        .first(QStringLiteral("select value from %1register where name = 'schema'")
                   .arg(m_database.isServer() ? QStringLiteral("palmer_register.") : QString()))
        .value_or(0)
        .toInt();
}

/// Its own place on a server, separate from other contents. To make it takes a right that to write does not.
void Register::makePlace() {
    const QString known =
        QStringLiteral("select count(*) from pg_catalog.pg_namespace where nspname = 'palmer_register'");
    if (m_database.first(known).value_or(0).toInt() > 0)
        return;
    Transaction transaction(m_database);
    lockBeginners();
    m_database.execute(QStringLiteral("create schema if not exists palmer_register"));
    transaction.commit();
}

/// Two that begin at once: one waits for the other.
void Register::lockBeginners() {
    if (m_database.isServer())
        m_database.execute(QStringLiteral("select pg_advisory_xact_lock(7256637)"));
}

void Register::makeSchema() {
    const int before = schemaVersion();
    if (before == newest)
        return;
    requireKnown(before);
    Transaction transaction(m_database);
    lockBeginners();
    const int first = schemaVersion();
    for (int step = first; step < newest; ++step) {
        for (const char *statement : schemaSteps.at(static_cast<std::size_t>(step)))
            m_database.execute(QString::fromLatin1(statement));
    }
    if (first > 0 && first < 3)
        keepIntervals();
    m_database.execute(QStringLiteral("delete from register where name = 'schema'"));
    m_database.run(QStringLiteral("insert into register (name, value) values ('schema', ?)"),
                   {QString::number(newest)});
    transaction.commit();
}

/// Those of a register made before they stood in files.
void Register::keepIntervals() {
    QByteArray file;
    QSqlQuery &query = m_database.run(QStringLiteral(
        "select name, manufacturer, model, serial, months from machine where months is not null"));
    while (query.next()) {
        MachineFields machine;
        int months = 0;
        RowReader(query).read(machine.name, machine.manufacturer, machine.model, machine.serialNumber,
                              months);
        file = withChoice(file, machine, nullptr, months);
    }
    keepMachineFile(m_database, {}, QString::fromUtf8(file));
}

void Register::openToRead(const QString &address) {
    const int version = schemaVersion();
    if (version == 0)
        refuseMissingRegister();
    requireKnown(version);
    if (version < newest)
        migrate(address);
    m_database.beginReading();
}

/// Through a connection that may write.
void Register::migrate(const QString &address) const {
    try {
        Register(address, Open::keep);
    } catch (const Error &error) {
        if (error.kind != Error::Kind::unwritable && !m_database.isServer())
            throw;
        throw Error(Error::Kind::unwritable,
                    {REPORT_TEXT("report", "an older version of Palmer made this register, and you may not "
                                           "write to it: it can be read again when somebody who may has "
                                           "scanned with this one"),
                     {}});
    }
}

/// In a transaction, of which readers see nothing before its end.
void Register::empty() {
    m_rebuild.emplace(m_database);
    if (schemaVersion() > newest) {
        if (m_database.isServer()) {
            m_database.execute(QStringLiteral("drop schema palmer_register cascade"));
            m_database.execute(QStringLiteral("create schema palmer_register"));
        } else {
            m_database.execute(QStringLiteral("pragma defer_foreign_keys = on"));
            for (const QString &table : m_database.tables())
                m_database.execute(QStringLiteral("drop table \"%1\"")
                                       .arg(QString(table).replace(u'"', QStringLiteral("\"\""))));
        }
    }
    makeSchema();
    RegisterWriter(m_database).begin();
    for (const char *table : {"curve", "instrument", "result", "place", "test", "source", "machine"})
        m_database.execute(QStringLiteral("delete from ") + QString::fromLatin1(table));
}

void Register::finish() {
    if (m_rebuild)
        m_rebuild->commit();
    m_rebuild.reset();
}

} // namespace palmer
