// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/commands.h"

#include "commandline/optionvalues.h"
#include "commandline/outputfile.h"
#include "commandline/preparation.h"
#include "commandline/streams.h"
#include "document/savedocument.h"
#include "document/sha256.h"
#include "export/answersjson.h"
#include "import/importmeasurement.h"
#include "kernel/numerics/runinbackground.h"
#include "system/filename.h"
#include "system/memory.h"

#include <QFileInfo>
#include <algorithm>
#include <array>
#include <future>

namespace palmer {

namespace {

constexpr auto importOptions = optionList(
    Option{"o", "OUT.palmer", REPORT_TEXT("report", "the test file to write")}, foreignOptions,
    preparationOptions[0],
    Option{"json", "", REPORT_TEXT("report", "choices, remarks and questions as JSON on standard output")},
    Option{"keep-original", "", REPORT_TEXT("report", "keep the bytes of the files in the test file")},
    forceOption);

/// Hash of the bytes: of a long file computed in the background, otherwise on request.
std::future<std::string> hashOf(const QByteArray &bytes) {
    constexpr qsizetype isLong = 1 << 20;
    return runInBackground(bytes.size() > isLong, [bytes] { return sha256(bytes); });
}

/// Called before a long file is read: bytes, text, cells, readings and JSON follow one another.
void keepMemory(qint64 fileSize) {
    constexpr qint64 isLong = 4 << 20;
    constexpr qint64 mostAtOnce = 256 << 20;
    if (fileSize >= isLong)
        keepFreedMemory(static_cast<std::size_t>(std::min(8 * fileSize, mostAtOnce)));
}

/// Temperatures belong to the tests of the other files in any order.
bool needsTest(const Imported &imported) {
    return !imported.test;
}

int runImport(const Invocation &invocation) {
    const QString output = neededOutput(invocation, "import", "-o OUT.palmer");
    requireOutput(invocation, output, {"palmer", "json"}); // test files are JSON
    const bool asJson = invocation.has("json");
    if (asJson && output == QLatin1StringView("-"))
        refuse("json", output, "-o OUT.palmer");
    const ImportOptions chosen = chosenOptions(invocation);
    const bool keep = invocation.has("keep-original");
    if (!canReadTemplates(invocation))
        return cannotRead;
    struct Read {
        QString file;
        QByteArray bytes;
        std::future<std::string> hash;
        Imported imported;
    };
    std::vector<Read> files;
    std::vector<ImportAnswer> answers;
    int code = done;
    for (const QString &file : invocation.arguments) {
        const auto read = [&]() -> int {
            keepMemory(QFileInfo(file).size());
            const QByteArray bytes = bytesFrom(file);
            std::future<std::string> hash = hashOf(bytes);
            Imported imported = importedFrom(bytes, file, chosen, invocation);
            if (asJson)
                answers.push_back({shownFileName(file), imported, invocation.has("accept")});
            requireAnswers(imported, invocation);
            files.push_back({file, bytes, std::move(hash), std::move(imported)});
            return done;
        };
        code = worse(code, codeOf(file, invocation.language, read));
    }
    const auto answer = [&](int ended) {
        if (asJson)
            printOut(importJson(answers, ended == done ? shownFileName(output) : QString(),
                                namesLanguage(invocation)));
        return ended;
    };
    if (code != done)
        return answer(code); // nothing incomplete is written
    std::vector<std::string> without = files.empty()
                                           ? std::vector<std::string>() // for all files
                                           : choicesWithoutEffect(files.front().imported, invocation);
    for (const Read &read : files) {
        const std::vector<std::string> more = choicesWithoutEffect(read.imported, invocation);
        std::erase_if(without,
                      [&](const std::string &key) { return std::ranges::find(more, key) == more.end(); });
    }
    if (!without.empty())
        refuseChoice(without.front());
    std::ranges::stable_sort(files, {}, [](const Read &read) { return needsTest(read.imported); });
    Document document;
    for (Read &read : files) {
        const auto add = [&]() -> int {
            if (areOtherMachines(document.machine, read.imported.machine))
                throw Error(
                    Error::Kind::content,
                    {REPORT_TEXT("report", "it names another machine than the files before it; import the "
                                           "files of each machine into a file of their own"),
                     {}});
            addImported(document, std::move(read.imported), read.bytes, read.file, keep, read.hash.get());
            return done;
        };
        if (codeOf(read.file, invocation.language, add) != done)
            return answer(cannotRead);
    }
    return answer(codeOf(output, invocation.language, [&]() -> int {
        writeOutput(bytesToSave(prepared(std::move(document), output, invocation)), output);
        return done;
    }));
}

} // namespace

Command importCommand() {
    return {"import", "DATA…",
            REPORT_TEXT("report", "files of instruments and tables into a test file; remarks on stderr"),
            importOptions, runImport};
}

} // namespace palmer
