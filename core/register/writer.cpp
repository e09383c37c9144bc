// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/writer.h"

#include "document/filewords.h"
#include "document/resultwords.h"
#include "kernel/words/shortest.h"
#include "register/machineidentity.h"

#include <array>
#include <charconv>

namespace palmer {

namespace {

QVariant text(const std::string &utf8) {
    return QString::fromStdString(utf8);
}

template <class T>
QVariant orNull(const std::optional<T> &value) {
    if (!value)
        return {};
    if constexpr (std::same_as<T, std::string>)
        return text(*value);
    else
        return *value;
}

QVariant verdictOrNull(std::optional<Verdict> verdict) {
    return verdict ? QVariant(QString::fromLatin1(limitsWord(verdict))) : QVariant();
}

QString partsText(const std::vector<SharedPart> &parts) {
    QStringList lines;
    for (const SharedPart &part : parts) {
        QString source = QString::fromStdString(part.source);
        lines << QString::fromStdString(shortest(part.u)) + u' ' + source.replace(u'\n', u' ');
    }
    return lines.join(u'\n');
}

QString curveText(const std::vector<CurvePoint> &curve) {
    QString result;
    for (const CurvePoint &point : curve)
        result += QString::fromStdString(shortest(point.target)) + u' ' +
                  (point.up ? QString::fromStdString(shortest(*point.up)) : QString()) + u' ' +
                  (point.down ? QString::fromStdString(shortest(*point.down)) : QString()) + u'\n';
    return result;
}

} // namespace

QString sourceWord(SourceState state) {
    constexpr std::array words{"read", "unreadable", "foreign", "notFound"};
    return QString::fromLatin1(words.at(static_cast<std::size_t>(state)));
}

RegisterWriter::RegisterWriter(Database &database)
    : m_database(database) {}

void RegisterWriter::begin() {
    // Every writer updates this row, so that on a server they wait for each other here.
    m_database.run(QStringLiteral("update register set value = value where name = 'writer'"));
    m_next.clear();
    m_loosened.clear();
    m_touched.clear();
}

int RegisterWriter::next(const QString &table) {
    const auto known = m_next.find(table);
    if (known != m_next.end())
        return ++known->second;
    const int last =
        m_database.first(QStringLiteral("select coalesce(max(id), 0) from ") + table).value_or(0).toInt();
    return m_next.emplace(table, last + 1).first->second;
}

std::map<QString, KnownSource> RegisterWriter::sources(Database &database) {
    std::map<QString, KnownSource> result;
    QSqlQuery &query = database.run(
        QStringLiteral("select id, path, size, modified, sha256, program, state, error from source"));
    while (query.next()) {
        KnownSource source{query.value(0).toInt(),      query.value(1).toString(),
                           query.value(2).toLongLong(), query.value(3).toLongLong(),
                           query.value(4).toString(),   query.value(5).toString(),
                           query.value(6).toString(),   query.value(7).toString()};
        const QString path = source.path;
        result.emplace(path, std::move(source));
    }
    return result;
}

int RegisterWriter::sourceId(const QString &path) {
    return m_database.first(QStringLiteral("select id from source where path = ?"), {path})
        .value_or(0)
        .toInt();
}

void RegisterWriter::releasePlaces(int source) {
    QSqlQuery &query = m_database.run(QStringLiteral("select test from place where source = ?"), {source});
    while (query.next())
        m_loosened.insert(query.value(0).toInt());
    m_database.run(QStringLiteral("delete from place where source = ?"), {source});
}

void RegisterWriter::put(const KnownSource &source, const std::vector<RegisteredTest> &tests) {
    int id = sourceId(source.path);
    const QVariant error = source.error.isEmpty() ? QVariant() : QVariant(source.error);
    if (id != 0) {
        releasePlaces(id);
        m_database.run(
            QStringLiteral("update source set size = ?, modified = ?, sha256 = ?, program = ?, "
                           "state = ?, error = ? where id = ?"),
            {source.size, source.modified, source.sha256, source.program, source.state, error, id});
    } else {
        id = next(QStringLiteral("source"));
        m_database.run(QStringLiteral("insert into source (id, path, size, modified, sha256, program, state, "
                                      "error) values (?, ?, ?, ?, ?, ?, ?, ?)"),
                       {id, source.path, source.size, source.modified, source.sha256, source.program,
                        source.state, error});
    }
    int position = 0;
    for (const RegisteredTest &test : tests)
        m_database.run(QStringLiteral("insert into place (source, position, test) values (?, ?, ?)"),
                       {id, ++position, testId(test)});
}

void RegisterWriter::refresh(const KnownSource &source) {
    m_database.run(QStringLiteral("update source set size = ?, modified = ?, state = ? where path = ?"),
                   {source.size, source.modified, source.state, source.path});
}

void RegisterWriter::setState(const QString &path, SourceState state) {
    m_database.run(QStringLiteral("update source set state = ? where path = ?"), {sourceWord(state), path});
}

void RegisterWriter::remove(const QString &path) {
    const int id = sourceId(path);
    if (id == 0)
        return;
    releasePlaces(id);
    m_database.run(QStringLiteral("delete from source where id = ?"), {id});
}

int RegisterWriter::machineId(const RegisteredTest &test) {
    const MachineIdentity identity = machineIdentity(test.manufacturer, test.model, test.serialNumber);
    if (const auto known =
            m_database.first(QStringLiteral("select id from machine where identity = ?"), {identity.key}))
        return known->toInt();
    const int id = next(QStringLiteral("machine"));
    m_database.run(QStringLiteral("insert into machine (id, identity, identified, name, manufacturer, model, "
                                  "serial, location) values (?, ?, ?, ?, ?, ?, ?, ?)"),
                   {id, identity.key, identity.isIdentified ? 1 : 0, text(test.machineName),
                    text(test.manufacturer), text(test.model), text(test.serialNumber), text(test.location)});
    return id;
}

int RegisterWriter::testId(const RegisteredTest &test) {
    if (const auto known =
            m_database.first(QStringLiteral("select id from test where digest = ?"), {test.digest})) {
        m_loosened.erase(known->toInt());
        return known->toInt();
    }
    const int id = next(QStringLiteral("test"));
    insertTest(id, test);
    return id;
}

void RegisterWriter::insertTest(int id, const RegisteredTest &test) {
    const int machine = machineId(test);
    m_touched.insert(machine);
    m_database.run(
        QStringLiteral("insert into test (id, digest, machine, name, manufacturer, model, serial, location, "
                       "kind, title, word, edition, axis, angular, date, time, feed, travel, setup, "
                       "correction, purpose, role, verdict, rule, accordance, unmet, undeclared, departures, "
                       "fingerprint, parts, awaits) values (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
                       "?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
        {id,
         test.digest,
         machine,
         text(test.machineName),
         text(test.manufacturer),
         text(test.model),
         text(test.serialNumber),
         text(test.location),
         QString::fromLatin1(fileWord(test.kind)),
         text(test.title),
         text(test.id),
         text(test.edition),
         text(test.axis),
         test.angular ? 1 : 0,
         orNull(test.date),
         orNull(test.time),
         orNull(test.feed),
         orNull(test.travel),
         text(test.setUp),
         QString::fromLatin1(fileWord(test.correction)),
         QString::fromLatin1(fileWord(test.purpose)),
         QString::fromLatin1(fileWord(test.role)),
         verdictOrNull(test.verdict),
         QString::fromLatin1(fileWord(test.rule)),
         QString::fromLatin1(fileWord(test.accordance)),
         test.counts.unmet,
         test.counts.undeclared,
         test.counts.departures,
         test.fingerprint,
         partsText(test.parts),
         test.awaitsSimulation ? 1 : 0});
    insertResults(id, test);
    int position = 0;
    for (const RegisteredInstrument &instrument : test.instruments)
        m_database.run(QStringLiteral("insert into instrument (test, position, description, serial, "
                                      "certificate, due) values (?, ?, ?, ?, ?, ?)"),
                       {id, ++position, text(instrument.description), text(instrument.serialNumber),
                        text(instrument.certificate), orNull(instrument.due)});
    if (!test.curve.empty())
        m_database.run(QStringLiteral("insert into curve (test, points) values (?, ?)"),
                       {id, curveText(test.curve)});
}

void RegisterWriter::insertResults(int id, const RegisteredTest &test) {
    const QString insert = QStringLiteral(
        "insert into result (test, position, id, value, expanded, k, bound, limit_value, guard, "
        "verdict, own, shared, factor, whole, decimals, udecimals) "
        "values (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    int position = 0;
    for (const RegisteredResult &result : test.results)
        m_database.run(
            insert,
            {id, ++position, text(result.id), orNull(result.value), orNull(result.expandedUncertainty),
             orNull(result.k), static_cast<int>(result.bound), orNull(result.limit), orNull(result.guardBand),
             verdictOrNull(result.verdict), result.own, static_cast<int>(result.shared), result.sharedFactor,
             result.withoutParts ? 1 : 0, orNull(result.decimals), orNull(result.uncertaintyDecimals)});
}

void RegisterWriter::replaceResults(const QString &digest, const RegisteredTest &test) {
    const auto known = m_database.first(QStringLiteral("select id from test where digest = ?"), {digest});
    if (!known)
        return;
    const int id = known->toInt();
    m_database.run(QStringLiteral("delete from result where test = ?"), {id});
    m_database.run(QStringLiteral("update test set verdict = ?, accordance = ?, unmet = ?, undeclared = ?, "
                                  "departures = ?, parts = ?, awaits = 0 where id = ?"),
                   {verdictOrNull(test.verdict), QString::fromLatin1(fileWord(test.accordance)),
                    test.counts.unmet, test.counts.undeclared, test.counts.departures, partsText(test.parts),
                    id});
    insertResults(id, test);
}

void RegisterWriter::removeTest(int id) {
    if (const auto machine = m_database.first(QStringLiteral("select machine from test where id = ?"), {id}))
        m_touched.insert(machine->toInt());
    for (const char *statement :
         {"delete from result where test = ?", "delete from instrument where test = ?",
          "delete from curve where test = ?", "delete from test where id = ?"})
        m_database.run(QString::fromLatin1(statement), {id});
}

void RegisterWriter::finish() {
    for (const int test : m_loosened) {
        const auto places =
            m_database.first(QStringLiteral("select count(*) from place where test = ?"), {test});
        if (places.value_or(0).toInt() == 0)
            removeTest(test);
    }
    for (const int machine : m_touched) {
        // Named as in its newest test.
        QSqlQuery &query = m_database.run(
            QStringLiteral("select name, manufacturer, model, serial, location, date, digest from test where "
                           "machine = ?"),
            {machine});
        QVariantList best;
        std::pair<QString, QString> newest;
        while (query.next()) {
            const std::pair<QString, QString> when{query.value(5).toString(), query.value(6).toString()};
            if (!best.isEmpty() && when <= newest)
                continue;
            newest = when;
            best = {query.value(0), query.value(1), query.value(2), query.value(3), query.value(4), machine};
        }
        if (best.isEmpty())
            m_database.run(QStringLiteral("delete from machine where id = ? and months is null"), {machine});
        else
            m_database.run(QStringLiteral("update machine set name = ?, manufacturer = ?, model = ?, "
                                          "serial = ?, location = ? where id = ?"),
                           best);
    }
}

} // namespace palmer
