// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commandline/streams.h"

#include "commandline/optionvalues.h"
#include "commandline/preparation.h"
#include "document/place.h"
#include "document/readdocument.h"
#include "document/savedocument.h"
#include "document/savefiles.h"
#include "document/setfield.h"
#include "document/testfile.h"
#include "export/answersjson.h"
#include "import/importmeasurement.h"
#include "import/profiles.h"
#include "language/visibletext.h"
#include "proof/readreportpdf.h"
#include "system/filename.h"
#include "system/streams.h"

#include <QFile>
#include <algorithm>
#include <cstdio>

namespace palmer {

namespace {

constexpr qint64 blockSize = qint64(1) << 20;

/// Reads to the end what has no size: standard input, a pipe.
QByteArray readStream(int descriptor, QFileDevice::FileHandleFlag handle, QByteArray bytes = {}) {
    QFile input;
    const auto require = [&input](bool readable) {
        if (!readable)
            throw Error(Error::Kind::unreadable, {REPORT_TEXT("report", "the file cannot be read (%1)"),
                                                  {input.errorString().toStdString()}});
    };
    require(input.open(descriptor, QIODevice::ReadOnly, handle));
    for (QByteArray block = input.read(blockSize); !block.isEmpty(); block = input.read(blockSize)) {
        bytes += block;
        requireReadable(bytes.size());
    }
    require(input.error() == QFileDevice::NoError);
    return bytes;
}

QString oneLine(QString text) {
    std::ranges::replace_if(
        text, [](QChar c) { return c == u'\n' || c == u'\r' || c == QChar::LineSeparator; }, u' ');
    return visibleText(text);
}

} // namespace

void printOut(const QByteArray &bytes) {
    const auto size = static_cast<std::size_t>(bytes.size());
    if (std::fwrite(bytes.constData(), 1, size, stdout) != size || std::fflush(stdout) != 0)
        throw Error(Error::Kind::unwritable,
                    {REPORT_TEXT("report", "standard output cannot be written"), {}});
}

void printOut(const QString &text) {
    printOut(visibleText(text).toUtf8());
}

std::optional<JsonForm> jsonForm(const Invocation &invocation, bool several) {
    if (invocation.has(jsonLinesOption.name))
        return JsonForm::oneLine;
    if (!invocation.has("json"))
        return {};
    return several ? JsonForm::oneLine : JsonForm::pretty;
}

Language namesLanguage(const Invocation &invocation) {
    return invocation.languageChosen ? invocation.language : Language(Language::Id::english);
}

Error notEnoughMemory() {
    return Error(Error::Kind::tooLarge, {REPORT_TEXT("report", "not enough memory for this"), {}, {}});
}

void printError(const QString &text) {
    QString shown = QStringLiteral("palmer-cli: ") + oneLine(shownFileName(text));
    constexpr qsizetype longest = 500;
    constexpr qsizetype end = 150; // what to do about it
    if (shown.size() > longest)
        shown = shown.left(longest - end - 3) + QStringLiteral(" … ") + shown.right(end);
    const QByteArray line = (shown + u'\n').toUtf8();
    std::fwrite(line.constData(), 1, static_cast<std::size_t>(line.size()), stderr);
}

namespace {

QString textOf(const Error &error, const Language &language) {
    return (error.place.empty() ? QString() : QString::fromStdString(error.place) + QStringLiteral(": ")) +
           language.sentence(error.message);
}

} // namespace

void printError(const QString &file, const Error &error, const Language &language) {
    const auto *unsaved = dynamic_cast<const UnsavedFile *>(&error); // not what was read
    printError((unsaved ? unsaved->path : file) + QStringLiteral(": ") + textOf(error, language));
}

int fail(const Invocation &invocation, const QString &file, const QString &text, ExitCode code) {
    printError(file + QStringLiteral(": ") + text);
    if (invocation.has(jsonLinesOption.name))
        printOut(errorJson(shownFileName(file), text, code));
    return code;
}

int fail(const Invocation &invocation, const QString &file, const Error &error) {
    return fail(invocation, file, textOf(error, invocation.language), cannotRead);
}

namespace {

/// `FILE: line:column: `.
QString placeOf(const QString &file, std::size_t line, std::size_t column) {
    QString text = file + QStringLiteral(": ");
    if (line > 0) {
        text += QString::number(line);
        if (column > 0)
            text += u':' + QString::number(column);
        text += QStringLiteral(": ");
    }
    return text;
}

QString timesOf(std::size_t times) {
    return times > 1 ? QStringLiteral(" (× %1)").arg(times) : QString();
}

std::string headingsOf(const std::vector<ImportColumn> &columns, const Language &language) {
    std::string list;
    for (std::size_t c = 0; c < columns.size(); ++c)
        list +=
            (c > 0 ? ", " : "") + std::to_string(c + 1) +
            (columns[c].heading.empty() ? std::string()
                                        : ' ' + language.quoted(excerpt(columns[c].heading)).toStdString());
    return list;
}

void printQuestion(const QString &file, const Question &question, const Language &language) {
    QString text = placeOf(file, question.line, question.column) + language.sentence(question.sentence) +
                   timesOf(question.further.size() + 1);
    std::string answers;
    for (const std::string &answer : answersOf(question))
        answers += (answers.empty() ? "" : ", ") + answer;
    if (!question.proposal.empty() && !question.canBeAssumed()) {
        text += u' ' + language.sentence({REPORT_TEXT("report", "Doubtful; where what was read is right: "
                                                                "--set %1."),
                                          {question.id + "=keep"}});
    } else if (!question.proposal.empty()) {
        const std::string setting = question.id + '=' + question.proposal;
        const bool hasBlank = setting.find(' ') != std::string::npos; // quoted for the shell
        text += u' ' + language.sentence({REPORT_TEXT("report", "Proposed: --set %1."),
                                          {hasBlank ? '"' + setting + '"' : setting}});
    }
    if (!answers.empty())
        text += u' ' + language.sentence(
                           {REPORT_TEXT("report", "Answers for --set %1=…: %2."), {question.id, answers}});
    else if (question.proposal.empty())
        text += u' ' + language.sentence({REPORT_TEXT("report", "Answer with --set %1=…."), {question.id}});
    printError(text);
}

} // namespace

void printRemarks(const QString &file, const std::vector<Remark> &remarks, const Language &language) {
    for (const Remark &remark : remarks)
        printError(placeOf(file, remark.line, remark.column) + language.sentence(remark.message) +
                   timesOf(remark.times));
}

namespace {

/// Says which edition the program took for a file that names none.
void printDefaults(const QString &file, const std::vector<ImportChoice> &choices, const Language &language) {
    const auto edition = std::ranges::find(choices, std::string("edition"), &ImportChoice::key);
    if (edition != choices.end() && edition->origin == Origin::guessed)
        printError(
            placeOf(file, 0, 0) +
            language.sentence({REPORT_TEXT("report", "Edition: nothing in the file says it; %1 is taken."),
                               {Designation{edition->value}}}));
}

} // namespace

QString profilesFile(const QString & /*name*/) {
    return importProfilesPath();
}

ImportOptions chosenOptions(const Invocation &invocation) {
    ImportOptions chosen;
    if (const auto profile = invocation.value("profile")) {
        const ImportProfiles profiles = readImportProfiles(importProfilesPath());
        const auto found = profiles.find(profile->toStdString());
        if (found == profiles.end()) {
            std::string known;
            for (const auto &[name, words] : profiles)
                known += (known.empty() ? "" : ", ") + name;
            throw known.empty() ? UsageError({REPORT_TEXT("report", "unknown profile %1: none is kept here"),
                                              {profile->toStdString()}})
                                : UsageError({REPORT_TEXT("report", "unknown profile %1; known: %2"),
                                              {profile->toStdString(), known}});
        }
        chosen = found->second;
    }
    for (const QString &setting : invocation.values("set")) {
        const qsizetype mark = setting.indexOf(u'=');
        if (mark < 1)
            throw UsageError(
                {REPORT_TEXT("report", "“%1” is no choice; expected key=value"), {setting.toStdString()}});
        const std::string key = setting.left(mark).toStdString();
        const ImportKey *known = findImportKey(key);
        if (known && known->value == ImportValue::number)
            requireClearComma("--set " + key, setting.mid(mark + 1));
        if (known || !beginsAsField(key)) // otherwise it is a path of the test file
            chosen[setting.left(mark).toStdString()] = setting.mid(mark + 1).toStdString();
    }
    try {
        requireKnown(chosen);
    } catch (const Error &error) {
        throw UsageError(error.message);
    }
    return chosen;
}

Imported importedFrom(QByteArrayView bytes, const QString &file, const ImportOptions &options,
                      const Invocation &invocation) {
    Imported imported = showMeasurement(bytes, file, options);
    if (imported.refusal) {
        if (!imported.columns.empty())
            printError(file + QStringLiteral(": ") +
                       invocation.language.sentence(
                           {REPORT_TEXT("report", "Columns: %1. Roles as read: --set columns=%2; known: %3."),
                            {headingsOf(imported.columns, invocation.language), wordOf(imported.columns),
                             roleWords()}}));
        throw Error(*imported.refusal);
    }
    printRemarks(file, imported.remarks, invocation.language);
    printDefaults(file, imported.choices, invocation.language);
    for (const Question &question : imported.questions) {
        if (!invocation.has("accept") || !question.canBeAssumed())
            printQuestion(file, question, invocation.language);
        else
            printError(placeOf(file, question.line, question.column) +
                       invocation.language.sentence(question.sentence) +
                       timesOf(question.further.size() + 1));
    }
    return imported;
}

void requireAnswers(const Imported &imported, const Invocation &invocation) {
    const auto assumed = std::ranges::count_if(imported.questions, &Question::canBeAssumed);
    const bool accepts = invocation.has("accept");
    const auto open = static_cast<std::ptrdiff_t>(imported.questions.size()) - (accepts ? assumed : 0);
    if (open == 0)
        return;
    throw Error(Error::Kind::content,
                {!accepts && assumed > 0
                     ? REPORT_TEXT_COUNTED(
                           "report", "%n question(s) are open: nothing was imported; answer with --set, "
                                     "or take what is assumed with --accept")
                     : REPORT_TEXT_COUNTED(
                           "report", "%n question(s) are open: nothing was imported; each wants its own "
                                     "answer with --set"),
                 {},
                 static_cast<int>(open)});
}

std::vector<std::string> choicesWithoutEffect(const Imported &imported, const Invocation &invocation) {
    std::vector<std::string> keys;
    for (const QString &setting : invocation.values("set")) {
        const std::string key = setting.section(u'=', 0, 0).toStdString();
        const ImportKey *known = findImportKey(key);
        const bool isAnswer = known && known->words.size() == 1; // answers a question that may not arise
        if (known && !isAnswer &&
            std::ranges::find(imported.choices, key, &ImportChoice::key) == imported.choices.end())
            keys.push_back(key);
    }
    return keys;
}

void refuseChoice(const std::string &key) {
    throw UsageError({REPORT_TEXT("report", "--set %1 has no effect here: what is read has no such choice "
                                            "(--help KEYS lists all)"),
                      {key}});
}

QByteArray bytesFrom(const QString &file) {
    if (file == QLatin1StringView("-") || file == QLatin1StringView("/dev/stdin"))
        return readStream(standardInput, QFileDevice::DontCloseHandle);
    if (const std::optional<OpenPipe> pipe = openPipe(file)) {
        if (!pipe->descriptor)
            throw Error(Error::Kind::unreadable,
                        {REPORT_TEXT("report", "this is a pipe that nobody writes to"), {}});
        return readStream(*pipe->descriptor, QFileDevice::AutoCloseHandle, pipe->begin);
    }
    return readBytes(file);
}

namespace {

/// Throws Error for a document without tests, on which any command would silently succeed.
Document withTests(Document document) {
    if (document.tests.empty())
        throw Error(Error::Kind::content, {REPORT_TEXT("report", "there is no test in the file"), {}});
    return document;
}

/// Throws UsageError for a choice of the import, which has no effect on a test file.
void requireNoChoice(const Invocation &invocation) {
    if (invocation.has("profile"))
        throw UsageError(
            {REPORT_TEXT("report", "--%1 has no effect here: this is a test file, which needs no "
                                   "choices of the import"),
             {std::string("profile")}});
    for (const QString &setting : invocation.values("set")) {
        const QString key = setting.section(u'=', 0, 0);
        if (findImportKey(key.toStdString()))
            throw UsageError(
                {REPORT_TEXT("report", "--set %1 is a choice of the import, and this is a test file; its "
                                       "fields have paths, as tests[0].title"),
                 {key.toStdString()}});
    }
}

} // namespace

Document documentFrom(const QString &file, const Invocation &invocation, Say say) {
    const QByteArray bytes = bytesFrom(file);
    const bool isReport = isPdf(bytes);
    if (isReport || isTestFile(bytes, file))
        requireNoChoice(invocation);
    if (isReport)
        return prepared(readDocument(readReportPdf(bytes).testFile), file, invocation);
    if (isTestFile(bytes, file))
        return prepared(withTests(readDocument(bytes)), file, invocation);
    Imported imported = say == Say::remarks ? importedFrom(bytes, file, chosenOptions(invocation), invocation)
                                            : importMeasurement(bytes, file, chosenOptions(invocation));
    requireAnswers(imported, invocation);
    if (const std::vector<std::string> without = choicesWithoutEffect(imported, invocation); !without.empty())
        refuseChoice(without.front());
    Document document;
    addImported(document, std::move(imported), bytes, file, false);
    return prepared(std::move(document), file, invocation);
}

} // namespace palmer
