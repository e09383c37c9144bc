#include "commands/inputs.h"

#include "commands/optionvalues.h"
#include "commands/streams.h"
#include "proof/readreportpdf.h"

#include <QDir>
#include <QDirIterator>
#include <QFileInfo>
#include <algorithm>

namespace palmer {

namespace {

constexpr const char *jobsName = jobsOption.name;
constexpr int mostJobs = 256;

/// Null: of another program, to be passed over.
std::optional<Document> documentOf(const Input &input, const Invocation &invocation, bool &isForeign) {
    if (input.found && input.file.endsWith(QLatin1StringView(".pdf"), Qt::CaseInsensitive) &&
        isForeignPdf(bytesFrom(input.file))) {
        isForeign = true;
        return {};
    }
    return documentFrom(input.file, invocation);
}

} // namespace

Inputs inputsOf(const Invocation &invocation) {
    Inputs result;
    result.several = invocation.arguments.size() > 1;
    for (const QString &argument : invocation.arguments) {
        if (argument == QLatin1StringView("-") || !QFileInfo(argument).isDir()) {
            result.list.push_back({argument, QFileInfo(argument).fileName(), false});
            continue;
        }
        result.several = true;
        QStringList found;
        QDirIterator walk(argument, {QStringLiteral("*.palmer"), QStringLiteral("*.pdf")}, QDir::Files,
                          QDirIterator::Subdirectories);
        while (walk.hasNext())
            found << walk.next();
        found.sort();
        const QDir folder(argument);
        for (const QString &file : found)
            result.list.push_back({file, folder.relativeFilePath(QFileInfo(file).absoluteFilePath()), true});
        if (!found.isEmpty())
            continue;
        result.code = cannotRead;
        printError(argument,
                   Error(Error::Kind::unreadable,
                         {folder.isReadable()
                              ? REPORT_TEXT("report", "there is no test file or report in the folder")
                              : REPORT_TEXT("report", "the folder cannot be read"),
                          {},
                          {}}),
                   invocation.language);
    }
    return result;
}

int eachDocument(const Invocation &invocation, const Inputs &inputs,
                 const std::function<JobResult(const Input &, Document)> &work, Between between,
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
            bool isForeign = false;
            std::optional<Document> document = documentOf(input, invocation, isForeign);
            if (!document) // or questions about it are open
                return {isForeign ? done : cannotRead, {}};
            return work(input, std::move(*document));
        } catch (const Error &error) {
            printError(input.file, error, invocation.language);
        } catch (const UsageError &error) { // that only shows with the file: --set, --template
            printError(input.file + QStringLiteral(": ") + invocation.language.sentence(error.message));
            return {wrongUsage, {}};
        } catch (const std::bad_alloc &) {
            printError(input.file, notEnoughMemory(), invocation.language);
        }
        return {cannotRead, {}};
    };
    jobs.broken = [&](int i) {
        printError(
            inputAt(i).file,
            Error(Error::Kind::unreadable,
                  {REPORT_TEXT("report",
                               "the work on this file broke off, perhaps for want of memory; try it alone"),
                   {},
                   {}}),
            invocation.language);
        return cannotRead;
    };
    jobs.heard = [&](int, const JobResult &result) {
        code = worse(code, result.code);
        if (heard)
            heard(result);
    };
    eachJob(static_cast<int>(inputs.list.size()), jobsOf(invocation), jobs);
    return code;
}

int jobsOf(const Invocation &invocation) {
    const auto given = invocation.value(QLatin1StringView(jobsName));
    if (!given)
        return defaultJobs();
    bool isNumber = false;
    const int jobs = given->toInt(&isNumber);
    if (!isNumber || jobs < 1)
        refuse(jobsName, *given);
    return std::min(jobs, mostJobs);
}

} // namespace palmer
