#include "commands/import.h"

#include "commands/outputfile.h"
#include "commands/streams.h"
#include "document/bounds.h"
#include "document/writedocument.h"
#include "import/importmeasurement.h"
#include "import/profiles.h"

#include <algorithm>
#include <array>

namespace palmer {

namespace {

constexpr std::array options{
    Option{"o", "OUT.palmer", REPORT_TEXT("report", "the test file to write")},
    Option{"profile", "NAME", REPORT_TEXT("report", "the choices kept under this name")},
    Option{"set", "key=value",
           REPORT_TEXT(
               "report",
               "a choice of the import (unit=um, decimalMark=comma, axis=X, …); may stand several times"),
           true},
    Option{"keep-original", "", REPORT_TEXT("report", "keep the bytes of the files in the test file")},
};

ImportOptions chosenOptions(const Invocation &invocation) {
    ImportOptions chosen;
    if (const auto profile = invocation.value(QLatin1StringView("profile"))) {
        const ImportProfiles profiles = readImportProfiles(importProfilesPath());
        const auto found = profiles.find(profile->toStdString());
        if (found == profiles.end()) {
            std::string known;
            for (const auto &[name, words] : profiles)
                known += (known.empty() ? "" : ", ") + name;
            throw UsageError(
                {REPORT_TEXT("report", "unknown profile %1; known: %2"), {profile->toStdString(), known}});
        }
        chosen = found->second;
    }
    const QStringList settings =
        invocation.value(QLatin1StringView("set")).value_or(QString()).split(u'\n', Qt::SkipEmptyParts);
    for (const QString &setting : settings) {
        const qsizetype mark = setting.indexOf(u'=');
        if (mark < 1)
            throw UsageError(
                {REPORT_TEXT("report", "“%1” is no choice; expected key=value"), {setting.toStdString()}});
        chosen[setting.left(mark).toStdString()] = setting.mid(mark + 1).toStdString();
    }
    try {
        demandKnown(chosen);
    } catch (const Error &error) {
        throw UsageError(error.message);
    }
    return chosen;
}

/// Temperatures belong to the tests of the other files, whatever their order.
bool needsTest(const Imported &imported) {
    return !imported.test;
}

int run(const Invocation &invocation) {
    const auto output = invocation.value(QLatin1StringView("o"));
    if (!output)
        throw UsageError({REPORT_TEXT("report", "the command %1 needs a file to write (%2)"),
                          {std::string("import"), std::string("-o OUT.palmer")}});
    const ImportOptions chosen = chosenOptions(invocation);
    const bool keep = invocation.has(QLatin1StringView("keep-original"));
    struct Read {
        QString file;
        QByteArray bytes;
        Imported imported;
    };
    std::vector<Read> files;
    int code = done;
    for (const QString &file : invocation.arguments) {
        try {
            const QByteArray bytes = bytesFrom(file);
            files.push_back({file, bytes, importMeasurement(bytes, file, chosen)});
            printRemarks(file, files.back().imported.remarks, invocation.language);
        } catch (const Error &error) {
            printError(file, error, invocation.language);
            code = worse(code, cannotRead);
        }
    }
    if (code != done)
        return code; // nothing is written half
    std::ranges::stable_sort(files, {}, [](const Read &read) { return needsTest(read.imported); });
    Document document;
    for (Read &read : files) {
        try {
            addImported(document, std::move(read.imported), read.bytes, read.file, keep);
        } catch (const Error &error) {
            printError(read.file, error, invocation.language);
            return cannotRead;
        }
    }
    try {
        demandBounds(document);
        writeOutput(writeDocument(document), *output);
    } catch (const Error &error) {
        printError(*output, error, invocation.language);
        return cannotRead;
    }
    return done;
}

} // namespace

Command importCommand() {
    return {"import", "DATA…",
            REPORT_TEXT("report", "files of instruments and tables into a test file; remarks on stderr"),
            options, run};
}

} // namespace palmer
