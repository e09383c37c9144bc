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
    }
    page.section(REPORT_TEXT_FOR("report", "KEYS OF --set", "section of a manual page"));
    addItems(page, keyRows(language));
    page.paragraph(fieldsSentence(language));
    page.section(REPORT_TEXT_FOR("report", "EXIT STATUS", "section of a manual page"));
    page.item(QStringLiteral("0"), language.text(REPORT_TEXT("report", "done")));
    page.item(
        QStringLiteral("1"),
        language.text(REPORT_TEXT("report", "a verdict other than “conforms” (the report is written all the "
                                            "same), an unmet requirement (check), a difference (verify, "
                                            "selftest)")));
    page.item(QStringLiteral("2"), language.text(REPORT_TEXT("report", "wrong usage")));
    page.item(QStringLiteral("3"),
              language.text(REPORT_TEXT("report", "a file cannot be read, written or understood")));
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
