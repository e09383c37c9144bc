// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "core/register/registerdata.h"
#include "register/storedsentence.h"
#include "report/words/accordancetext.h"
#include "report/words/printednumbers.h"

#include <QScopeGuard>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QTemporaryDir>
#include <QTest>
#include <random>
#include <set>
#include <sys/stat.h>
#include <unistd.h>

using namespace palmer;
using palmer::testdata::fileOf;
using palmer::testdata::listed;
using palmer::testdata::Sample;
using palmer::testdata::writeFile;

namespace {

QByteArray contents(const QString &path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("cannot be read");
}

QString sentenceOf(const Error &error) {
    return Language(Language::Id::english).sentence(error.message);
}

/// What opening a register says; empty: nothing is wrong.
QString refusal(const QString &path, Register::Open open = Register::Open::keep) {
    try {
        Register reg(path, open);
        return {};
    } catch (const Error &error) {
        return sentenceOf(error);
    }
}

} // namespace

class RegisterScanTest : public QObject {
    Q_OBJECT

private slots:
    /// Value and U with the digits that window and report print: not finer than the instrument.
    void resultsAreRoundedAsInTheReport() {
        const Language language(Language::Id::english);
        const QDir examples(EXAMPLES);
        QDir().mkpath(m_folder);
        for (const QString &name : examples.entryList({"*.palmer"}))
            QFile::copy(examples.filePath(name), file(name));
        Register reg(m_path);
        (void)scan(reg, {m_folder});
        int compared = 0;
        int differing = 0; // from digits that know nothing of the instrument
        for (const ListedTest &listed : tests(reg.database(), {})) {
            const auto document =
                std::make_shared<const Document>(*documentOfFile(listed.places.front().path));
            const EvaluatedDocument evaluated = evaluate(document);
            const auto index = static_cast<std::size_t>(listed.places.front().test) - 1;
            const Test &test = *document->tests[index];
            for (const Parameter &parameter : evaluated.tests[index]->parameters) {
                const auto found =
                    std::ranges::find(listed.test.results, parameterId(parameter), &RegisteredResult::id);
                QVERIFY(found != listed.test.results.end());
                if (!parameter.value || listed.test.awaitsSimulation)
                    continue;
                const PrintedNumbers printed = printedNumbers(parameter, test, *document, language);
                const ShownValue shown = shownResult(*found, listed.test.angular, language);
                QCOMPARE(shown.value, printed.value);
                QCOMPARE(shown.uncertainty, printed.uncertainty);
                RegisteredResult unaware = *found;
                unaware.decimals.reset();
                differing += shownResult(unaware, listed.test.angular, language).value != shown.value;
                ++compared;
            }
        }
        QVERIFY(compared > 20);
        QVERIFY(differing > 0);
    }

    /// A register made before digits were kept shows what it has, and is read again.
    void anOlderRegisterLearnsTheDigits() {
        writeFile(file("a.palmer"), fileOf({}));
        {
            Register reg(m_path);
            (void)scan(reg, {m_folder});
            for (const char *statement :
                 {"update machine set months = 18", "alter table source drop column number",
                  "alter table result drop column decimals", "alter table result drop column udecimals",
                  "update register set value = '1' where name = 'schema'",
                  "update source set program = 'Palmer before'", "update test set digest = 'before'"})
                reg.database().execute(QString::fromLatin1(statement));
        }
        Register reg(m_path);
        const auto list = tests(reg.database(), {});
        QCOMPARE(list.size(), std::size_t(1));
        QVERIFY(list.front().test.results.front().value);
        QVERIFY(!list.front().test.results.front().decimals);
        (void)scan(reg, {m_folder});
        const auto again = tests(reg.database(), {});
        QCOMPARE(again.size(), std::size_t(1));
        QVERIFY(again.front().test.results.front().decimals);
        QCOMPARE(machines(reg.database()).front().months, std::optional(18)); // what a user said stays
    }

    void inPartIsNoTick() {
        QCOMPARE(markOf(Accordance::partly), markOf(Accordance::notChecked));
        QVERIFY(markOf(Accordance::partly) != Mark::check);
    }

    void noPasswordIsShown_data() {
        QTest::addColumn<QString>("address");
        QTest::addColumn<QString>("shown");
        QTest::newRow("a file") << "/a/b:c@d.sqlite"
                                << "/a/b:c@d.sqlite";
        QTest::newRow("none") << "postgresql://u@h:5432/db"
                              << "postgresql://u@h:5432/db";
        QTest::newRow("one") << "postgresql://u:s3cret@h:5432/db"
                             << "postgresql://u@h:5432/db";
        QTest::newRow("empty") << "postgresql://u:@h/db"
                               << "postgresql://u@h/db";
        QTest::newRow("with @") << "postgresql://u:s3@cret@h/db"
                                << "postgresql://u@h/db";
        QTest::newRow("with #") << "postgresql://u:s3cret#1@h/db"
                                << "postgresql://u@h/db";
        QTest::newRow("with /") << "postgresql://u:s3cret/1@h/db"
                                << "postgresql://u@h/db";
        QTest::newRow("digits and /") << "postgresql://u:12/s3cret@h/db"
                                      << "postgresql://u@h/db";
        QTest::newRow("digits and #") << "postgresql://u:12#s3cret@h/db"
                                      << "postgresql://u@h/db";
        QTest::newRow("with ?") << "postgresql://u:12?s3cret@h/db"
                                << "postgresql://u@h/db";
        QTest::newRow("behind the ?") << "postgresql://u@h/db?password=s3cret&sslmode=require"
                                      << "postgresql://u@h/db?sslmode=require";
        QTest::newRow("alone behind the ?") << "postgresql://u@h/db?password=s3cret"
                                            << "postgresql://u@h/db";
        QTest::newRow("a socket") << "postgresql:///db?host=/run/p"
                                  << "postgresql:///db?host=/run/p";
    }
    void noPasswordIsShown() {
        QFETCH(QString, address);
        QFETCH(QString, shown);
        QCOMPARE(withoutPassword(address), shown);
    }

