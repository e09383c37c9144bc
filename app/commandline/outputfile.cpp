// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commandline/outputfile.h"

#include "commandline/streams.h"
#include "document/savedocument.h"
#include "import/formats.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <map>

namespace palmer {

namespace {

/// True for endings with a meaning: of formats of this program, and common ones.
bool isKnown(const QString &ending) {
    static const QStringList known =
        importEndings() +
        QString::fromLatin1("palmer palmer-template recovery pdf svg png json comp xls b5r64 "
                            "nc ngc mpf spf h iso cnc tap ini hal xml html htm md rtf doc "
                            "docx odt ppt pptx odp jpg jpeg gif bmp tif tiff webp eps ps "
                            "zip gz 7z tar exe sh py yaml yml toml")
            .split(u' ');
    return known.contains(ending);
}

/// Name of the file for the system.
QString systemName(const QString &file, const char *standard) {
    return file == QLatin1StringView("-") ? QLatin1StringView(standard) : file;
}

bool isStandardOutput(const QString &file) {
    return file == QLatin1StringView("-") || file == QLatin1StringView("/dev/stdout") ||
           isSameFile(file, QStringLiteral("/dev/stdout"));
}

[[noreturn]] void refuseToOverwrite(const QString &file) {
    throw UsageError(
        {REPORT_TEXT("report",
                     "%1 is a file to read and would be lost; choose another name for what is written"),
         {file.toStdString()}});
}

} // namespace

void refuseWithoutOutput(const char *command, const std::string &form) {
    throw UsageError(
        {REPORT_TEXT("report", "the command %1 needs a file to write (%2)"), {std::string(command), form}});
}

QString neededOutput(const Invocation &invocation, const char *command, const std::string &form) {
    const auto output = invocation.value("o");
    if (!output)
        refuseWithoutOutput(command, form);
    return *output;
}

void requireOutput(const Invocation &invocation, const QString &file,
                   std::initializer_list<const char *> endings) {
    QStringList inputs = invocation.arguments;
    if (const auto compared = invocation.value("compare"))
        inputs.append(*compared);
    for (const QString &input : inputs) {
        if (isSameFile(systemName(file, "/dev/stdout"), systemName(input, "/dev/stdin")))
            refuseToOverwrite(file);
    }
    const QString ending = QFileInfo(file).suffix().toLower();
    const bool isOwn =
        std::ranges::any_of(endings, [&](const char *own) { return ending == QLatin1StringView(own); });
    if (isOwn || invocation.has(forceOption.name) || !isKnown(ending))
        return;
    std::string expected;
    for (const char *own : endings)
        expected += (expected.empty() ? "." : ", .") + std::string(own);
    throw UsageError({REPORT_TEXT("report", "%1 has the ending of another kind of file; expected %2 (--force "
                                            "writes it all the same)"),
                      {file.toStdString(), expected}});
}

QStringList outputsInFolder(const QString &output, const Inputs &inputs, const QString &ending) {
    QStringList result;
    std::map<QString, QString> inputOf;
    for (const Input &input : inputs.list) {
        const QFileInfo below(input.file == QLatin1StringView("-") ? QStringLiteral("report") : input.below);
        const QString folder = below.path() == QLatin1StringView(".") ? QString() : below.path() + u'/';
        const QString file = QDir(output).filePath(folder + below.completeBaseName() + ending);
        const auto [other, isNew] = inputOf.emplace(file, input.shown);
        if (!isNew)
            throw UsageError(
                {REPORT_TEXT("report", "%1 and %2 would both be written as %3; call the command for each"),
                 {other->second.toStdString(), input.shown.toStdString(), file.toStdString()}});
        result << file;
    }
    for (const QString &file : result) {
        if (std::ranges::any_of(inputs.list,
                                [&](const Input &input) { return isSameFile(file, input.file); }))
            refuseToOverwrite(file);
    }
    return result;
}

QString withLanguage(const QString &file, const QString &language) {
    const QFileInfo there(file);
    if (file.endsWith(u'/') || (there.exists() && !there.isFile()))
        return file;
    const QString ending = QStringLiteral(".pdf");
    const bool has = file.endsWith(ending, Qt::CaseInsensitive);
    return (has ? file.chopped(ending.size()) : file) + u'.' + language + (has ? file.right(4) : ending);
}

void makeFolderOf(const QString &file) {
    const QString folder = QFileInfo(file).path();
    if (!QDir().mkpath(folder))
        throw Error(Error::Kind::unwritable,
                    {REPORT_TEXT("report", "the folder %1 cannot be made"), {folder.toStdString()}, {}});
}

void writeOutput(const QByteArray &bytes, const QString &file) {
    writeOutputs({{bytes, file}});
}

void writeOutputs(const std::vector<FileToSave> &outputs) {
    std::vector<FileToSave> files;
    std::ranges::copy_if(outputs, std::back_inserter(files),
                         [](const FileToSave &output) { return !isStandardOutput(output.path); });
    saveFiles(files, UnreadPipe::awaited);
    for (const FileToSave &output : outputs) {
        if (isStandardOutput(output.path))
            printOut(output.bytes);
    }
}

int written(const Invocation &invocation, const std::vector<FileToSave> &outputs) {
    try {
        writeOutputs(outputs);
        return done;
    } catch (const UnsavedFile &error) {
        printError(error.path, error, invocation.language);
    } catch (const Error &error) { // standard output
        printError(outputs.front().path, error, invocation.language);
    }
    return cannotRead;
}

} // namespace palmer
