// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/database.h"

#include "system/filename.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSqlError>
#include <QUrl>
#include <QUrlQuery>
#include <algorithm>
#include <array>
#include <atomic>

namespace palmer {

namespace {

constexpr int waitForLock = 4'000; ///< ms, for another process that is writing
constexpr int waitForServer = 10;  ///< s

[[noreturn]] void refuse(Text text, std::vector<Argument> arguments = {},
                         Error::Kind kind = Error::Kind::unreadable) {
    throw Error(kind, {text, std::move(arguments), {}});
}

[[noreturn]] void refuseForeign() {
    refuse(REPORT_TEXT("report", "this file is no register of tests and is left as it is; choose another "
                                 "name for the register"),
           {}, Error::Kind::content);
}

/// The meaning of SQLite's primary error codes.
struct SqliteTrouble {
    std::array<int, 2> codes{};
    Text text;
    Error::Kind kind = Error::Kind::unreadable;
};
enum SqliteRow : std::size_t { locked, notWritable, full, damaged };
// clang-format off
constexpr std::array sqliteTroubles{ // in the order of SqliteRow
    SqliteTrouble{{5, 6}, REPORT_TEXT("report", "the register is locked by another program; try again when it is done")},
    SqliteTrouble{{8, 14}, REPORT_TEXT("report", "the register cannot be written; check the permissions of its folder"), Error::Kind::unwritable},
    SqliteTrouble{{10, 13}, REPORT_TEXT("report", "the register cannot be written, for want of space perhaps; what it held is unchanged: make room and scan again"), Error::Kind::unwritable},
    SqliteTrouble{{11, 26}, REPORT_TEXT("report", "the file of the register is damaged; remove it and scan again, the test files hold everything")}};
// clang-format on

const SqliteTrouble *sqliteTrouble(int code) {
    const auto row = std::ranges::find_if(sqliteTroubles, [code](const SqliteTrouble &one) {
        return one.codes[0] == code || one.codes[1] == code;
    });
    return row == sqliteTroubles.end() ? nullptr : &*row;
}

/// Returns the primary SQLite error code; 0 if the error has none.
int codeOf(const QSqlError &error) {
    constexpr int primary = 0xff;
    return error.nativeErrorCode().toInt() & primary;
}

QString freshName() {
    static std::atomic<int> next = 0;
    return QStringLiteral("palmer register %1").arg(next++);
}

/// Opens the file as it is set up; returns SQLite's code of an error, 0 without. Writes nothing.
/// `isRegister`: a register, or a database without tables, whose creation was interrupted.
int opened(QSqlDatabase &database, bool &isRegister) {
    if (!database.open())
        return codeOf(database.lastError());
    QSqlQuery query(database);
    if (!query.exec(
            QStringLiteral("select count(*), sum(case when name in ('register', 'source', 'test') then "
                           "1 else 0 end) from sqlite_master where type = 'table'")) ||
        !query.next())
        return codeOf(query.lastError());
    isRegister = query.value(0).toInt() == 0 || query.value(1).toInt() == 3;
    return 0;
}

/// Refuses what is certainly no register.
void requireDatabase(const QString &path) {
    constexpr QByteArrayView sqlite("SQLite format 3\0", 16);
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        refuse(REPORT_TEXT("report", "the register cannot be read; check its permissions"));
    const QByteArray head = file.read(sqlite.size());
    if (!head.isEmpty() && head != sqlite) // empty: just created by a program that was terminated
        refuseForeign();
}

void openFile(QSqlDatabase &database, const QString &path, Database::Use use) {
    const bool toRead = use == Database::Use::read;
    const QFileInfo info(path);
    if (!isUtf8FileName(path))
        refuse(
            REPORT_TEXT("report", "a name to save to has to be UTF-8, and this one is not; choose another"));
    if (info.isDir())
        refuse(REPORT_TEXT("report", "this is a folder; expected the file of a register"));
    if (info.exists() && !info.isFile())
        refuseForeign();
    if (info.exists())
        requireDatabase(path);
    else if (toRead)
        refuseMissingRegister();
    else if (!QDir().mkpath(info.absolutePath()))
        refuse(REPORT_TEXT("report", "the folder of the register cannot be made"), {},
               Error::Kind::unwritable);
    QString options = QStringLiteral("QSQLITE_BUSY_TIMEOUT=%1").arg(waitForLock);
    if (toRead)
        options += QStringLiteral(";QSQLITE_OPEN_READONLY");
    database.setDatabaseName(path);
    database.setConnectOptions(options);
    bool isRegister = false;
    int trouble = opened(database, isRegister);
    const auto is = [&trouble](std::size_t row) { return sqliteTrouble(trouble) == &sqliteTroubles[row]; };
    if (toRead && is(notWritable) && QFileInfo(path + QStringLiteral("-wal")).size() == 0) {
        // In a folder that cannot be written SQLite has no place for its locks; nobody is writing.
        database.close();
        database.setDatabaseName(QUrl::fromLocalFile(info.absoluteFilePath()).toString(QUrl::FullyEncoded) +
                                 QStringLiteral("?immutable=1"));
        database.setConnectOptions(options + QStringLiteral(";QSQLITE_OPEN_URI"));
        trouble = opened(database, isRegister);
    }
    if (is(locked))
        refuse(sqliteTroubles[locked].text);
    if (trouble != 0 && !is(damaged))
        refuse(REPORT_TEXT("report", "the register cannot be opened; check the permissions of its folder"),
               {}, Error::Kind::unwritable); // its content is unknown
    if (!isRegister)
        refuseForeign();
}

bool isSslMode(const QString &word) {
    constexpr std::array words{"disable", "allow", "prefer", "require", "verify-ca", "verify-full"};
    return std::ranges::any_of(words, [&](const char *known) { return word == QLatin1StringView(known); });
}

void openServer(QSqlDatabase &database, const QString &address) {
    const QUrl url(address);
    const QString name = url.path().mid(1);
    if (!url.isValid() || name.isEmpty())
        refuse(REPORT_TEXT("report", "the address of a server reads postgresql://user@host:port/name"));
    const QUrlQuery query(url);
    for (const auto &[key, value] : query.queryItems()) {
        if (key == QLatin1StringView("sslmode") ? !isSslMode(value) : key != QLatin1StringView("host"))
            refuse(REPORT_TEXT("report", "the address of a server takes host=FOLDER and sslmode=disable, "
                                         "allow, prefer, require, verify-ca or verify-full after the "
                                         "question mark, and nothing else"));
    }
    const QString sslMode = query.queryItemValue(QStringLiteral("sslmode"));
    const QString socket = query.queryItemValue(QStringLiteral("host"), QUrl::FullyDecoded);
    database.setHostName(socket.isEmpty() ? url.host(QUrl::FullyDecoded) : socket);
    if (url.port() > 0)
        database.setPort(url.port());
    database.setDatabaseName(name);
    database.setUserName(url.userName(QUrl::FullyDecoded));
    database.setPassword(url.password(QUrl::FullyDecoded));
    database.setConnectOptions(QStringLiteral("connect_timeout=%1").arg(waitForServer) +
                               (sslMode.isEmpty() ? QString() : QStringLiteral(";sslmode=") + sslMode));
    if (!database.open())
        refuse(REPORT_TEXT("report", "the server of the register does not answer, or refuses: %1"),
               {database.lastError().databaseText().section(u'\n', 0, 0).trimmed().toStdString()});
}

/// An empty text is not NULL, and PostgreSQL accepts no U+0000 in a text.
QVariant storable(const QVariant &value) {
    if (value.typeId() != QMetaType::QString)
        return value;
    QString text = value.toString();
    if (text.isNull())
        return QStringLiteral("");
    return text.contains(QChar(u'\0')) ? text.replace(QChar(u'\0'), QChar(QChar::ReplacementCharacter))
                                       : text;
}

} // namespace

void refuseMissingRegister() {
    refuse(REPORT_TEXT("report", "there is no register yet; palmer-cli register scan makes it"));
}

bool isServerAddress(const QString &address) {
    return address.startsWith(QLatin1StringView("postgresql://")) ||
           address.startsWith(QLatin1StringView("postgres://"));
}

QString withoutPassword(const QString &address) {
    if (!isServerAddress(address))
        return address;
    constexpr QLatin1StringView password("password");
    QUrl url(address);
    if (url.isValid() && !url.hasFragment() && url.path().size() > 1 && !url.path().contains(u'@')) {
        QUrlQuery query(url);
        if (query.hasQueryItem(password)) {
            query.removeAllQueryItems(password);
            url.setQuery(query);
        }
        return url.toString(QUrl::RemovePassword);
    }
    // A "#" or "/" in the password changes the parsing: remove everything that may be part of it.
    QString rest = address;
    const auto begin = rest.indexOf(QLatin1StringView("//")) + 2;
    const auto colon = rest.indexOf(u':', begin);
    const auto at = rest.lastIndexOf(u'@');
    if (colon >= 0 && colon < at)
        rest.remove(colon, at - colon);
    return rest.section(u'?', 0, 0);
}

Database::Database(const QString &address, Use use)
    : m_name(freshName())
    , m_isServer(isServerAddress(address)) {
    const QString driver = m_isServer ? QStringLiteral("QPSQL") : QStringLiteral("QSQLITE");
    if (!QSqlDatabase::isDriverAvailable(driver))
        refuse(REPORT_TEXT("report", "the driver %1 of Qt for this register is not installed"),
               {driver.toStdString()});
    try {
        {
            QSqlDatabase database = QSqlDatabase::addDatabase(driver, m_name);
            if (m_isServer)
                openServer(database, address);
            else
                openFile(database, address, use);
        }
        if (m_isServer) {
            execute(QStringLiteral("set client_min_messages to warning"));
        } else if (use == Use::write) {
            execute(QStringLiteral("pragma foreign_keys = on"));
            execute(QStringLiteral("pragma journal_mode = wal"));
            execute(QStringLiteral(
                "pragma synchronous = normal")); // an index: data lost in a power cut are scanned again
        }
    } catch (...) {
        QSqlDatabase::removeDatabase(m_name);
        throw;
    }
}

Database::~Database() {
    m_prepared.clear();
    QSqlDatabase::removeDatabase(m_name); // closes it
}

void Database::fail(const QSqlError &error) const {
    const QString code = error.nativeErrorCode();
    if (m_isServer) {
        const bool gone = !QSqlDatabase::database(m_name, false).isOpen() || code.isEmpty() ||
                          code.startsWith(QLatin1StringView("57P")) ||
                          code.startsWith(QLatin1StringView("08"));
        if (gone)
            refuse(REPORT_TEXT("report",
                               "the server of the register is gone; nothing is lost, scan again when "
                               "it is back"));
    } else if (const SqliteTrouble *trouble = sqliteTrouble(codeOf(error))) {
        refuse(trouble->text, {}, trouble->kind);
    }
    refuse(REPORT_TEXT("report", "the database of the register says: %1"),
           {error.databaseText().section(u'\n', 0, 0).trimmed().toStdString()});
}

QSqlQuery Database::prepare(const QString &statement) {
    QSqlQuery query(QSqlDatabase::database(m_name, false));
    query.setForwardOnly(true);
    if (!query.prepare(statement))
        fail(query.lastError());
    return query;
}

void Database::run(QSqlQuery &prepared, const QVariantList &values) {
    for (qsizetype i = 0; i < values.size(); ++i)
        prepared.bindValue(static_cast<int>(i), storable(values[i]));
    if (!prepared.exec())
        fail(prepared.lastError());
}

QSqlQuery &Database::run(const QString &statement, const QVariantList &values) {
    auto known = m_prepared.find(statement);
    if (known == m_prepared.end())
        known = m_prepared.emplace(statement, prepare(statement)).first;
    run(known->second, values);
    return known->second;
}

void Database::insert(const QString &columns, const QVariantList &values) {
    const QString places = QStringList(values.size(), QStringLiteral("?")).join(QStringLiteral(", "));
    run(QStringLiteral("insert into ") + columns + QStringLiteral(" values (") + places + u')', values);
}

std::optional<QVariant> Database::first(const QString &statement, const QVariantList &values) {
    QSqlQuery &query = run(statement, values);
    std::optional<QVariant> result;
    if (query.next())
        result = query.value(0);
    query.finish();
    return result;
}

void Database::execute(const QString &statement) {
    QSqlQuery query(QSqlDatabase::database(m_name, false));
    if (!query.exec(statement))
        fail(query.lastError());
}

void Database::begin() {
    if (m_depth == 0)
        execute(m_isServer ? QStringLiteral("begin") : QStringLiteral("begin immediate"));
    ++m_depth;
}

void Database::beginReading() {
    execute(m_isServer ? QStringLiteral("begin isolation level repeatable read read only")
                       : QStringLiteral("begin"));
}

void Database::commit() {
    if (m_depth == 1)
        execute(QStringLiteral("commit"));
    --m_depth;
}

void Database::rollBack() {
    m_depth = 0;
    for (auto &[statement, query] : m_prepared)
        query.finish(); // active queries would keep it open
    QSqlQuery query(QSqlDatabase::database(m_name, false));
    query.exec(QStringLiteral("rollback")); // fails if nothing was begun, or if the server is gone
}

QStringList Database::tables() const {
    return QSqlDatabase::database(m_name, false).tables(QSql::Tables);
}

} // namespace palmer