    void anAddressTakesNoOtherOptions() {
        for (const char *options : {"password=s3cret", "sslmode=none", "connect_timeout=1", "sslmode"}) {
            try {
                const Database database(QString("postgresql://u@127.0.0.1:1/db?") + options);
                QFAIL("opened");
            } catch (const Error &error) {
                const QString said = Language(Language::Id::english).sentence(error.message);
                QVERIFY2(said.contains("question mark"), qPrintable(said));
                QVERIFY(!said.contains("s3cret"));
            }
        }
        try { // known ones lead to the server, where nobody listens
            const Database database(QString("postgresql://u@127.0.0.1:1/db?sslmode=require"));
            QFAIL("opened");
        } catch (const Error &error) {
            const QString said = Language(Language::Id::english).sentence(error.message);
            QVERIFY2(said.contains("does not answer") || said.contains("not installed"), qPrintable(said));
        }
    }

    void init() {
        m_dir = std::make_unique<QTemporaryDir>();
        m_folder = m_dir->filePath("files");
        QDir().mkpath(m_folder);
        m_path = m_dir->filePath("register.sqlite");
        qputenv("XDG_DATA_HOME", m_dir->filePath("data").toUtf8());
    }

    void aTestIsKeptWhole();
    void onlyWhatHasChangedIsRead();
    void aCopyIsASecondPlace();
    void otherFieldsAreAnotherTest();
    void whatVanishedStaysUntilPruned();
    void brokenFilesAreListedAndChangeNothing();
    void aFolderWithoutPermission();
    void aMissingFolderTakesNothingAway();
    void linksThatLeadBack();
    void namesAreData_data();
    void namesAreData();
    void textsAreData();
    void rebuiltItSaysTheSame();
    void randomFoldersAgreeWithTheirTruth();
    void machinesAreToldApart();
    void foreignFilesAreLeftAsTheyAre_data();
    void foreignFilesAreLeftAsTheyAre();
    void aNewerSchemaIsRefused();
    void noTwoMachinesBecomeOne();
    void anIntervalAndAJoinSurviveARebuild();
    void joinedMachinesArePartedAgain();
    void whatIsSaidMovesWithItsFolder_data();
    void whatIsSaidMovesWithItsFolder();
    void whatComesMeanwhileIsNotGone();
    void whatIsSaidOfMachines_data();
    void whatIsSaidOfMachines();
    void readersNeedReadAccessOnly();
    void aRebuildIsSeenWhole();
    void anotherProgramHoldsTheLock();
    void stoppedItGoesOnLater();
    void simulationsComeAfterTheScan();

private:
    QString file(const QString &name) const { return m_folder + '/' + name; }

    std::unique_ptr<QTemporaryDir> m_dir;
    QString m_folder;
    QString m_path;
};

void RegisterScanTest::aTestIsKeptWhole() {
    Sample sample;
    writeFile(file("a.palmer"), fileOf(sample));
    Register reg(m_path);
    const ScanResult result = scan(reg, {m_folder});
    QCOMPARE(result.files, 1);
    QCOMPARE(result.read, 1);
    QCOMPARE(result.tests, 1);
    QCOMPARE(result.machines, 1);
    TestFilter filter;
    filter.withCurves = true;
    const auto list = tests(reg.database(), filter);
    QCOMPARE(list.size(), std::size_t{1});
    // What comes out is what went in, to the last bit.
    const auto document = std::make_shared<const Document>(readDocument(fileOf(sample)));
    RegisteredTest expected =
        registeredTests(evaluate(document), "Palmer " PALMER_VERSION ", entries 4").front();
    QVERIFY(expected.results.size() > 8);
    QVERIFY(expected.results.front().own > 0 && expected.results.front().shared != 0);
    QCOMPARE(expected.parts.front().source, std::string("device LSR-1/C-1"));
    QCOMPARE(list.front().test.results.size(), expected.results.size());
    QVERIFY(list.front().test == expected);
    QCOMPARE(list.front().places.size(), std::size_t{1});
    QCOMPARE(list.front().places.front().path, file("a.palmer"));
    QCOMPARE(list.front().places.front().test, 1);
    // The parts make up U again: u² = r² + Σc².
    for (const RegisteredResult &one : list.front().test.results) {
        double squares = one.own * one.own;
        for (std::size_t i = 0; i < expected.parts.size(); ++i) {
            if (one.shared >> i & 1U)
                squares += std::pow(expected.parts[i].u * one.sharedFactor, 2);
        }
        const double u = *one.expandedUncertainty / 2;
        QVERIFY2(std::abs(std::sqrt(squares) - u) <= 1e-12 * u, one.id.c_str());
    }
}

