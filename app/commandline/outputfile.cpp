// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commandline/outputfile.h"

#include "commandline/optionvalues.h"
#include "commandline/streams.h"
#include "document/savedocument.h"
#include "import/formats.h"
#include "kernel/measurement/testfacts.h"
#include "system/filename.h"
#include "system/files.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <array>
#include <map>
#include <optional>

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

[[noreturn]] void refuseToOverwrite(const QString &file) {
    throw UsageError(
        {REPORT_TEXT("report",
                     "%1 is a file to read and would be lost; choose another name for what is written"),
         {file.toStdString()}});
}

/// Throws UsageError if a file to write is one of those to read.
void requireOther(const QString &file, const QStringList &inputs) {
    for (const QString &input : inputs) {
        if (isSameFile(systemName(file, "/dev/stdout"), systemName(input, "/dev/stdin")))
            refuseToOverwrite(file);
    }
}

} // namespace

bool isStandardOutput(const QString &file) {
    return file == QLatin1StringView("-") || file == QLatin1StringView("/dev/stdout") ||
           isSameFile(file, QStringLiteral("/dev/stdout"));
}

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
    requireOther(file, invocation.arguments + invocation.filesOfOptions);
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

namespace {

/// A value as part of a file name: no separators, no control characters, not hidden; "_" if there is none.
QString namePart(const std::string &value) {
    constexpr qsizetype longest = 80;
    QString part = QString::fromStdString(value).simplified().left(longest);
    std::ranges::replace_if(
        part, [](QChar c) { return !c.isPrint() || QStringLiteral("/\\:*?\"<>|").contains(c); }, u'_');
    return part.isEmpty() || part.startsWith(u'.') ? u'_' + part : part;
}

/// Words of --name and their values for a document.
struct NameWord {
    const char *word;
    std::string (*value)(const Document &);
};

constexpr std::array nameWords{
    NameWord{"machine", [](const Document &d) { return d.machine.name; }},
    NameWord{"serialNumber", [](const Document &d) { return d.machine.serialNumber; }},
    NameWord{"number", [](const Document &d) { return d.report.number; }},
    NameWord{"axis",
             [](const Document &d) {
                 std::string axes;
                 for (const TestPointer &test : d.tests) {
                     if (const std::string one = axesOf(*test); axes.find(one) == std::string::npos)
                         axes += one;
                 }
                 return axes;
             }},
    NameWord{"date",
             [](const Document &d) {
                 std::string newest;
                 for (const TestPointer &test : d.tests)
                     newest = std::max(newest, test->date.value_or(""));
                 return newest.empty() ? d.report.date.value_or("") : newest;
             }},
};

/// The name that --name gives the output of an input. A file that cannot be read keeps its own.
QString namedBy(const QString &pattern, const Input &input, const QString &own,
                const Invocation &invocation) {
    std::optional<Document> document;
    try {
        if (QFileInfo(ReachableFile(input.file).name()).isFile()) // a pipe is read once
            document = documentFrom(input.file, invocation, Say::nothing);
    } catch (const Error &) {
        return own;
    } catch (const UsageError &) {
        return own;
    }
    QString name = pattern;
    for (const NameWord &row : nameWords)
        name.replace(u'{' + QLatin1StringView(row.word) + u'}',
                     namePart(document ? row.value(*document) : std::string()));
    return name.replace(QStringLiteral("{file}"), own);
}

void requirePattern(const QString &pattern) {
    QString rest = pattern;
    QStringList known{QStringLiteral("{file}")};
    for (const NameWord &row : nameWords)
        known << u'{' + QLatin1StringView(row.word) + u'}';
    for (const QString &word : known)
        rest.remove(word);
    if (rest == pattern || rest.contains(u'{') || rest.contains(u'}'))
        refuse(nameOption.name, pattern, known.join(QStringLiteral(", ")).toStdString());
    const QString name = QDir::fromNativeSeparators(pattern);
    if (QDir::isAbsolutePath(name) || name.split(u'/').contains(QStringLiteral("..")))
        throw UsageError({REPORT_TEXT("report", "--name %1 leads out of the folder that -o names"),
                          {pattern.toStdString()}});
}

} // namespace

void requireNoName(const Invocation &invocation) {
    if (invocation.has(nameOption.name))
        refuseEffect("--name", "FOLDER, FILE FILE…");
}

QStringList outputsInFolder(const Invocation &invocation, const QString &output, const Inputs &inputs,
                            const QString &ending) {
    const auto pattern = invocation.value(nameOption.name);
    if (pattern)
        requirePattern(*pattern);
    QStringList result;
    std::map<QString, QString> inputOf;
    for (const Input &input : inputs.list) {
        const QFileInfo below(input.file == QLatin1StringView("-") ? QStringLiteral("report") : input.below);
        const QString folder = below.path() == QLatin1StringView(".") ? QString() : below.path() + u'/';
        const QString base = below.completeBaseName();
        const QString name = pattern ? namedBy(*pattern, input, base, invocation) : base;
        QString file = QDir(output).filePath(folder + name + ending);
        for (int next = 2; pattern && inputOf.contains(file); ++next)
            file = QDir(output).filePath(folder + name + u'-' + QString::number(next) + ending);
        const auto [other, isNew] = inputOf.emplace(file, input.shown);
        if (!isNew)
            throw UsageError(
                {REPORT_TEXT("report", "%1 and %2 would both be written as %3; call the command for each"),
                 {other->second.toStdString(), input.shown.toStdString(), file.toStdString()}});
        result << file;
    }
    QStringList read = invocation.filesOfOptions;
    for (const Input &input : inputs.list)
        read << input.file;
    for (const QString &file : result)
        requireOther(file, read);
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
    } catch (const Error &error) {
        printError(outputs.front().path, error, invocation.language);
        return cannotRead;
    }
}

} // namespace palmer
