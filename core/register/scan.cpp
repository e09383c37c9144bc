// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/scan.h"

#include "document/readdocument.h"
#include "document/savedocument.h"
#include "document/sha256.h"
#include "kernel/numerics/runinbackground.h"
#include "proof/readreportpdf.h"
#include "register/machinechoices.h"
#include "register/register.h"
#include "register/storedsentence.h"
#include "register/walk.h"
#include "register/writer.h"

#include <QDateTime>
#include <QFileInfo>
#include <algorithm>
#include <chrono>
#include <deque>
#include <future>
#include <new>
#include <set>
#include <thread>

namespace palmer {

namespace {

/// Identifies the reader: with another version, or other contents of an entry, files are read again.
const QString program = QStringLiteral("Palmer " PALMER_VERSION ", entries 4");

constexpr int filesOfTransaction = 256;
constexpr qint64 tooFresh = 2'000; ///< ms: a file system may give two states of a file the same time

/// The content of a file.
struct ReadFile {
    KnownSource source;
    std::vector<RegisteredTest> tests;
    bool isSame = false; ///< content unchanged since the register was written
};

KnownSource sourceOf(const ListedFile &file, SourceState state) {
    KnownSource source;
    source.path = file.path;
    source.size = file.size;
    const bool settled = QDateTime::currentMSecsSinceEpoch() - file.modified > tooFresh;
    source.modified = settled ? file.modified : -1;
    source.program = program;
    source.state = sourceWord(state);
    return source;
}

/// Returns the document of a test file or a report; null for a history or a PDF of another program. Throws
/// Error.
std::optional<Document> documentIn(const QByteArray &bytes) {
    if (!isPdf(bytes))
        return readDocument(bytes);
    if (isForeignPdf(bytes))
        return std::nullopt;
    const ReportPdf report = readReportPdf(bytes, Carried::testFileOrHistory);
    return report.isHistory ? std::nullopt : std::optional(readDocument(report.testFile));
}

ReadFile readFile(const ListedFile &file, const KnownSource *known) {
    ReadFile result;
    result.source = sourceOf(file, SourceState::read);
    try {
        const QByteArray bytes = readBytes(file.path);
        result.source.sha256 = QString::fromStdString(sha256(bytes));
        if (known && known->sha256 == result.source.sha256 && known->program == program) {
            result.isSame = true;
            if (!known->error.isEmpty())
                result.source.state = sourceWord(SourceState::unreadable);
            else if (known->state == sourceWord(SourceState::foreign))
                result.source.state = known->state;
            result.source.error = known->error;
            return result;
        }
        if (auto document = documentIn(bytes)) {
            result.source.number = QString::fromStdString(document->report.number);
            result.tests =
                registeredTests(evaluate(std::make_shared<const Document>(std::move(*document))), program);
        } else {
            result.source.state = sourceWord(SourceState::foreign);
        }
    } catch (const Error &error) {
        result.source.state = sourceWord(SourceState::unreadable);
        result.source.error = storedSentence(error);
    } catch (const std::bad_alloc &) {
        result.source.state = sourceWord(SourceState::unreadable);
        result.source.error = storedSentence(
            Error(Error::Kind::tooLarge, {REPORT_TEXT("report", "not enough memory for this"), {}}));
    }
    result.isSame = known && !result.source.error.isEmpty() && known->error == result.source.error &&
                    known->sha256 == result.source.sha256 && known->program == program;
    return result;
}

/// Reads files in their order, on as many threads as there are jobs, some files ahead of the consumer.
class Readers {
public:
    Readers(const std::vector<ListedFile> &files, const std::map<QString, KnownSource> &known, int jobs,
            const std::stop_token &stop)
        : m_files(files)
        , m_known(known)
        , m_jobs(jobs > 0 ? static_cast<unsigned>(jobs) : std::max(1U, std::thread::hardware_concurrency()))
        , m_stop(stop) {}

    /// Returns the next files; none if there are none left.
    std::vector<ReadFile> take() {
        for (; m_waiting.size() < m_jobs && m_next < m_files.size() && !m_stop.stop_requested();
             m_next += filesOfThread)
            m_waiting.push_back(runInBackground(true, [this, first = m_next] { return read(first); }));
        if (m_waiting.empty())
            return {};
        std::vector<ReadFile> result = m_waiting.front().get();
        m_waiting.pop_front();
        return result;
    }

private:
    static constexpr std::size_t filesOfThread = 16;

    [[nodiscard]] std::vector<ReadFile> read(std::size_t first) const {
        std::vector<ReadFile> result;
        for (std::size_t i = first; i < std::min(first + filesOfThread, m_files.size()); ++i) {
            const auto known = m_known.find(m_files[i].path);
            if (m_stop.stop_requested())
                break;
            result.push_back(readFile(m_files[i], known == m_known.end() ? nullptr : &known->second));
        }
        return result;
    }

