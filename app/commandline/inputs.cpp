// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commandline/inputs.h"

#include "commandline/optionvalues.h"
#include "commandline/preparation.h"
#include "commandline/streams.h"
#include "document/readdocument.h"
#include "proof/readreportpdf.h"
#include "report/attachedfile.h"
#include "system/filename.h"

#include <QFileInfo>
#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <system_error>

namespace palmer {

namespace {

constexpr const char *jobsName = jobsOption.name;
constexpr int mostJobs = 256;

namespace fs = std::filesystem;

bool hasEnding(const QString &name, const char *ending) {
    return name.endsWith(QLatin1StringView(ending), Qt::CaseInsensitive);
}

/// Finds the files in a folder, recursively, except hidden ones.
class FolderWalk {
public:
    FolderWalk(const QString &folder, InFolders which, const QString &output)
        : m_folder(folder)
        , m_which(which) {
        if (!output.isEmpty())
            m_output = realPath(pathOf(output));
        walk(pathOf(folder), {});
        std::ranges::sort(m_found, {}, &Input::file);
        if (which == InFolders::testFilesAndReports)
            putBeside();
    }

    [[nodiscard]] std::vector<Input> &found() { return m_found; }
    [[nodiscard]] const QStringList &unreadable() const { return m_unreadable; }

private:
    static fs::path realPath(const fs::path &path) {
        std::error_code error;
        const fs::path real = fs::weakly_canonical(fs::absolute(path, error), error);
        return real.has_filename() ? real : real.parent_path();
    }

    /// `below`: path relative to the first folder, with a trailing slash.
    void walk(const fs::path &folder, const QString &below) {
        std::error_code error;
        const fs::path real = realPath(folder);
        if (!m_seen.insert(real).second) // reached through another link
            return;
        const bool isOutput =
            !m_output.empty() && std::ranges::mismatch(m_output, real).in1 == m_output.end();
        fs::directory_iterator entries(folder, error);
        if (error)
            m_unreadable << nameOf(below);
        for (; !error && entries != fs::directory_iterator(); entries.increment(error)) {
            const QString own = fileNameOf(entries->path().filename());
            const QString name = below + own;
            std::error_code ignored;
            if (own.startsWith(u'.'))
                continue;
            if (entries->is_directory(ignored))
                walk(entries->path(), name + u'/');
            else if (isWanted(name) && !(isOutput && hasEnding(name, ".pdf")) && entries->exists(ignored))
                m_found.push_back({nameOf(name), shownFileName(nameOf(name)), shownFileName(name), true});
        }
    }

    /// Takes reports out of the list that stand next to a test file of their name.
    void putBeside() {
        std::map<QString, Input *> testFiles;
        for (Input &input : m_found) {
            if (!hasEnding(input.file, ".pdf"))
                testFiles.emplace(input.file.chopped(QLatin1StringView(".palmer").size()), &input);
        }
        std::vector<QString> taken;
        for (const Input &input : m_found) {
            if (!hasEnding(input.file, ".pdf"))
                continue;
            QString name = input.file.chopped(QLatin1StringView(".pdf").size());
            if (!testFiles.contains(name) && (hasEnding(name, ".fr") || hasEnding(name, ".en")))
                name.chop(3);
            const auto own = testFiles.find(name);
            if (own == testFiles.end())
                continue;
            own->second->beside << input.file;
            taken.push_back(input.file);
        }
        std::erase_if(m_found,
                      [&](const Input &input) { return std::ranges::binary_search(taken, input.file); });
    }

    [[nodiscard]] QString nameOf(const QString &below) const {
        return m_folder.endsWith(u'/') || below.isEmpty() ? m_folder + below : m_folder + u'/' + below;
    }

    [[nodiscard]] bool isWanted(const QString &name) const {
        return hasEnding(name, ".pdf") ||
               (m_which == InFolders::testFilesAndReports && hasEnding(name, ".palmer"));
    }

