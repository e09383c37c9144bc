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
#include "kernel/evaluation/edition.h"
#include "register/machineidentity.h"

#include <algorithm>
#include <initializer_list>
#include <set>

namespace palmer {

namespace {

/// The effect of a template on a file.
struct Applied {
    bool hasEffect = true;
    std::vector<Message> said;
};

bool areStatedDifferently(const std::string &a, const std::string &b) {
    return !a.empty() && !b.empty() &&
           comparable(QString::fromStdString(a)) != comparable(QString::fromStdString(b));
}

/// Throws Error where a template is of another thing than the file, by their serial numbers; where one is not
/// stated, says which names are replaced.
template <class Thing>
Applied replaced(Text refusal, const Thing &own, const Thing &other,
                 std::initializer_list<std::string Thing::*> names) {
    if (areStatedDifferently(own.serialNumber, other.serialNumber))
        throw Error(Error::Kind::content, {refusal, {other.serialNumber, own.serialNumber}});
    Applied result;
    for (const auto name : names) {
        if ((own.serialNumber.empty() || other.serialNumber.empty()) &&
            areStatedDifferently(own.*name, other.*name))
            result.said.push_back(
                {REPORT_TEXT("report", "the template replaces “%1” by “%2”"), {own.*name, other.*name}});
    }
    return result;
}

/// Replaces the instrument with the same id; tests without instrument refer to the new one.
Applied apply(Document &document, const Instrument &instrument) {
    Applied result;
    const auto same = std::ranges::find(document.instruments, instrument.id, &Instrument::id);
    if (same != document.instruments.end() && !instrument.id.empty()) {
        result = replaced(REPORT_TEXT("report", "the template is of the instrument with the serial number "
                                                "%1, the file has the one with %2"),
                          *same, instrument, {&Instrument::description});
        *same = instrument;
    } else {
        addInstrument(document, instrument);
    }
    const std::string id = instrument.id.empty() ? document.instruments.back().id : instrument.id;
    for (std::size_t i = 0; i < document.tests.size(); ++i) {
        if (document.tests[i]->instruments.empty())
            editTest(document, i, [&](Test &test) { test.instruments = {id}; });
    }
    return result;
}

Applied apply(Document &document, const Machine &machine) {
    Applied result = replaced(REPORT_TEXT("report", "the template is of the machine with the serial number "
                                                    "%1, the file of the one with %2"),
                              document.machine, machine, {&Machine::manufacturer, &Machine::name});
    document.machine = machine;
    return result;
}

Applied apply(Document &document, const Laboratory &laboratory) {
    document.report.laboratory = laboratory;
    return {};
}

/// For what `put` puts into each test that it fits.
template <class Content>
Applied applied(Document &document, const Content &content, bool (*put)(Test &, const Content &)) {
    Applied result{false, {}};
    for (std::size_t i = 0; i < document.tests.size(); ++i)
        editTest(document, i, [&](Test &test) { result.hasEffect = put(test, content) || result.hasEffect; });
    return result;
}

Applied apply(Document &document, const LimitSet &limits) {
    return applied(document, limits, applyLimitSet);
}

Applied apply(Document &document, const Declarations &declarations) {
    return applied(document, declarations, applyDeclarations);
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
    std::set<QString> keys;
    for (const QString &setting : invocation.values("set")) {
        const qsizetype mark = setting.indexOf(u'=');
        if (mark < 1)
            throw UsageError(
                {REPORT_TEXT("report", "“%1” is no choice; expected key=value"), {setting.toStdString()}});
        if (!keys.insert(setting.left(mark)).second)
            throw UsageError({REPORT_TEXT("report", "the option %1 stands twice; it takes one value"),
                              {"--set " + setting.left(mark).toStdString()}});
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

Document prepared(Document document, const QString &file, const Invocation &invocation) {
    for (const QString &name : invocation.values("template")) {
        Applied done = std::visit([&](const auto &content) { return apply(document, content); },
                                  templateFrom(name).content);
        if (!done.hasEffect) {
            const Message none{REPORT_TEXT("report", "--template %1 has no effect here: it fits no test of "
                                                     "the file; limits are of one kind of test, and of "
                                                     "linear or of rotary axes"),
                               {name.toStdString()}};
            if (isOneFile(invocation))
                throw UsageError(none);
            done.said.push_back(none);
        }
        for (const Message &said : done.said)
            printError(file + QStringLiteral(": ") + invocation.language.sentence(said));
    }
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
