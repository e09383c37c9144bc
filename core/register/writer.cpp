// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/writer.h"

#include "kernel/words/shortest.h"
#include "register/register.h"
#include "register/storedvalues.h"

#include <QtSql/QSqlRecord>
#include <array>

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
    m_choices = keptChoices(m_database);
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
        m_database.run(QStringLiteral("update source set size = ?, modified = ?, sha256 = ?, program = ?, "
                                      "state = ?, error = ?, number = ? where id = ?"),
                       storedValues(source.size, source.modified, source.sha256, source.program, source.state,
                                    error, source.number, id));
    } else {
        id = next(QStringLiteral("source"));
        m_database.insert(
            QStringLiteral("source (id, path, size, modified, sha256, program, state, error, number)"),
            storedValues(id, source.path, source.size, source.modified, source.sha256, source.program,
                         source.state, error, source.number));
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

int RegisterWriter::machineId(const MachineFields &machine, const QString &location) {
    const QString identity = m_choices.machineOf(machineIdentity(machine));
    if (const auto known =
            m_database.first(QStringLiteral("select id from machine where identity = ?"), {identity}))
        return known->toInt();
    const int id = next(QStringLiteral("machine"));
    m_database.insert(QStringLiteral("machine (id, identity, identified, name, manufacturer, model, serial, "
                                     "location)"),
                      storedValues(id, identity, isIdentified(identity), machine.name, machine.manufacturer,
                                   machine.model, machine.serialNumber, location));
    return id;
}

void RegisterWriter::takeMachineFiles(const MachineFiles &changed, const QStringList &gone) {
    if (changed.empty() && gone.isEmpty())
        return;
    Transaction transaction(m_database);
    begin();
    MachineFiles before = keptMachineFiles(m_database);
    bool isNew = false;
    for (const auto &[folder, text] : changed) {
        isNew = isNew || text != before[folder];
        keepMachineFile(m_database, folder, text);
    }
    for (const QString &folder : gone) {
        isNew = isNew || !before[folder].isEmpty();
        forgetMachineFile(m_database, folder);
    }
    m_choices = keptChoices(m_database);
    if (isNew)
        assignMachines();
    finish();
    transaction.commit();
}

void RegisterWriter::assignMachines() {
    std::vector<QVariantList> stated; // machine, name, maker, type, serial number, location
    QSqlQuery &query = m_database.run(
        QStringLiteral("select distinct machine, name, manufacturer, model, serial, location from test"));
    while (query.next()) {
        QVariantList &one = stated.emplace_back();
        for (int i = 0; i < query.record().count(); ++i)
            one << query.value(i);
    }
    for (const QVariantList &one : stated) {
        const int before = one[0].toInt();
        const int machine = machineId(
            {one[1].toString(), one[2].toString(), one[3].toString(), one[4].toString()}, one[5].toString());
        m_touched.insert({machine, before});
        if (machine != before)
            m_database.run(QStringLiteral("update test set machine = ? where machine = ? and name = ? and "
                                          "manufacturer = ? and model = ? and serial = ? and location = ?"),
                           QVariantList{machine} + one);
    }
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
    const int machine =
        machineId({QString::fromStdString(test.machineName), QString::fromStdString(test.manufacturer),
                   QString::fromStdString(test.model), QString::fromStdString(test.serialNumber)},
                  QString::fromStdString(test.location));
    m_touched.insert(machine);
    m_database.insert(QStringLiteral("test (") + testColumns + u')',
                      storedValues(id, test.digest, machine, test.machineName, test.manufacturer, test.model,
                                   test.serialNumber, test.location, test.kind, test.title, test.id,
                                   test.edition, test.axis, test.angular, test.date, test.time, test.feed,
                                   test.travel, test.setUp, test.correction, test.purpose, test.role,
                                   test.verdict, test.rule, test.accordance, test.counts.unmet,
                                   test.counts.undeclared, test.counts.departures, test.fingerprint,
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
    int position = 0;
    for (const RegisteredResult &result : test.results)
        m_database.insert(QStringLiteral("result (") + resultColumns + u')',
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
    for (const int machine : m_touched)
        nameMachine(machine);
}

/// As in its newest test, rather not in those of a machine that was joined to it.
void RegisterWriter::nameMachine(int machine) {
    const QString identity =
        m_database.first(QStringLiteral("select identity from machine where id = ?"), {machine})
            .value_or(QString())
            .toString();
    QSqlQuery &query = m_database.run(
        QStringLiteral("select date, digest, name, manufacturer, model, serial, location from test where "
                       "machine = ?"),
        {machine});
    std::tuple<bool, QString, QString> newest;
    QVariantList best;
    while (query.next()) {
        QString date;
        QString digest;
        MachineFields fields;
        QString location;
        RowReader(query).read(date, digest, fields.name, fields.manufacturer, fields.model,
                              fields.serialNumber, location);
        const std::tuple when(machineIdentity(fields) == identity, date, digest);
        if (!best.isEmpty() && when <= newest)
            continue;
        newest = when;
        best = storedValues(fields.name, fields.manufacturer, fields.model, fields.serialNumber, location,
                            m_choices.interval(identity), machine);
    }
    if (best.isEmpty())
        m_database.run(QStringLiteral("delete from machine where id = ?"), {machine});
    else
        m_database.run(QStringLiteral("update machine set name = ?, manufacturer = ?, model = ?, serial = ?, "
                                      "location = ?, months = ? where id = ?"),
                       best);
}

} // namespace palmer