void RegisterScanTest::onlyWhatHasChangedIsRead() {
    writeFile(file("a.palmer"), fileOf({}));
    Sample other;
    other.axis = "Y";
    writeFile(file("b.palmer"), fileOf(other));
    const QDateTime before = QDateTime::currentDateTime().addDays(-2);
    for (const char *name : {"a.palmer", "b.palmer"}) {
        QFile old(file(name));
        QVERIFY(old.open(QIODevice::ReadWrite));
        QVERIFY(old.setFileTime(before, QFileDevice::FileModificationTime));
    }
    Register reg(m_path);
    QCOMPARE(scan(reg, {m_folder}).read, 2);
    QCOMPARE(scan(reg, {m_folder}).read, 0);
    const QByteArray list = listed(reg.database());
    // Touched, with the same bytes: not read again as another.
    QFile touched(file("a.palmer"));
    QVERIFY(touched.open(QIODevice::ReadWrite));
    QVERIFY(touched.setFileTime(before.addDays(1), QFileDevice::FileModificationTime));
    touched.close();
    QCOMPARE(scan(reg, {m_folder}).read, 0);
    QCOMPARE(listed(reg.database()), list);
    // Other bytes of the same size, written within the same second.
    Sample changed;
    changed.level = 9.5;
    for (const char *remarks : {"a", "b", "c"}) {
        changed.remarks = remarks;
        writeFile(file("a.palmer"), fileOf(changed));
        QCOMPARE(scan(reg, {m_folder}).read, 1);
    }
    QCOMPARE(tests(reg.database(), {}).size(), std::size_t{2});
    QVERIFY(listed(reg.database()) != list);
}

void RegisterScanTest::aCopyIsASecondPlace() {
    writeFile(file("a.palmer"), fileOf({}));
    writeFile(file("below/copy.palmer"), fileOf({}));
    Register reg(m_path);
    const ScanResult result = scan(reg, {m_folder});
    QCOMPARE(result.files, 2);
    QCOMPARE(result.tests, 1);
    const auto list = tests(reg.database(), {});
    QCOMPARE(list.front().places.size(), std::size_t{2});
    QFile::remove(file("a.palmer"));
    (void)scan(reg, {m_folder}, {.prune = true});
    QCOMPARE(tests(reg.database(), {}).front().places.front().path, file("below/copy.palmer"));
}

void RegisterScanTest::otherFieldsAreAnotherTest() {
    Sample sample;
    writeFile(file("a.palmer"), fileOf(sample));
    sample.remarks = "the same readings";
    writeFile(file("b.palmer"), fileOf(sample));
    sample.remarks.clear();
    sample.serial = "000-018";
    writeFile(file("c.palmer"), fileOf(sample));
    Register reg(m_path);
    QCOMPARE(scan(reg, {m_folder}).tests, 3);
    const auto list = tests(reg.database(), {});
    QCOMPARE(list[0].test.fingerprint, list[1].test.fingerprint);
    QVERIFY(list[0].test.digest != list[1].test.digest);
}

void RegisterScanTest::whatVanishedStaysUntilPruned() {
    writeFile(file("a.palmer"), fileOf({}));
    Register reg(m_path);
    (void)scan(reg, {m_folder});
    QFile::remove(file("a.palmer"));
    const ScanResult gone = scan(reg, {m_folder});
    QCOMPARE(gone.notFound, 1);
    QCOMPARE(gone.tests, 1);
    QCOMPARE(tests(reg.database(), {}).front().places.front().state, QString("notFound"));
    QCOMPARE(troubledSources(reg.database()).size(), std::size_t{1});
    // It comes back.
    writeFile(file("a.palmer"), fileOf({}));
    QCOMPARE(scan(reg, {m_folder}).notFound, 0);
    QCOMPARE(tests(reg.database(), {}).front().places.front().state, QString("read"));
    QFile::remove(file("a.palmer"));
    const ScanResult refused = scan(reg, {m_folder}, {.prune = true});
    QCOMPARE(refused.notPruned, QStringList{m_folder}); // as an empty place of a share
    QCOMPARE(refused.tests, 1);
    const ScanResult pruned = scan(reg, {m_folder}, {.prune = true, .force = true});
    QCOMPARE(pruned.pruned, 1);
    QCOMPARE(pruned.tests, 0);
    QCOMPARE(machines(reg.database()).size(), std::size_t{0});
    QCOMPARE(listed(reg.database()), QByteArray());
}

void RegisterScanTest::brokenFilesAreListedAndChangeNothing() {
    const QByteArray whole = fileOf({});
    writeFile(file("whole.palmer"), whole);
    writeFile(file("empty.palmer"), {});
    writeFile(file("half.palmer"), whole.first(whole.size() / 2));
    writeFile(file("text.palmer"), "no JSON at all");
    writeFile(file("newer.palmer"), QByteArray(whole).replace("\"version\": 2", "\"version\": 99"));
    writeFile(file("cut.pdf"), "%PDF-1.7\n1 0 obj");
    writeFile(file("notes.txt"), "not looked at");
    QDir().mkpath(file("folder.palmer"));
    QFile::link("/dev/zero", file("endless.palmer"));
    QFile::link(file("nowhere"), file("broken link.palmer"));
    Register reg(m_path);
    const ScanResult result = scan(reg, {m_folder});
    QCOMPARE(result.tests, 1);
    QStringList broken;
    for (const Unreadable &one : result.unreadable)
        broken << QFileInfo(one.path).fileName();
    QCOMPARE(broken, (QStringList{"cut.pdf", "empty.palmer", "endless.palmer", "half.palmer", "newer.palmer",
                                  "text.palmer"}));
    for (const Unreadable &one : result.unreadable) {
        const QString sentence = sentenceFrom(one.error, Language(Language::Id::french));
        QVERIFY2(sentence.size() > 10, qPrintable(sentence));
        QVERIFY(sentence != sentenceFrom(one.error, Language(Language::Id::english)));
    }
    // The same again from what the register keeps.
    const ScanResult again = scan(reg, {m_folder});
    QCOMPARE(again.unreadable.size(), std::size_t{6});
    QCOMPARE(again.read, 0);
    QCOMPARE(troubledSources(reg.database()).size(), std::size_t{6});
    // Mended.
    writeFile(file("half.palmer"), whole);
    QCOMPARE(scan(reg, {m_folder}).unreadable.size(), std::size_t{5});
}

