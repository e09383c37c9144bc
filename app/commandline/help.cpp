// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commandline/help.h"

#include "commandline/terminal.h"
#include "import/choices.h"
#include "import/layouts/columnrole.h"
#include "kernel/evaluation/edition.h"
#include "report/blocks/plaintext.h"

#include <algorithm>
#include <array>
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
                  "resolutions say their unit: 20um, 5arcsec. Other numbers may have any unit that fits: "
                  "500 mm, 2 m/min, 22.5 °C; without one they are in the unit of the file."));
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

std::vector<Option> optionsOf(const Command &command, const QString &part) {
    std::vector<Option> own;
    std::ranges::copy_if(command.options, std::back_inserter(own), [&](const Option &option) {
        const QStringList with = QString::fromUtf8(option.goesWith).split(u'|');
        const bool isOfOther = !partsOf(command).filter(with.front()).isEmpty() && !with.front().isEmpty();
        return part.isEmpty() ||
               (command.partTakes ? command.partTakes(part, option) : with.contains(part) || !isOfOther);
    });
    return own;
}

QString commandHelp(const Command &command, const Language &language, const QString &part) {
    std::vector<HelpRow> options = optionRows(optionsOf(command, part), language);
    std::ranges::move(commonRows(command, language), std::back_inserter(options));
    QString examples;
    for (const QString &example : examplesOf(command, part))
        for (const QString &line : wrapped(QStringLiteral("palmer-cli ") + example, textColumns() - 2))
            examples += QStringLiteral("  ") + line + u'\n';
    QString called = QString::fromUtf8(command.name);
    QString arguments = QString::fromUtf8(command.arguments).trimmed();
    QString description = language.text(command.description);
    if (!part.isEmpty()) { // the description ends with a list of the parts and their arguments
        called += u' ' + part;
        const QStringList all = description.section(u':', -1).split(u',');
        const auto found = std::ranges::find_if(
            all, [&](const QString &one) { return one.trimmed().section(u' ', 0, 0) == part; });
        arguments = found == all.end() ? QString() : found->trimmed().mid(part.size() + 1);
        description = description.section(u':', 0, 0).trimmed();
    }
    return paragraph((QStringLiteral("palmer-cli ") + called + QStringLiteral(" [OPTION]… ") + arguments)
                         .trimmed()) +
           u'\n' + paragraph(description) + u'\n' + inColumns(options, textColumns()) + u'\n' +
           language.text(REPORT_TEXT("report", "Examples")) + u'\n' + examples + u'\n' +
           language.text(REPORT_TEXT("report", "Exit codes")) + u'\n' +
           inColumns(exitRows(language, &command), textColumns());
}

QStringList examplesOf(const Command &command, const QString &part) {
    // clang-format off
    constexpr std::array rows{
        "evaluate x.palmer --edition 2006", "evaluate FOLDER --table csv",
        "check x.palmer", "check FOLDER --json-lines",
        "report x.palmer --language fr,en -o x.pdf", "report FOLDER -o reports --name {machine}-{axis}-{date}",
        "verify x.fr.pdf", "verify x.pdf --extract x.palmer",
        "figure x.palmer -o x.svg", "figure FOLDER --as png -o figures",
        "explain x.palmer A", "explain x.palmer --typical",
        "compare before.palmer after.palmer", "compare x.palmer x.palmer --test 1,2 --json",
        "import x.rtl --accept -o x.palmer", "import x.csv --set unit=um --set axis=X -o x.palmer",
        "export x.palmer --as csv -o x.csv", "export x.palmer --as linuxcnc -o x.comp",
        "export x.palmer --as program --dialect siemens -o x.mpf",
        "targets --axis X --travel 500 -o plan.palmer", "targets --travel 500 --program siemens -o x.mpf",
        "feed --specified-diameter 100 --specified-feed 500 --diameter 125",
        "synthesize circular --source backlash:X=6 -o made.palmer", "synthesize positioning --noise 0.5 -o made.palmer",
        "register scan FOLDER", "register list --due 2030-01-01", "register trend --machine 7 --axis X -o x.svg",
        "register report --machine 7 -o history.pdf", "register type FOLDER --parameter A", "register join 7 8", "register separate 000-018",
        "register interval 7 12",
        "schema", "schema results",
        "selftest", "selftest --report validation.pdf"};
    // clang-format on
    const QString begin = (QString::fromUtf8(command.name) + u' ' + part).trimmed();
    QStringList examples;
    for (const char *row : rows) {
        if (const QString call = QString::fromUtf8(row); call == begin || call.startsWith(begin + u' '))
            examples << call;
    }
    return examples;
}

std::vector<HelpRow> exitRows(const Language &language, const Command *command) {
    constexpr std::array judging{"evaluate", "report", "check", "verify", "compare", "selftest"};
    std::vector<HelpRow> rows{{QStringLiteral("0"), language.text(REPORT_TEXT("report", "done"))}};
    if (!command ||
        std::ranges::any_of(judging, [&](std::string_view name) { return name == command->name; }))
        rows.push_back({QStringLiteral("1"),
                        language.text(REPORT_TEXT(
                            "report", "a verdict other than “conforms” (the report is written all the "
                                      "same), an unmet requirement (check), a difference (verify, "
                                      "compare, selftest), nothing judged or proven (compare)"))});
    rows.push_back({QStringLiteral("2"), language.text(REPORT_TEXT("report", "wrong usage"))});
    rows.push_back({QStringLiteral("3"),
                    language.text(REPORT_TEXT("report", "a file cannot be read, written or understood"))});
    return rows;
}

QString keysHelp(const Language &language) {
    return QStringLiteral("--set KEY=VALUE\n\n") + inColumns(keyRows(language), textColumns()) + u'\n' +
           paragraph(fieldsSentence(language));
}

bool takesKeys(const Command &command) {
    return findOption(command.options, QStringLiteral("set"));
}

} // namespace palmer