    const std::vector<ListedFile> &m_files;
    const std::map<QString, KnownSource> &m_known;
    std::size_t m_jobs;
    const std::stop_token &m_stop;
    std::size_t m_next = 0;
    std::deque<std::future<std::vector<ReadFile>>> m_waiting; ///< each ends its thread
};

class Scan {
public:
    Scan(Register &reg, const QStringList &folders, const ScanOptions &options)
        : m_register(reg)
        , m_writer(reg.database())
        , m_options(options) {
        for (const QString &folder : folders)
            m_folders << cleanPath(folder);
    }

    ScanResult run() {
        m_known = RegisterWriter::sources(m_register.database()); // first: others add what comes meanwhile
        const Listing listing = listFiles(m_folders, m_options.stop);
        m_result.files = static_cast<int>(listing.files.size());
        for (const UnreadableFolder &folder : listing.unreadable)
            m_result.unreadable.push_back({folder.path, storedSentence(folder.error)});
        QStringList folders = listing.machineFolders;
        std::ranges::copy_if(m_folders, std::back_inserter(folders),
                             [](const QString &folder) { return QFileInfo(folder).isDir(); });
        m_writer.takeMachineFiles(changedMachineFiles(m_register.database(), folders, m_result.unreadable));
        sortOut(listing);
        readChanged();
        if (!m_options.stop.stop_requested()) {
            markVanished(listing);
            leaveFolders();
            simulate();
            m_register.finish();
        }
        m_result.stopped = m_options.stop.stop_requested();
        std::ranges::sort(m_result.unreadable, {}, &Unreadable::path);
        m_result.tests = count(QStringLiteral("select count(*) from test"));
        m_result.machines = count(QStringLiteral("select count(*) from machine where id in (select machine "
                                                 "from test)"));
        return m_result;
    }

private:
    int count(const QString &statement) { return m_register.database().first(statement).value_or(0).toInt(); }

    /// Selects the files to be read.
    void sortOut(const Listing &listing) {
        for (const ListedFile &file : listing.files) {
            const auto known = m_known.find(file.path);
            const bool isSame = known != m_known.end() && known->second.size == file.size &&
                                known->second.modified == file.modified && known->second.program == program &&
                                known->second.state != sourceWord(SourceState::notFound);
            if (!isSame)
                m_changed.push_back(file);
            else if (known->second.state == sourceWord(SourceState::unreadable))
                // The cause may be gone, unless it was the content.
                known->second.sha256.isEmpty()
                    ? m_changed.push_back(file)
                    : m_result.unreadable.push_back({file.path, known->second.error});
        }
    }

    void tell(int done, bool simulating, int total) const {
        if (m_options.progress)
            m_options.progress({done, total, simulating});
    }

    void readChanged() {
        if (m_changed.empty())
            return;
        const int total = static_cast<int>(m_changed.size());
        Readers readers(m_changed, m_known, m_options.jobs, m_options.stop);
        int done = 0;
        for (bool more = true; more;) {
            std::vector<ReadFile> some;
            const auto begin = std::chrono::steady_clock::now();
            while (more && some.size() < filesOfTransaction &&
                   std::chrono::steady_clock::now() - begin < std::chrono::seconds(1)) {
                std::vector<ReadFile> next = readers.take();
                more = !next.empty();
                std::ranges::move(next, std::back_inserter(some));
            }
            write(some);
            done += static_cast<int>(some.size());
            tell(done, false, total);
        }
    }

    void write(const std::vector<ReadFile> &files) {
        if (files.empty())
            return;
        Transaction transaction(m_register.database());
        m_writer.begin();
        for (const ReadFile &file : files) {
            if (file.isSame)
                m_writer.refresh(file.source);
            else
                m_writer.put(file.source, file.tests);
        }
        m_writer.finish();
        transaction.commit();
        for (const ReadFile &file : files) {
            m_result.read += file.isSame ? 0 : 1;
            if (!file.source.error.isEmpty())
                m_result.unreadable.push_back({file.source.path, file.source.error});
        }
    }

    /// Marks registered files of these folders that no longer exist.
    void markVanished(const Listing &listing) {
        QStringList unreadable;
        for (const UnreadableFolder &folder : listing.unreadable)
            unreadable << folder.path;
        const auto isOfThese = [&](const QString &path) {
            return isBelow(path, m_folders) && !isBelow(path, unreadable);
        };
        std::vector<QString> vanished;
        for (const auto &[path, source] : m_known) {
            if (isOfThese(path) && !std::ranges::binary_search(listing.files, path, {}, &ListedFile::path))
                vanished.push_back(path);
        }
        takeOut(vanished);
        const bool prunes = m_options.prune && m_result.notPruned.isEmpty();
        if (!prunes && !m_register.isMadeAnew())
            return;
        QStringList gone;
        for (const auto &[folder, text] : keptMachineFiles(m_register.database())) {
            if (isOfThese(folder) && !QFileInfo(folder).isDir())
                gone << folder;
        }
        m_writer.takeMachineFiles({}, gone);
    }

