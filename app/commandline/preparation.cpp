// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commandline/preparation.h"

#include "commandline/inputs.h"
#include "commandline/optionvalues.h"
#include "commandline/streams.h"
#include "document/edits.h"
#include "document/savedocument.h"
#include "document/setfield.h"
#include "document/templatefile.h"
#include "import/choices.h"
#include "import/importmeasurement.h"
#include "kernel/evaluation/edition.h"

#include <algorithm>

namespace palmer {

namespace {

/// Replaces the instrument with the same id; tests without instrument refer to the new one.
void apply(Document &document, const Instrument &instrument) {
    const auto same = std::ranges::find(document.instruments, instrument.id, &Instrument::id);
    if (same != document.instruments.end() && !instrument.id.empty())
        *same = instrument;
    else
        addInstrument(document, instrument);
    const std::string id = instrument.id.empty() ? document.instruments.back().id : instrument.id;
    for (std::size_t i = 0; i < document.tests.size(); ++i) {
        if (document.tests[i]->instruments.empty())
            editTest(document, i, [&](Test &test) { test.instruments = {id}; });
    }
}

void apply(Document &document, const Machine &machine) {
    const std::string &own = document.machine.serialNumber;
    if (!own.empty() && !machine.serialNumber.empty() && areOtherMachines(document.machine, machine))
        throw Error(Error::Kind::content,
                    {REPORT_TEXT("report",
                                 "the template is of the machine with the serial number %1, the file of the "
                                 "one with %2"),
                     {machine.serialNumber, own}});
    document.machine = machine;
}

void apply(Document &document, const Laboratory &laboratory) {
    document.report.laboratory = laboratory;
}

void apply(Document &document, const LimitSet &limits) {
    for (std::size_t i = 0; i < document.tests.size(); ++i)
        editTest(document, i, [&](Test &test) { applyLimitSet(test, limits); });
}

void apply(Document &document, const Declarations &declarations) {
    for (std::size_t i = 0; i < document.tests.size(); ++i)
        editTest(document, i, [&](Test &test) { applyDeclarations(test, declarations); });
}

/// Throws Error with the place in the template, because messages begin with the name of the processed file.
Template templateFrom(const QString &file) {
    try {
        return readTemplate(readBytes(file));
    } catch (Error &error) {
        error.place = file.toStdString() + (error.place.empty() ? "" : ": " + error.place);
        throw;
    }
}

std::vector<std::string> editionsOf(const QString &words) {
    std::vector<std::string> result;
    for (const QString &word : words.split(u',', Qt::SkipEmptyParts))
        result.emplace_back(editionCalled(word.trimmed())->word);
    return result;
}

} // namespace

std::vector<FieldSetting> fieldSettings(const Invocation &invocation) {
    std::vector<FieldSetting> result;
    for (const QString &setting : invocation.values("set")) {
        const qsizetype mark = setting.indexOf(u'=');
        if (mark < 1)
            throw UsageError(
                {REPORT_TEXT("report", "“%1” is no choice; expected key=value"), {setting.toStdString()}});
        if (!findImportKey(setting.left(mark).toStdString()))
            result.push_back({setting.left(mark), setting.mid(mark + 1)});
    }
    return result;
}

bool canReadTemplates(const Invocation &invocation) {
    return std::ranges::all_of(invocation.values("template"), [&](const QString &file) {
        try {
            static_cast<void>(readTemplate(readBytes(file)));
            return true;
        } catch (const Error &error) {
            printError(file, error, invocation.language);
            return false;
        }
    });
}

Document prepared(Document document, const Invocation &invocation) {
    for (const QString &file : invocation.values("template"))
        std::visit([&](const auto &content) { apply(document, content); }, templateFrom(file).content);
    if (const auto words = invocation.value("editions"))
        document.report.editions = editionsOf(*words);
    if (isOneFile(invocation) && invocation.has("editions")) {
        for (const std::string &word : document.report.editions)
            requireTestOf(*findEdition(word), document);
    }
    for (const FieldSetting &field : fieldSettings(invocation)) {
        try {
            document = withField(document, field.path.toStdString(), field.value.toStdString());
        } catch (const Error &error) {
            throw UsageError(
                {REPORT_TEXT("report", "--set %1: %2"),
                 {(field.path + u'=' + field.value).toStdString(),
                  ((error.place.empty() ? QString()
                                        : QString::fromStdString(error.place) + QStringLiteral(": ")) +
                   invocation.language.sentence(error.message))
                      .toStdString()}});
        }
    }
    return document;
}

} // namespace palmer