void RegisterScanTest::aFolderWithoutPermission() {
    constexpr uid_t nobody = 65534;
    const bool isRoot = ::geteuid() == 0; // who may read any folder: as somebody else then
    writeFile(file("closed/a.palmer"), fileOf({}));
    for (const QString &path : {m_dir->path(), m_folder})
        ::chmod(QFile::encodeName(path).constData(), 0777);
    ScanResult result;
    {
        if (isRoot)
            QCOMPARE(::seteuid(nobody), 0);
        Register reg(m_path);
        QCOMPARE(scan(reg, {m_folder}).tests, 1);
        if (isRoot)
            QCOMPARE(::seteuid(0), 0);
        ::chmod(QFile::encodeName(file("closed")).constData(), 0);
        if (isRoot)
            QCOMPARE(::seteuid(nobody), 0);
        result = scan(reg, {m_folder});
    }
    if (isRoot)
        QCOMPARE(::seteuid(0), 0);
    ::chmod(QFile::encodeName(file("closed")).constData(), 0755);
    QCOMPARE(result.unreadable.size(), std::size_t{1});
    QCOMPARE(result.notFound, 0); // nobody knows
    QCOMPARE(result.tests, 1);
}

void RegisterScanTest::aMissingFolderTakesNothingAway() {
    writeFile(file("a.palmer"), fileOf({}));
    Register reg(m_path);
    (void)scan(reg, {m_folder});
    QVERIFY(QDir().rename(m_folder, m_folder + " elsewhere")); // as a share that is not mounted
    const ScanResult result = scan(reg, {m_folder}, {.prune = true});
    QCOMPARE(result.unreadable.size(), std::size_t{1});
    QCOMPARE(result.pruned, 0);
    QCOMPARE(result.tests, 1);
}

void RegisterScanTest::linksThatLeadBack() {
    writeFile(file("a/one.palmer"), fileOf({}));
    QFile::link(m_folder, file("a/up"));
    QFile::link(file("a"), file("a/self"));
    QFile::link(file("loop"), file("loop"));
    QDir().mkpath(m_dir->filePath("elsewhere"));
    Sample other;
    other.axis = "Y";
    writeFile(m_dir->filePath("elsewhere/two.palmer"), fileOf(other));
    QFile::link(m_dir->filePath("elsewhere"), file("linked"));
    Register reg(m_path);
    const ScanResult result = scan(reg, {m_folder});
    QCOMPARE(result.files, 2);
    QCOMPARE(result.tests, 2);
}

void RegisterScanTest::namesAreData_data() {
    QTest::addColumn<QString>("name");
    QTest::newRow("apostrophe") << "l'essai.palmer";
    QTest::newRow("quotation marks") << "\"A\".palmer";
    QTest::newRow("line breaks") << "two\nlines\r.palmer";
    QTest::newRow("a statement") << "'); drop table test; --.palmer";
    QTest::newRow("a place of a value") << "?1 :name %1 %2.palmer";
    QTest::newRow("other scripts") << "機械 Ω é\u0301 \U0001F600.palmer";
    QTest::newRow("backslash") << "a\\b.palmer";
    QTest::newRow("capitals") << "A.PALMER";
}

void RegisterScanTest::namesAreData() {
    QFETCH(QString, name);
    writeFile(file(name), fileOf({}));
    Register reg(m_path);
    QCOMPARE(scan(reg, {m_folder}).tests, 1);
    QCOMPARE(tests(reg.database(), {}).front().places.front().path, file(name));
    QCOMPARE(scan(reg, {m_folder}).tests, 1);
    QFile::remove(file(name));
    QCOMPARE(scan(reg, {m_folder}, {.prune = true, .force = true}).tests, 0);
}

void RegisterScanTest::textsAreData() {
    Sample sample;
    sample.machine = "M'); drop table test; --";
    sample.serial = "1' or '1'='1";
    writeFile(file("a.palmer"), fileOf(sample));
    Register reg(m_path);
    (void)scan(reg, {m_folder});
    const auto all = machines(reg.database());
    QCOMPARE(all.size(), std::size_t{1});
    QCOMPARE(all.front().name, QString("M'); drop table test; --"));
    QCOMPARE(machinesCalled(reg.database(), "' or 2=2 --").size(), std::size_t{0});
    TestFilter filter;
    filter.since = "' or '1'='1";
    QCOMPARE(tests(reg.database(), filter).size(), std::size_t{1}); // "2024…" stands behind "'"
    filter.since = "9";
    QCOMPARE(tests(reg.database(), filter).size(), std::size_t{0});
}

void RegisterScanTest::rebuiltItSaysTheSame() {
    for (int i = 0; i < 30; ++i) {
        Sample sample;
        sample.level = 8 + 0.1 * i;
        sample.serial = "000-0" + std::to_string(i % 3);
        sample.machine = i % 2 ? "Called so" : "and later so";
        sample.date = "20" + std::to_string(10 + i % 12) + "-03-0" + std::to_string(1 + i % 9);
        writeFile(file(QString("%1.palmer").arg(i)), fileOf(sample));
    }
    writeFile(file("copy.palmer"), contents(file("3.palmer")));
    QByteArray first;
    {
        Register reg(m_path);
        (void)scan(reg, {m_folder}, {.jobs = 1});
        first = listed(reg.database());
    }
    QCOMPARE(first.count('\n'), 30);
    {
        Register reg(m_path, Register::Open::rebuild);
        QCOMPARE(listed(reg.database()), QByteArray());
        Register reader(m_path, Register::Open::read); // sees the old one until the new one is done
        QCOMPARE(listed(reader.database()), first);
        (void)scan(reg, {m_folder}, {.jobs = 4});
        QCOMPARE(listed(reg.database()), first);
    }
    for (const char *ending : {"", "-wal", "-shm"})
        QFile::remove(m_path + ending);
    // In two steps, the second half first.
    Register reg(m_path);
    for (int i = 15; i < 30; ++i)
        (void)scan(reg, {file(QString("%1.palmer").arg(i))});
    (void)scan(reg, {m_folder});
    QCOMPARE(listed(reg.database()), first);
}

