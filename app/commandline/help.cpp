// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commandline/help.h"

#include "commandline/terminal.h"
#include "import/choices.h"
#include "import/layouts/columnrole.h"
#include "kernel/evaluation/edition.h"
#include "report/blocks/plaintext.h"

#include <algorithm>
#include <iterator>
#include <string_view>

namespace palmer {

namespace {

QString optionName(const Option &option) {
    QString name = dashed(option);
    if (*option.value != 0)
        name += u' ' + QString::fromUtf8(option.value);
    return name;
}

QString commandLine(const Command &command) {
    return QString(QString::fromUtf8(command.name) + u' ' + QString::fromUtf8(command.arguments)).trimmed();
}

QString paragraph(const QString &text) {
    return wrapped(text, textColumns()).join(u'\n') + u'\n';
}

/// Possible values of a choice of the import.
QString wordsOfKey(const ImportKey &key, const Language &language) {
    const std::string_view name = key.key;
    if (name == "columns")
        return QString::fromStdString(roleWords());
    QStringList words;
    for (const ImportWord &word : key.words) {
        const QString typed = QString::fromUtf8(word.word);
        const QString called = language.text(word.name);
        words << (typed == called ? typed : typed + QStringLiteral(" (") + called + u')');
    }
    if (name == "edition") {
        for (const Edition *edition : editions())
            words << QString::fromUtf8(edition->word);
    }
    if (words.isEmpty())
        words << language.text(key.value == ImportValue::number ? REPORT_TEXT("report", "a number")
                                                                : REPORT_TEXT("report", "a text"));
    return words.join(QStringLiteral(", "));
}

} // namespace

QString inColumns(const std::vector<HelpRow> &rows, int width) {
    constexpr int margin = 2; // before and between columns
    const int widest = width * 2 / 5;
    int left = 0;
    for (const HelpRow &row : rows) {
        if (const int columns = displayWidth(row.left); columns <= widest)
            left = std::max(left, columns);
    }
    const int indent = margin + left + margin;
    QString text;
    for (const HelpRow &row : rows) {
        QString line = QString(margin, u' ') + row.left;
        if (displayWidth(row.left) > left) {
            text += line + u'\n';
            line.clear();
        }
        for (const QString &part : wrapped(row.right, width - indent)) {
            text += line + QString(indent - displayWidth(line), u' ') + part + u'\n';
            line.clear();
        }
    }
    return text;
}

std::vector<HelpRow> commandRows(const Language &language) {
    std::vector<HelpRow> rows;
    for (const Command &command : commands())
        rows.push_back({commandLine(command), language.text(command.description)});
    return rows;
}

std::vector<HelpRow> optionRows(std::span<const Option> options, const Language &language) {
    std::vector<HelpRow> rows;
    for (const Option &option : options)
        rows.push_back({optionName(option), language.text(option.description)});
    return rows;
}

std::vector<HelpRow> commonRows(const Command &command, const Language &language) {
    std::vector<HelpRow> rows;
    for (const Option &option : commonOptions()) {
        if (findOption(command.options, QString::fromUtf8(option.name)))
            continue;
        std::ranges::move(optionRows({&option, 1}, language), std::back_inserter(rows));
    }
    if (takesKeys(command))
        rows.push_back({QStringLiteral("--help ") + QString::fromUtf8(keysWord),
                        language.text(REPORT_TEXT("report", "the choices of the import, for --set"))});
    return rows;
}

std::vector<HelpRow> versionRows(const Language &language) {
    std::vector<HelpRow> rows = optionRows(commonOptions(), language);
    rows.push_back(
        {QStringLiteral("--version"), language.text(REPORT_TEXT("report", "version of the program"))});
    return rows;
}

std::vector<HelpRow> keyRows(const Language &language) {
    std::vector<HelpRow> rows;
    for (const ImportKey &key : importKeys())
        rows.push_back({QString::fromUtf8(key.key),
                        language.sentence({REPORT_TEXT_FOR("report", "%1: %2", "a choice and its words"),
                                           {language.text(key.name).toStdString(),
                                            wordsOfKey(key, language).toStdString()}})});
    return rows;
}

QString filesSentence(const Language &language) {
    return language.text(REPORT_TEXT("report",
                                     "FILE is a test file (.palmer), a report of Palmer (PDF) or a "
                                     "measurement file that can be imported; - is standard input."));
}

QString fieldsSentence(const Language &language) {
    return language.text(REPORT_TEXT(
        "report", "Every other key is the path of a field of the test file, as its schema has it: "
                  "machine.name, limits.A.value (of every test), tests[0].title. Limits, deviations and "
                  "resolutions say their unit: 20um, 5arcsec."));
}

QString programHelp(const Language &language) {
    return paragraph(language.text(REPORT_TEXT(
               "report", "palmer-cli evaluates machine-tool tests: positioning of axes (ISO 230-2), "
                         "circular tests (ISO 230-4)."))) +
           QStringLiteral("\npalmer-cli ") +
           language.text(REPORT_TEXT("report", "COMMAND [OPTION]… [FILE]…")) + QStringLiteral("\n\n") +
           inColumns(commandRows(language), textColumns()) + u'\n' +
           inColumns(versionRows(language), textColumns()) + u'\n' + paragraph(filesSentence(language));
}

QString commandHelp(const Command &command, const Language &language) {
    std::vector<HelpRow> options = optionRows(command.options, language);
    std::ranges::move(commonRows(command, language), std::back_inserter(options));
    return QStringLiteral("palmer-cli ") + QString::fromUtf8(command.name) + QStringLiteral(" [OPTION]… ") +
           QString::fromUtf8(command.arguments).trimmed() + QStringLiteral("\n\n") +
           paragraph(language.text(command.description)) + u'\n' + inColumns(options, textColumns());
}

QString keysHelp(const Language &language) {
    return QStringLiteral("--set KEY=VALUE\n\n") + inColumns(keyRows(language), textColumns()) + u'\n' +
           paragraph(fieldsSentence(language));
}

bool takesKeys(const Command &command) {
    return findOption(command.options, QStringLiteral("set"));
}

} // namespace palmer
