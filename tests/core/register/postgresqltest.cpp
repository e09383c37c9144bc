// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "core/register/postgresqlserver.h"
#include "core/register/registerdata.h"
#include "register/due.h"
#include "register/trendoutput.h"

#include <QTemporaryDir>
#include <QTest>
#include <thread>

using namespace palmer;
using palmer::testdata::fileOf;
using palmer::testdata::listed;
using palmer::testdata::PostgresqlServer;
using palmer::testdata::Sample;
using palmer::testdata::writeFile;

/// The same schema and statements on a server: the same answers, several writers at once.
class PostgresqlTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_server = std::make_unique<PostgresqlServer>();
        if (!m_server->problem().isEmpty())
            QSKIP(qPrintable("no PostgreSQL server to try with: " + m_server->problem()));
        for (int i = 0; i < 60; ++i) {
            Sample sample;
            sample.date = QDate(2016, 1, 1).addDays(60 * i).toString(Qt::ISODate).toStdString();
            sample.level = 7 + 0.1 * (i % 17) + 1.0 / 3;
            sample.serial = "000-0" + std::to_string(i % 4);
            sample.axis = i % 3 ? "X" : "Y";
            sample.remarks = i % 5 ? "" : "quotes ' and \\\\ and \\u0000 Ω";
            writeFile(m_files.filePath(QString("%1/file '%2'.palmer").arg(i % 7).arg(i)), fileOf(sample));
        }
        writeFile(m_files.filePath("broken.palmer"), "{");
    }
    void init() {
        if (!m_server->problem().isEmpty())
            QSKIP(qPrintable("no PostgreSQL server to try with: " + m_server->problem()));
        qputenv("XDG_DATA_HOME", m_dir.filePath("data").toUtf8());
        Register(m_server->address(), Register::Open::rebuild).finish();
    }

    void noTwoMachinesBecomeOne() {
        Register reg(m_server->address());
        QCOMPARE(palmer::testdata::silentlyJoined(reg, m_dir.filePath("pairs"), 50), QStringList());
    }

    /// While it is made anew others see the register before or the one after.
    void aRebuildIsSeenWhole() {
        const QTemporaryDir folder;
        for (int i = 0; i < 24; ++i) {
            Sample sample;
            sample.machine = sample.serial = "M " + std::to_string(i % 5);
            sample.level = 5 + 0.1 * i;
            writeFile(folder.filePath(QString("%1.palmer").arg(i)), fileOf(sample));
        }
        {
            Register reg(m_server->address());
            (void)scan(reg, {folder.path()});
        }
        writeFile(folder.filePath("one more.palmer"), fileOf({}));
        QCOMPARE(palmer::testdata::wrongReads(m_server->address(), folder.path()), QStringList());
    }

    /// A role with USAGE and SELECT reads; it writes nothing.
    void readersNeedReadAccessOnly() {
        QByteArray all;
        {
            Register reg(m_server->address());
            (void)scan(reg, {m_files.path()});
            all = listed(reg.database());
            for (const char *statement : {"drop role if exists reader", "create role reader login"})
                reg.database().execute(QString::fromLatin1(statement));
            try { // not that there is none
                Register(QString(m_server->address()).replace("palmer@", "reader@"), Register::Open::read);
                QFAIL("read without a right");
            } catch (const Error &error) {
                QVERIFY(
                    Language(Language::Id::english).sentence(error.message).contains("permission denied"));
            }
            for (const char *statement : {"grant usage on schema palmer_register to reader",
                                          "grant select on all tables in schema palmer_register to reader"})
                reg.database().execute(QString::fromLatin1(statement));
        }
        const QString address = QString(m_server->address()).replace("palmer@", "reader@");
        {
            Register reader(address, Register::Open::read);
            QCOMPARE(listed(reader.database()), all);
            QVERIFY(!machines(reader.database()).empty());
        }
        writeFile(m_dir.filePath("fresh/a.palmer"), fileOf({}));
        Register writer(address);
        QVERIFY_EXCEPTION_THROWN((void)scan(writer, {m_dir.filePath("fresh")}), Error);
        Register(m_server->address()).database().execute("drop owned by reader");
    }

    void bothDatabasesGiveTheSameAnswers() {
        Register file(m_dir.filePath("register.sqlite"), Register::Open::rebuild);
        file.finish();
        Register server(m_server->address());
        for (Register *reg : {&file, &server}) {
            const ScanResult result = scan(*reg, {m_files.path()});
            QCOMPARE(result.tests, 60);
            QCOMPARE(result.unreadable.size(), std::size_t{1});
            QCOMPARE(scan(*reg, {m_files.path()}).tests, 60);
        }
        QCOMPARE(listed(server.database()), listed(file.database()));
        const auto machinesOf = [](Register &reg) {
            QStringList result;
            for (const ListedMachine &machine : machines(reg.database()))
                result << machine.identity + machine.title();
            return result;
        };
        QCOMPARE(machinesOf(server), machinesOf(file));
        TestFilter filter;
        filter.axis = "x";
        filter.since = "2018-01-01";
        filter.until = "2022-01-01";
        filter.limits = "respected";
        filter.words = "000-01";
        QVERIFY(!listed(file.database(), filter).isEmpty());
        QCOMPARE(listed(server.database(), filter), listed(file.database(), filter));
        filter = {};
        filter.machines = {machines(file.database()).front().id};
        const auto list = tests(file.database(), filter);
        filter.machines = {machines(server.database()).front().id};
        const auto other = tests(server.database(), filter);
        QCOMPARE(trendJson({}, "X", machineTrend(other, "A")), trendJson({}, "X", machineTrend(list, "A")));
        QVERIFY(trendJson({}, "X", machineTrend(list, "A")).contains("slopePerYear"));
    }

    /// To scan takes no right to make something in the database.
    void writersNeedTheTablesOnly() {
        {
            Register reg(m_server->address());
            for (const char *statement : {"drop role if exists writer", "create role writer login",
                                          "grant usage on schema palmer_register to writer",
                                          "grant all on all tables in schema palmer_register to writer"})
                reg.database().execute(QString::fromLatin1(statement));
        }
        const QString address = QString(m_server->address()).replace("palmer@", "writer@");
        for (const auto open : {Register::Open::keep, Register::Open::rebuild}) {
            Register reg(address, open);
            QCOMPARE(scan(reg, {m_files.path()}).tests, 60);
        }
        Register(m_server->address()).database().execute("drop owned by writer");
    }

    void twoWriteAtOnce() {
        Register(m_server->address()).database().execute("drop schema palmer_register cascade");
        std::vector<std::thread> writers;
        std::array<QString, 3> troubles;
        for (QString &trouble : troubles)
            writers.emplace_back([&] {
                try {
                    Register reg(m_server->address());
                    (void)scan(reg, {m_files.path()});
                } catch (const Error &error) {
                    trouble = Language(Language::Id::english).sentence(error.message);
                }
            });
        for (std::thread &writer : writers)
            writer.join();
        for (const QString &trouble : troubles)
            QCOMPARE(trouble, QString());
        Register file(m_dir.filePath("register.sqlite"), Register::Open::rebuild);
        (void)scan(file, {m_files.path()});
        Register server(m_server->address());
        QCOMPARE(listed(server.database()), listed(file.database()));
    }

    /// The server goes while it is written to: one sentence, and the next scan goes on.
    void aServerThatGoesAndComesBack() {
        QString said;
        {
            Register reg(m_server->address());
            try {
                (void)scan(reg, {m_files.path()},
                           {.jobs = 1, .progress = [&](const ScanProgress &) { m_server->stop(); }});
                (void)scan(reg, {m_files.path()});
            } catch (const Error &error) {
                said = Language(Language::Id::english).sentence(error.message);
            }
        }
        QVERIFY2(said.contains("gone"), qPrintable(said));
        try {
            Register reg(m_server->address());
            QFAIL("there is no server");
        } catch (const Error &error) {
            said = Language(Language::Id::english).sentence(error.message);
        }
        QVERIFY2(said.contains("does not answer"), qPrintable(said));
        QVERIFY(m_server->start());
        Register reg(m_server->address());
        QCOMPARE(scan(reg, {m_files.path()}).tests, 60);
    }

    void whatElseTheDatabaseHoldsStays() {
        Register reg(m_server->address());
        reg.database().execute("create table public.letters (id integer)");
        Register(m_server->address(), Register::Open::rebuild).finish();
        Register again(m_server->address());
        QCOMPARE(again.database().first("select count(*) from public.letters").value_or(-1).toInt(), 0);
        again.database().execute("drop table public.letters");
    }

private:
    std::unique_ptr<PostgresqlServer> m_server;
    QTemporaryDir m_dir;
    QTemporaryDir m_files;
};

QTEST_GUILESS_MAIN(PostgresqlTest)
#include "postgresqltest.moc"