/// Files are written, changed, copied, moved and removed at random; after each scan the register says what
/// the folder holds, and what one made anew says.
void RegisterScanTest::randomFoldersAgreeWithTheirTruth() {
    std::mt19937 random(11);
    std::map<QString, QByteArray> truth;
    Register reg(m_path);
    for (int step = 0; step < 25; ++step) {
        for (int change = 0; change < 4; ++change) {
            const QString name = file(QString("%1/%2.palmer").arg(random() % 3).arg(random() % 6));
            Sample sample;
            sample.level = 5 + static_cast<double>(random() % 100) / 10;
            sample.axis = std::string(1, static_cast<char>('X' + random() % 3));
            switch (random() % 4) {
            case 0:
                QFile::remove(name);
                truth.erase(name);
                break;
            case 1:
                if (!truth.empty()) {
                    const QByteArray copy = truth.begin()->second;
                    writeFile(name, copy);
                    truth[name] = copy;
                }
                break;
            default:
                writeFile(name, fileOf(sample));
                truth[name] = fileOf(sample);
            }
        }
        const ScanResult result = scan(reg, {m_folder}, {.prune = true, .force = true});
        std::set<QByteArray> different;
        for (const auto &[name, bytes] : truth)
            different.insert(bytes);
        QCOMPARE(result.tests, static_cast<int>(different.size()));
        QCOMPARE(result.files, static_cast<int>(truth.size()));
        std::size_t places = 0;
        for (const ListedTest &test : tests(reg.database(), {}))
            places += test.places.size();
        QCOMPARE(places, truth.size());
    }
    const QString anew = m_dir->filePath("anew.sqlite");
    Register other(anew);
    (void)scan(other, {m_folder});
    QCOMPARE(listed(other.database()), listed(reg.database()));
}

void RegisterScanTest::machinesAreToldApart() {
    const auto add = [this](const char *name, const std::string &maker, const std::string &serial,
                            const std::string &date) {
        Sample sample;
        sample.machine = std::string("Machine ") + name;
        sample.maker = maker;
        sample.serial = serial;
        sample.date = date;
        writeFile(file(QString("%1.palmer").arg(name)), fileOf(sample));
    };
    add("a", "Maker A", "000-017", "2020-01-01");
    add("b", "MAKER  a", " 000-017", "2021-01-01"); // the same, called anew
    add("c", "Maker B", "000-017", "2021-01-01");
    add("d", "Maker A", "", "2021-01-01");
    add("e", "Maker A", " - ", "2021-01-01"); // no serial number either
    add("f", "Maker A", "000 017", "2021-01-01");
    Register reg(m_path);
    (void)scan(reg, {m_folder});
    const auto all = machines(reg.database());
    QCOMPARE(all.size(), std::size_t{5});
    QCOMPARE(all[0].title(), QString("Machine b")); // as in its newest test
    QCOMPARE(all[1].title(), QString("Machine c"));
    QCOMPARE(all[2].title(), QString("Machine f"));
    for (std::size_t i = 0; i < all.size(); ++i)
        QCOMPARE(all[i].isIdentified, i < 3);
    const auto called = [&](const char *words) {
        QStringList titles;
        for (const ListedMachine &machine : machinesCalled(reg.database(), words))
            titles << machine.title().right(1);
        return titles.join("");
    };
    QCOMPARE(called("000017"), QString("bcf"));
    QCOMPARE(called("000-017"), QString("bc"));
    QCOMPARE(called("000 017"), QString("f"));
    QCOMPARE(called("machine B"), QString("b"));
    QCOMPARE(called("machine A"), QString("b")); // as its older test calls it
    QCOMPARE(called("maker"), QString("bcfde"));
    QCOMPARE(called("4"), QString("d")); // its number in the list
    QCOMPARE(called("4."), QString("d"));
    // Without its newest test it is called as before.
    QFile::remove(file("b.palmer"));
    (void)scan(reg, {m_folder}, {.prune = true});
    QCOMPARE(machines(reg.database())[0].title(), QString("Machine a"));
}

void RegisterScanTest::foreignFilesAreLeftAsTheyAre_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("a text") << QByteArray("this is my only copy\n");
    QTest::newRow("a test file") << fileOf({});
    QTest::newRow("the head of a database and rubbish") << QByteArray("SQLite format 3\0rubbish", 23);
    QTest::newRow("a database of something else") << QByteArray("database");
}

void RegisterScanTest::foreignFilesAreLeftAsTheyAre() {
    QFETCH(QByteArray, bytes);
    if (bytes == "database") {
        QSqlDatabase other = QSqlDatabase::addDatabase("QSQLITE", "other");
        other.setDatabaseName(m_path);
        QVERIFY(other.open());
        QVERIFY(QSqlQuery(other).exec("create table letters (id integer)"));
        other = {};
        QSqlDatabase::removeDatabase("other");
    } else {
        writeFile(m_path, bytes);
    }
    const QByteArray before = contents(m_path);
    QVERIFY(refusal(m_path).contains("is no register"));
    QVERIFY(refusal(m_path, Register::Open::rebuild).contains("is no register"));
    QCOMPARE(contents(m_path), before);
    QVERIFY(!QFile::exists(m_path + "-wal"));
}

