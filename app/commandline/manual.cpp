// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commandline/help.h"

#include "commandline/command.h"
#include "manualpage.h"

namespace palmer {

namespace {

constexpr auto programName = "palmer-cli";

void addItems(ManualPage &page, const std::vector<HelpRow> &rows) {
    for (const HelpRow &row : rows)
        page.item(row.left, row.right);
}

} // namespace

QString manualPage(const Language &language) {
    ManualPage page(programName,
                    REPORT_TEXT("report", "evaluate tests of machine tools and print the report"), language);
    page.section(REPORT_TEXT_FOR("report", "SYNOPSIS", "section of a manual page"));
    page.paragraph(QString::fromUtf8(programName) + u' ' +
                   language.text(REPORT_TEXT("report", "COMMAND [OPTION]… [FILE]…")));
    page.section(REPORT_TEXT_FOR("report", "DESCRIPTION", "section of a manual page"));
    page.paragraph(language.text(
        REPORT_TEXT("report", "palmer-cli evaluates machine-tool tests: positioning of axes (ISO 230-2), "
                              "circular tests (ISO 230-4).")));
    page.paragraph(filesSentence(language));
    addItems(page, versionRows(language));
    page.section(REPORT_TEXT_FOR("report", "COMMANDS", "section of a manual page"));
    const std::vector<HelpRow> heads = commandRows(language);
    for (std::size_t i = 0; i < heads.size(); ++i) {
        page.subsection(heads[i].left);
        page.paragraph(heads[i].right);
        addItems(page, optionRows(commands()[i].options, language));
        for (const QString &example : examplesOf(commands()[i]))
            page.item(QStringLiteral("palmer-cli ") + example,
                      language.text(REPORT_TEXT("report", "an example")));
    }
    page.section(REPORT_TEXT_FOR("report", "KEYS OF --set", "section of a manual page"));
    addItems(page, keyRows(language));
    page.paragraph(fieldsSentence(language));
    page.section(REPORT_TEXT_FOR("report", "EXIT STATUS", "section of a manual page"));
    addItems(page, exitRows(language));
    page.section(REPORT_TEXT_FOR("report", "FILES", "section of a manual page"));
    page.item(QStringLiteral("~/.local/share/palmer/register.sqlite"),
              language.text(REPORT_TEXT("report", "the register, without --register")));
    page.item(QStringLiteral("~/.config/palmer/import-profiles.json"),
              language.text(REPORT_TEXT("report", "the choices kept for --profile")));
    page.item(QStringLiteral("palmer-machines.json"),
              language.text(
                  REPORT_TEXT("report", "in a folder of the register: machines that are one, intervals")));
    page.section(REPORT_TEXT_FOR("report", "ENVIRONMENT", "section of a manual page"));
    page.item(QStringLiteral("LC_ALL, LC_MESSAGES, LANG"),
              language.text(REPORT_TEXT("report", "the language, French or English, without --language")));
    page.item(
        QStringLiteral("COLUMNS"),
        language.text(REPORT_TEXT("report", "columns of help and tables; without it those of the terminal")));
    page.item(QStringLiteral("NO_COLOR"),
              language.text(REPORT_TEXT("report", "nothing is printed in colour, with it or without")));
    page.section(REPORT_TEXT_FOR("report", "SEE ALSO", "section of a manual page"));
    page.paragraph(QStringLiteral("palmer(1)"));
    return page.text();
}

} // namespace palmer