    QString m_folder;
    InFolders m_which;
    fs::path m_output; ///< folder of -o
    std::set<fs::path> m_seen;
    std::vector<Input> m_found;
    QStringList m_unreadable;
};

Error unreadable(const Text &text) {
    return Error(Error::Kind::unreadable, {text, {}, {}});
}

} // namespace

Inputs inputsOf(const Invocation &invocation, InFolders which) {
    Inputs result;
    result.several = invocation.arguments.size() > 1;
    for (const QString &argument : invocation.arguments) {
        const ReachableFile there(argument);
        if (argument == QLatin1StringView("-") || !QFileInfo(there.name()).isDir()) {
            const QString shown = shownFileName(argument);
            result.list.push_back({argument, shown, QFileInfo(shown).fileName(), false});
            continue;
        }
        result.several = true;
        FolderWalk walk(argument, which, invocation.value("o").value_or(QString()));
        for (const QString &folder : walk.unreadable())
            fail(invocation, folder, unreadable(REPORT_TEXT("report", "the folder cannot be read")));
        if (walk.found().empty() && walk.unreadable().isEmpty())
            fail(invocation, argument,
                 unreadable(which == InFolders::reports
                                ? REPORT_TEXT("report", "there is no report in the folder")
                                : REPORT_TEXT("report", "there is no test file or report in the folder")));
        if (walk.found().empty() || !walk.unreadable().isEmpty())
            result.code = cannotRead;
        std::ranges::move(walk.found(), std::back_inserter(result.list));
    }
    return result;
}

bool isOneFile(const Invocation &invocation) {
    return invocation.arguments.size() == 1 &&
           !QFileInfo(ReachableFile(invocation.arguments.front()).name()).isDir();
}

bool isToBePassedOver(const Input &input) {
    return input.found && hasEnding(input.file, ".pdf") && isForeignPdf(bytesFrom(input.file));
}

namespace {

/// Says which reports next to a test file were made from another state of it.
void sayOtherStates(const Input &input, const Invocation &invocation) {
    std::optional<Document> document;
    for (const QString &report : input.beside) {
        try {
            const QByteArray attached = readReportPdf(bytesFrom(report)).testFile;
            if (!document)
                document = readDocument(bytesFrom(input.file));
            const QByteArray own = attachedFile(*document);
            if (attached != own && attached != attachedFile(*document, Originals::include))
                printError(
                    report + QStringLiteral(": ") +
                    invocation.language.sentence(
                        {REPORT_TEXT("report", "this report was made from another state of the test file "
                                               "next to it: fingerprint %1, now %2"),
                         {shortFingerprint(fingerprint(attached)).toStdString(),
                          shortFingerprint(fingerprint(own)).toStdString()}}));
        } catch (const Error &) { // no report of this program, or damaged: it is no input
            continue;
        }
    }
}

} // namespace

int eachInput(const Invocation &invocation, const Inputs &inputs,
              const std::function<JobResult(const Input &)> &work, Between between,
              const std::function<void(const JobResult &)> &heard) {
    int code = inputs.code;
    if (inputs.list.empty())
        return code;
    const auto inputAt = [&](int i) -> const Input & { return inputs.list[static_cast<std::size_t>(i)]; };
    Jobs jobs;
    jobs.parted = between == Between::emptyLine;
    jobs.work = [&](int i) -> JobResult {
        const Input &input = inputAt(i);
        try {
            return work(input);
        } catch (const Error &error) {
            return {fail(invocation, input.file, error), {}};
        } catch (const UsageError &error) { // only detected with the file: --set
            return {fail(invocation, input.file, invocation.language.sentence(error.message), wrongUsage),
                    {}};
        } catch (const std::bad_alloc &) {
            return {fail(invocation, input.file, notEnoughMemory()), {}};
        }
    };
    jobs.broken = [&](int i) {
        return fail(
            invocation, inputAt(i).file,
            unreadable(REPORT_TEXT(
                "report", "the work on this file broke off, perhaps for want of memory; try it alone")));
    };
    jobs.heard = [&](int, const JobResult &result) {
        code = worse(code, result.code);
        if (heard)
            heard(result);
    };
    eachJob(static_cast<int>(inputs.list.size()), jobsOf(invocation), jobs);
    return code;
}

int eachDocument(const Invocation &invocation, const Inputs &inputs,
                 const std::function<JobResult(const Input &, Document)> &work, Between between,
                 const std::function<void(const JobResult &)> &heard) {
    if (!canReadTemplates(invocation))
        return cannotRead;
    const auto onDocument = [&](const Input &input) -> JobResult {
        if (isToBePassedOver(input))
            return {done, {}};
        Document document = documentFrom(input.file, invocation);
        sayOtherStates(input, invocation);
        return work(input, std::move(document));
    };
    return eachInput(invocation, inputs, onDocument, between, heard);
}

int jobsOf(const Invocation &invocation) {
    const auto given = invocation.value(jobsName);
    if (!given)
        return defaultJobs();
    constexpr long long most = 1'000'000; // more than are ever started
    return std::min(static_cast<int>(wholeBetween(jobsName, *given, 1, most)), mostJobs);
}

} // namespace palmer