void RegisterScanTest::aNewerSchemaIsRefused() {
    writeFile(file("a.palmer"), fileOf({}));
    {
        Register reg(m_path);
        (void)scan(reg, {m_folder});
        reg.database().execute("update register set value = '99' where name = 'schema'");
        reg.database().execute("create table comes_later (id integer)");
    }
    QVERIFY(refusal(m_path).contains("newer version"));
    QVERIFY(refusal(m_path, Register::Open::read).contains("newer version"));
    Register reg(m_path, Register::Open::rebuild);
    QCOMPARE(scan(reg, {m_folder}).tests, 1);
    QCOMPARE(refusal(m_path), QString());
}

/// Machines that differ in one field, however alike it looks.
void RegisterScanTest::noTwoMachinesBecomeOne() {
    Register reg(m_path);
    QCOMPARE(testdata::silentlyJoined(reg, m_folder, 49), QStringList());
}

/// What a user says of machines stands beside the files, so that a register made anew says it again.
void RegisterScanTest::anIntervalAndAJoinSurviveARebuild() {
    for (const char *name : {"a", "b", "c"}) {
        Sample sample;
        sample.machine = std::string("Lathe ") + name;
        sample.serial = "";
        writeFile(file(QString("%1/%1.palmer").arg(name)), fileOf(sample));
    }
    const Language english(Language::Id::english);
    const auto titles = [](Register &reg) {
        QStringList result;
        for (const ListedMachine &machine : machines(reg.database()))
            result << machine.title() + (machine.months ? QString::number(*machine.months) : QString());
        return result;
    };
    {
        Register reg(m_path);
        (void)scan(reg, {m_folder});
        const auto all = machines(reg.database());
        QCOMPARE(all.size(), std::size_t{3});
        QCOMPARE(chooseMachine(reg, all[1], nullptr, 6, english), QStringList());
        QCOMPARE(chooseMachine(reg, all[0], &all[1], {}, english),
                 QStringList()); // its interval is that of both
        QCOMPARE(titles(reg), (QStringList{"Lathe a6", "Lathe c"}));
        for (const char *name : {"lathe a", "lathe b", "B"}) // as either is called
            QCOMPARE(machinesCalled(reg.database(), name).front().title(), QString("Lathe a"));
        QCOMPARE(testCounts(reg.database()).at(all[0].id), 2);
        const auto two = machines(reg.database());
        QCOMPARE(chooseMachine(reg, two[1], &two[0], 12, english), QStringList());
        QCOMPARE(titles(reg), QStringList{"Lathe c12"}); // joined machines are joined together
    }
    QVERIFY(QFile::exists(file(machineFileName)));
    for (const char *ending : {"", "-wal", "-shm"})
        QFile::remove(m_path + ending);
    Register reg(m_path);
    (void)scan(reg, {m_folder});
    QCOMPARE(titles(reg), QStringList{"Lathe c12"});
    // One folder alone, of which nothing is said; then a folder above it, where something is.
    Register part(m_dir->filePath("part.sqlite"));
    (void)scan(part, {file("a")});
    QCOMPARE(titles(part), QStringList{"Lathe a"});
    (void)scan(part, {m_dir->path()});
    QCOMPARE(titles(part), QStringList{"Lathe c12"});
    // What is taken out by hand is parted again; what cannot be read changes nothing.
    writeFile(file(machineFileName), "{");
    const ScanResult broken = scan(reg, {m_folder});
    QCOMPARE(broken.unreadable.size(), std::size_t{1});
    QCOMPARE(titles(reg), QStringList{"Lathe c12"});
    QFile::remove(file(machineFileName));
    (void)scan(reg, {m_folder});
    QCOMPARE(titles(reg), (QStringList{"Lathe a", "Lathe b", "Lathe c"}));
}

/// Each of three that were joined one after the other is parted alone; a folder that is not there says so.
void RegisterScanTest::joinedMachinesArePartedAgain() {
    for (const char *name : {"a", "b", "c"}) {
        Sample sample;
        sample.machine = std::string("Lathe ") + name;
        sample.serial = name;
        writeFile(file(QString("%1/%1.palmer").arg(name)), fileOf(sample));
    }
    const Language english(Language::Id::english);
    Register reg(m_path);
    (void)scan(reg, {file("a"), file("b"), file("c")});
    const auto all = [&reg] { return machines(reg.database()); };
    const auto marks = [](const ListedMachine &machine) {
        QStringList result;
        for (const MachineFields &joined : machine.joined)
            result << markOf(joined);
        return result;
    };
    (void)chooseMachine(reg, all()[0], &all()[1], {}, english);
    (void)chooseMachine(reg, all()[1], &all()[0], {}, english);
    QCOMPARE(all().size(), std::size_t{1});
    QCOMPARE(marks(all()[0]), (QStringList{"a", "b"}));
    QCOMPARE(evidenceOf(all()[0], english).section(" · ", -1), QString("joined with a, b"));
    separateMachine(reg, all()[0], all()[0].joined[1], english);
    QCOMPARE(all().size(), std::size_t{2});
    QCOMPARE(marks(all()[1]), QStringList{"a"}); // its interval and name are those of c
    QVERIFY(QDir(m_folder).rename("c", "elsewhere"));
    try {
        separateMachine(reg, all()[1], all()[1].joined[0], english);
        QFAIL("parted, though a folder joins them");
    } catch (const Error &error) {
        QVERIFY2(sentenceOf(error).contains("connect"), qPrintable(sentenceOf(error)));
    }
    QVERIFY(QDir(m_folder).rename("elsewhere", "c"));
    separateMachine(reg, all()[1], all()[1].joined[0], english);
    QCOMPARE(all().size(), std::size_t{3});
    Register anew(m_dir->filePath("anew.sqlite"));
    (void)scan(anew, {m_folder});
    QCOMPARE(machines(anew.database()).size(), std::size_t{3});
}