    /// Removes what is registered of the folders that are no longer looked at.
    void leaveFolders() {
        if (m_options.left.isEmpty())
            return;
        const auto isLeft = [this](const QString &path) {
            return isBelow(path, m_options.left) && !isBelow(path, m_folders);
        };
        QStringList left;
        for (const auto &[folder, text] : keptMachineFiles(m_register.database())) {
            if (isLeft(folder))
                left << folder;
        }
        Transaction transaction(m_register.database());
        m_writer.begin();
        for (const auto &[path, source] : m_known) {
            if (isLeft(path))
                m_writer.remove(path);
        }
        m_writer.finish();
        transaction.commit();
        m_writer.takeMachineFiles({}, left);
    }

    void takeOut(const std::vector<QString> &vanished) {
        m_result.notFound = static_cast<int>(vanished.size());
        if (vanished.empty())
            return;
        if (m_options.prune && !m_options.force)
            m_result.notPruned = foldersLosingMost(vanished);
        const bool prune = m_options.prune && m_result.notPruned.isEmpty();
        Transaction transaction(m_register.database());
        m_writer.begin();
        for (const QString &path : vanished) {
            if (prune)
                m_writer.remove(path);
            else
                m_writer.setState(path, SourceState::notFound);
        }
        m_writer.finish();
        transaction.commit();
        if (prune) {
            m_result.pruned = m_result.notFound;
            m_result.notFound = 0;
        }
    }

    /// Returns the topmost folders that would lose more than half of their tests. One that has another place
    /// is not lost.
    [[nodiscard]] QStringList foldersLosingMost(const std::vector<QString> &vanished) const {
        std::vector<std::pair<QString, int>> places;
        std::set<int> stay;
        QSqlQuery &query = m_register.database().run(QStringLiteral(
            "select source.path, place.test from source, place where source.id = place.source"));
        while (query.next()) {
            const auto &[path, test] = places.emplace_back(query.value(0).toString(), query.value(1).toInt());
            if (!std::ranges::binary_search(vanished, path))
                stay.insert(test);
        }
        std::map<QString, int> balance; // tests that stay less those that are lost
        for (auto &[folder, test] : places) {
            while (isBelow(folder, m_folders)) {
                folder.truncate(folder.lastIndexOf(u'/'));
                balance[folder] += stay.contains(test) ? 1 : -1;
            }
        }
        QStringList result;
        for (const auto &[folder, tests] : balance) {
            if (tests < 0 && isBelow(folder, m_folders) && !isBelow(folder, result))
                result << folder;
        }
        return result;
    }

    /// One file at a time, as each simulation uses all processors.
    void simulate() {
        std::vector<QString> paths;
        QSqlQuery &query = m_register.database().run(
            QStringLiteral("select distinct source.path from source, place, test where source.id = "
                           "place.source and place.test = test.id and test.awaits = 1 and source.state = "
                           "'read'"));
        while (query.next())
            paths.push_back(query.value(0).toString());
        std::ranges::sort(paths);
        std::erase_if(paths, [this](const QString &path) { return !isBelow(path, m_folders); });
        int done = 0;
        for (const QString &path : paths) {
            if (m_options.stop.stop_requested())
                return;
            simulateFile(path);
            tell(++done, true, static_cast<int>(paths.size()));
        }
    }

    void simulateFile(const QString &path) {
        std::vector<RegisteredTest> tests;
        try {
            auto document = documentIn(readBytes(path));
            if (!document)
                return;
            const auto simulated =
                withSimulations(evaluate(std::make_shared<const Document>(std::move(*document))),
                                SimulateWhich::monteCarloOnly, m_options.jobs, m_options.stop);
            if (!simulated)
                return;
            tests = registeredTests(*simulated, program);
        } catch (const Error &) { // changed since: the next scan reads it again
            return;
        }
        Transaction transaction(m_register.database());
        m_writer.begin();
        for (const RegisteredTest &test : tests)
            m_writer.replaceResults(test.digest, test);
        m_writer.finish();
        transaction.commit();
    }

    Register &m_register;
    RegisterWriter m_writer;
    const ScanOptions &m_options;
    QStringList m_folders;
    std::map<QString, KnownSource> m_known;
    std::vector<ListedFile> m_changed;
    ScanResult m_result;
};

} // namespace

std::optional<Document> documentOfFile(const QString &path) {
    return documentIn(readBytes(path));
}

ScanResult scan(Register &reg, const QStringList &folders, const ScanOptions &options) {
    return Scan(reg, folders, options).run();
}

} // namespace palmer
