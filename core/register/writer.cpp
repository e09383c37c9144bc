// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/writer.h"

#include "kernel/words/shortest.h"
#include "register/machineidentity.h"
#include "register/storedvalues.h"

#include <array>
#include <charconv>

namespace palmer {

namespace {

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
        KnownSource source;
        RowReader(query).read(source.id, source.path, source.size, source.modified, source.sha256,
                              source.program, source.state, source.error);
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
        m_database.insert(QStringLiteral("source (id, path, size, modified, sha256, program, state, error)"),
                          {id, source.path, source.size, source.modified, source.sha256, source.program,
                           source.state, error});
    }
    int position = 0;
    for (const RegisteredTest &test : tests)
        m_database.insert(QStringLiteral("place (source, position, test)"), {id, ++position, testId(test)});
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
    m_database.insert(
        QStringLiteral("machine (id, identity, identified, name, manufacturer, model, serial, location)"),
        storedValues(id, identity.key, identity.isIdentified, test.machineName, test.manufacturer, test.model,
                     test.serialNumber, test.location));
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
    m_database.insert(
        QStringLiteral(
            "test (id, digest, machine, name, manufacturer, model, serial, location, kind, title, word, "
            "edition, axis, angular, date, time, feed, travel, setup, correction, purpose, role, verdict, "
            "rule, accordance, unmet, undeclared, departures, fingerprint, parts, awaits)"),
        storedValues(id, test.digest, machine, test.machineName, test.manufacturer, test.model,
                     test.serialNumber, test.location, test.kind, test.title, test.id, test.edition,
                     test.axis, test.angular, test.date, test.time, test.feed, test.travel, test.setUp,
                     test.correction, test.purpose, test.role, test.verdict, test.rule, test.accordance,
                     test.counts.unmet, test.counts.undeclared, test.counts.departures, test.fingerprint,
                     partsText(test.parts), test.awaitsSimulation));
    insertResults(id, test);
    int position = 0;
    for (const RegisteredInstrument &instrument : test.instruments)
        m_database.insert(
            QStringLiteral("instrument (test, position, description, serial, certificate, due)"),
            storedValues(id, ++position, instrument.description, instrument.serialNumber,
                         instrument.certificate, instrument.due));
    if (!test.curve.empty())
        m_database.insert(QStringLiteral("curve (test, points)"), {id, curveText(test.curve)});
}

void RegisterWriter::insertResults(int id, const RegisteredTest &test) {
    const QString columns =
        QStringLiteral("result (test, position, id, value, expanded, k, bound, limit_value, guard, verdict, "
                       "own, shared, factor, whole, decimals, udecimals)");
    int position = 0;
    for (const RegisteredResult &result : test.results)
        m_database.insert(columns,
                          storedValues(id, ++position, result.id, result.value, result.expandedUncertainty,
                                       result.k, static_cast<int>(result.bound), result.limit,
                                       result.guardBand, result.verdict, result.own,
                                       static_cast<int>(result.shared), result.sharedFactor,
                                       result.withoutParts, result.decimals, result.uncertaintyDecimals));
}

void RegisterWriter::replaceResults(const QString &digest, const RegisteredTest &test) {
    const auto known = m_database.first(QStringLiteral("select id from test where digest = ?"), {digest});
    if (!known)
        return;
    const int id = known->toInt();
    m_database.run(QStringLiteral("delete from result where test = ?"), {id});
    m_database.run(QStringLiteral("update test set verdict = ?, accordance = ?, unmet = ?, undeclared = ?, "
                                  "departures = ?, parts = ?, awaits = 0 where id = ?"),
                   storedValues(test.verdict, test.accordance, test.counts.unmet, test.counts.undeclared,
                                test.counts.departures, partsText(test.parts), id));
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