void RegisterScanTest::whatIsSaidMovesWithItsFolder_data() {
    QTest::addColumn<bool>("rebuild");
    QTest::newRow("pruned") << false;
    QTest::newRow("made anew") << true;
}

/// The register keeps no choice of the old place, where nobody could change it any more.
void RegisterScanTest::whatIsSaidMovesWithItsFolder() {
    QFETCH(bool, rebuild);
    for (const char *name : {"a", "b"}) {
        Sample sample;
        sample.machine = std::string("Lathe ") + name;
        sample.serial = "";
        writeFile(file(QString("old/%1.palmer").arg(name)), fileOf(sample));
    }
    writeFile(file("stays.palmer"), fileOf({}));
    {
        Register reg(m_path);
        (void)scan(reg, {m_folder});
        const auto all = machines(reg.database());
        (void)chooseMachine(reg, all[1], &all[2], {}, Language(Language::Id::english));
        QVERIFY(QFile::remove(file(machineFileName)));
        writeFile(file("old/" + machineFileName), withChoice({}, all[1], &all[2], {}));
        (void)scan(reg, {m_folder});
        QCOMPARE(machines(reg.database()).size(), std::size_t{2});
    }
    QVERIFY(QDir(m_folder).rename("old", "new"));
    QVERIFY(QFile::remove(file("new/" + machineFileName))); // parted again
    Register reg(m_path, rebuild ? Register::Open::rebuild : Register::Open::keep);
    (void)scan(reg, {m_folder}, {.prune = !rebuild});
    QCOMPARE(machines(reg.database()).size(), std::size_t{3});
}

/// A file that another program adds to the register while one looks for files has not vanished.
void RegisterScanTest::whatComesMeanwhileIsNotGone() {
    for (int i = 0; i < 1000; ++i)
        QDir().mkpath(file(QString("z/%1").arg(i))); // so that looking takes a while
    { Register reg(m_path); }
    std::atomic<bool> ends = false;
    std::thread other([&] {
        Register reg(m_path);
        for (int i = 0; i < 60; ++i) {
            const QString path = file(QString("%1.palmer").arg(i));
            writeFile(path, fileOf({.level = 5 + 0.1 * i}));
            (void)scan(reg, {path});
        }
        ends = true;
    });
    Register reg(m_path);
    int gone = 0;
    while (!ends) {
        const ScanResult result = scan(reg, {m_folder}, {.prune = true, .force = true});
        gone += result.pruned;
    }
    other.join();
    QCOMPARE(gone, 0);
}

void RegisterScanTest::whatIsSaidOfMachines_data() {
    QTest::addColumn<QByteArray>("json");
    QTest::addColumn<QString>("said");
    const QByteArray head = R"({"format": "palmer machines", "version": 1, "machines": )";
    QTest::newRow("nothing") << QByteArray() << "";
    QTest::newRow("none") << head + "[]}"
                          << "";
    QTest::newRow("keys that come later") << head + R"([{"name": "A", "colour": 1}]})"
                                          << "";
    QTest::newRow("another file") << QByteArray(R"({"format": "palmer test report", "version": 1})")
                                  << "no list";
    QTest::newRow("a list of texts") << head + R"(["A"]})"
                                     << "no list";
    QTest::newRow("an interval in words") << head + R"([{"name": "A", "interval": "six"}]})"
                                          << "no list";
    QTest::newRow("half a month") << head + R"([{"name": "A", "interval": 6.5}]})"
                                  << "no list";
    QTest::newRow("six months with a point") << head + R"([{"name": "A", "interval": 6.0}]})"
                                             << "";
    QTest::newRow("an interval beyond all numbers") << head + R"([{"name": "A", "interval": 1e300}]})"
                                                    << "";
    QTest::newRow("a number as a name") << head + R"([{"name": 1}]})"
                                        << "no list";
    QTest::newRow("later") << QByteArray(R"({"format": "palmer machines", "version": 2})") << "newer";
}
void RegisterScanTest::whatIsSaidOfMachines() {
    QFETCH(QByteArray, json);
    QFETCH(QString, said);
    try {
        MachineChoices().add(json);
        QCOMPARE(said, QString());
    } catch (const Error &error) {
        QVERIFY2(!said.isEmpty() && sentenceOf(error).contains(said), qPrintable(sentenceOf(error)));
    }
    // Two files that join each machine to the other make one of them.
    const MachineFields a{"A", "", "", ""};
    const MachineFields b{"B", "", "", ""};
    MachineChoices choices;
    choices.add(withChoice({}, a, &b, {}));
    choices.add(withChoice({}, b, &a, 6));
    QCOMPARE(choices.machineOf(machineIdentity(a)), choices.machineOf(machineIdentity(b)));
    QCOMPARE(choices.interval(choices.machineOf(machineIdentity(a))), std::optional(6));
    // Another that is joined to one of them belongs to the same, though its name comes first.
    const MachineFields third{"0", "", "", ""};
    choices.add(withChoice({}, a, &third, {}));
    QCOMPARE(choices.machineOf(machineIdentity(third)), choices.machineOf(machineIdentity(b)));
}

