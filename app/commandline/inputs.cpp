// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commandline/inputs.h"

#include "commandline/optionvalues.h"
#include "commandline/preparation.h"
#include "commandline/streams.h"
#include "document/filename.h"
#include "proof/readreportpdf.h"

#include <QFileInfo>
#include <algorithm>
#include <filesystem>
#include <iterator>
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
    FolderWalk(const QString &folder, InFolders which)
        : m_folder(folder)
        , m_which(which) {
        walk(fs::path(nativeFileName(folder).toStdString()), {});
        std::ranges::sort(m_found, {}, &Input::file);
    }

    [[nodiscard]] std::vector<Input> &found() { return m_found; }
    [[nodiscard]] const QStringList &unreadable() const { return m_unreadable; }

private:
    /// `below`: path relative to the first folder, with a trailing slash.
    void walk(const fs::path &folder, const QString &below) {
        std::error_code error;
        fs::directory_iterator entries(folder, error);
        if (error)
            m_unreadable << nameOf(below);
        for (; !error && entries != fs::directory_iterator(); entries.increment(error)) {
            const QString name = below + fileNameOf(entries->path().filename().native());
            std::error_code ignored;
            if (entries->path().filename().native().starts_with('.'))
                continue;
            if (entries->is_directory(ignored) && !entries->is_symlink(ignored))
                walk(entries->path(), name + u'/');
            else if (isWanted(name) && entries->is_regular_file(ignored))
                m_found.push_back({nameOf(name), shownFileName(nameOf(name)), shownFileName(name), true});
        }
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
        FolderWalk walk(argument, which);
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
        return work(input, documentFrom(input.file, invocation));
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