/// Whoever may only read lists it, whoever else is writing, and leaves nothing behind.
void RegisterScanTest::readersNeedReadAccessOnly() {
    constexpr uid_t nobody = 65534;
    if (::geteuid() != 0)
        QSKIP("only the administrator can try as somebody else");
    writeFile(file("a.palmer"), fileOf({}));
    const QString folder = m_dir->filePath("read only é?#%20");
    QDir().mkpath(folder);
    const QString path = folder + "/register.sqlite";
    QByteArray all;
    {
        Register reg(path);
        (void)scan(reg, {m_folder});
        all = listed(reg.database());
    }
    ::chmod(QFile::encodeName(m_dir->path()).constData(), 0755);
    ::chmod(QFile::encodeName(path).constData(), 0444);
    ::chmod(QFile::encodeName(folder).constData(), 0555);
    const auto read = [&] {
        const auto back = qScopeGuard([] { (void)::seteuid(0); });
        if (::seteuid(nobody) != 0)
            return QByteArray("not somebody else");
        Register reg(path, Register::Open::read);
        return listed(reg.database());
    };
    QCOMPARE(read(), all);
    QCOMPARE(QDir(folder).entryList(QDir::Files), QStringList{"register.sqlite"});
    Register writer(path); // whose log lies beside it
    QCOMPARE(read(), all);
    writeFile(file("b.palmer"), fileOf({.axis = "Y"}));
    (void)scan(writer, {m_folder});
    QCOMPARE(read(), listed(writer.database()));
    // One of an older version has to be brought up to date first, by somebody who may.
    for (const char *statement :
         {"alter table source drop column number", "update register set value = '2' where name = 'schema'"})
        writer.database().execute(QString::fromLatin1(statement));
    try {
        (void)read();
        QFAIL("read as if it were of this version");
    } catch (const Error &error) {
        QVERIFY2(sentenceOf(error).contains("older version"), qPrintable(sentenceOf(error)));
    }
    QCOMPARE(refusal(path, Register::Open::read), QString()); // by the administrator
    const auto missing = m_dir->filePath("nowhere/register.sqlite");
    QVERIFY(refusal(missing, Register::Open::read).contains("no register yet"));
    // Nor takes it away what another program has just begun, or a link to a share that is not mounted.
    const QString link = file("linked.sqlite");
    QVERIFY(QFile::link(file("not mounted/register.sqlite"), link));
    QVERIFY(refusal(link, Register::Open::read).contains("no register yet"));
    QVERIFY(QFileInfo(link).isSymLink());
    QVERIFY(!QFile::exists(m_dir->filePath("nowhere")));
}

/// While it is made anew others see the old register or the new one, and a rebuild that ends early changes
/// nothing.
void RegisterScanTest::aRebuildIsSeenWhole() {
    for (int i = 0; i < 24; ++i) {
        Sample sample;
        sample.machine = sample.serial = "M " + std::to_string(i % 5);
        sample.level = 5 + 0.1 * i;
        writeFile(file(QString("%1.palmer").arg(i)), fileOf(sample));
    }
    QByteArray first;
    {
        Register reg(m_path);
        (void)scan(reg, {m_folder});
        first = listed(reg.database());
        writeFile(file("one more.palmer"), fileOf({}));
    }
    QCOMPARE(testdata::wrongReads(m_path, m_folder), QStringList());
    { Register given(m_path, Register::Open::rebuild); }
    Register reg(m_path, Register::Open::read);
    QCOMPARE(listed(reg.database()).count('\n'), first.count('\n') + 1);
}

void RegisterScanTest::anotherProgramHoldsTheLock() {
    writeFile(file("a.palmer"), fileOf({}));
    Register holder(m_path);
    Register reg(m_path);
    Transaction transaction(holder.database());
    QString said;
    try {
        (void)scan(reg, {m_folder});
    } catch (const Error &error) {
        said = sentenceOf(error);
    }
    QVERIFY2(said.contains("locked by another program"), qPrintable(said));
    transaction.commit();
    QCOMPARE(scan(reg, {m_folder}).tests, 1);
}

void RegisterScanTest::stoppedItGoesOnLater() {
    for (int i = 0; i < 20; ++i) {
        Sample sample;
        sample.level = 5 + i;
        writeFile(file(QString("%1.palmer").arg(i)), fileOf(sample));
    }
    std::stop_source stop;
    stop.request_stop();
    Register reg(m_path);
    QVERIFY(scan(reg, {m_folder}, {.stop = stop.get_token()}).stopped);
    QCOMPARE(scan(reg, {m_folder}).tests, 20);
}

void RegisterScanTest::simulationsComeAfterTheScan() {
    Sample sample;
    sample.uncertainty.replace(sample.uncertainty.find("budget"), 6, "monteCarlo");
    writeFile(file("a.palmer"), fileOf(sample));
    Register reg(m_path);
    bool simulated = false;
    (void)scan(reg, {m_folder}, {.progress = [&](const ScanProgress &progress) {
                   simulated = simulated || progress.simulating;
               }});
    QVERIFY(simulated);
    const RegisteredTest test = tests(reg.database(), {}).front().test;
    QVERIFY(!test.awaitsSimulation);
    QVERIFY(test.results.front().expandedUncertainty);
    QVERIFY(!test.results.front().k);
    simulated = false;
    (void)scan(reg, {m_folder}, {.progress = [&](const ScanProgress &progress) {
                   simulated = simulated || progress.simulating;
               }});
    QVERIFY(!simulated);
}

QTEST_GUILESS_MAIN(RegisterScanTest)
#include "registerscan.moc"
