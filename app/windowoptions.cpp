// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "windowoptions.h"

#include "commandline/terminal.h"
#include "environment.h"
#include "manualpage.h"
#include "report/blocks/plaintext.h"
#include "system/process.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <span>

namespace palmer {

namespace {

constexpr int wrongUsage = 2;
constexpr int noDisplay = 3; // like a file that could not be opened

/// Options of Qt applications with a value, and those without. Qt accepts them with one or two dashes.
constexpr std::array<const char *, 14> qtOptions{
    "platform",     "platformpluginpath", "platformtheme", "plugin", "qwindowgeometry", "qwindowicon",
    "qwindowtitle", "geometry",           "icon",          "title",  "display",         "session",
    "style",        "stylesheet"};
constexpr std::array<const char *, 5> qtSwitches{"reverse", "widgetcount", "nograb", "dograb", "sync"};

bool isOption(const QString &word) {
    return word.size() > 1 && word.startsWith(u'-');
}

QString withoutDashes(const QString &option) {
    return option.mid(option.startsWith(QLatin1StringView("--")) ? 2 : 1).section(u'=', 0, 0);
}

bool isOneOf(std::span<const char *const> names, const QString &option) {
    return std::ranges::find(names, withoutDashes(option),
                             [](const char *name) { return QString::fromLatin1(name); }) != names.end();
}

void print(std::FILE *stream, const QString &text) {
    const QByteArray bytes = text.toUtf8();
    std::fwrite(bytes.constData(), 1, static_cast<std::size_t>(bytes.size()), stream);
    std::fflush(stream);
}

struct OwnOption {
    const char *name = nullptr;
    Text description;
};
constexpr std::array ownOptions{
    OwnOption{"--help", REPORT_TEXT("report", "this help")},
    OwnOption{"--version", REPORT_TEXT("report", "version of the program")},
};
constexpr Text synopsis = REPORT_TEXT("report", "palmer [FILE]…");
constexpr Text whatItDoes =
    REPORT_TEXT("report", "palmer opens the window of Palmer: tests of machine tools, "
                          "positioning of axes (ISO 230-2), circular tests (ISO 230-4).");
constexpr Text whatFilesAre = REPORT_TEXT(
    "report", "FILE is a test file (.palmer), a report of Palmer (PDF) or a measurement file that can "
              "be imported. palmer-cli does the same work without a window.");

QString help(const Language &language) {
    const auto paragraph = [&](const Text &text) {
        return wrapped(language.text(text), textColumns()).join(u'\n') + u'\n';
    };
    QString options;
    for (const OwnOption &option : ownOptions)
        options += QStringLiteral("  %1  %2\n")
                       .arg(QString::fromUtf8(option.name), -9)
                       .arg(language.text(option.description));
    return paragraph(whatItDoes) + u'\n' + language.text(synopsis) + QStringLiteral("\n\n") + options +
           u'\n' + paragraph(whatFilesAre);
}

QString manual(const Language &language) {
    ManualPage page("palmer", REPORT_TEXT("report", "evaluate tests of machine tools and print the report"),
                    language);
    page.section(REPORT_TEXT_FOR("report", "SYNOPSIS", "section of a manual page"));
    page.paragraph(language.text(synopsis));
    page.section(REPORT_TEXT_FOR("report", "DESCRIPTION", "section of a manual page"));
    page.paragraph(language.text(whatItDoes));
    page.paragraph(language.text(whatFilesAre));
    for (const OwnOption &option : ownOptions)
        page.item(QString::fromUtf8(option.name), language.text(option.description));
    page.section(REPORT_TEXT_FOR("report", "EXAMPLES", "section of a manual page"));
    page.item(QStringLiteral("palmer x.palmer"), language.text(REPORT_TEXT("report", "an example")));
    page.section(REPORT_TEXT_FOR("report", "EXIT STATUS", "section of a manual page"));
    page.item(QStringLiteral("0"), language.text(REPORT_TEXT("report", "done")));
    page.item(QStringLiteral("2"), language.text(REPORT_TEXT("report", "wrong usage")));
    page.section(REPORT_TEXT_FOR("report", "FILES", "section of a manual page"));
    page.item(QStringLiteral("~/.local/share/palmer/register.sqlite"),
              language.text(REPORT_TEXT("report", "the register")));
    page.section(REPORT_TEXT_FOR("report", "SEE ALSO", "section of a manual page"));
    page.paragraph(QStringLiteral("palmer-cli(1)"));
    return page.text();
}

/// True if the environment indicates a screen for the window.
bool hasDisplay(const QStringList &words) {
    const auto choosesPlatform = [](const QString &word) {
        constexpr std::array<const char *, 2> choosing{"platform", "display"};
        return isOption(word) && isOneOf(choosing, word);
    };
    return hasScreen() || std::ranges::any_of(words, choosesPlatform);
}

} // namespace

std::optional<int> answeredWithoutWindow(const QStringList &words) {
    const Language language = languageOfLocale();
    for (qsizetype i = 0; i < words.size(); ++i) {
        const QString &word = words[i];
        if (!isOption(word))
            continue;
        if (word == QLatin1StringView("--"))
            break;
        if (word == QLatin1StringView("--help") || word == QLatin1StringView("-h")) {
            print(stdout, help(language));
            return 0;
        }
        if (word == QLatin1StringView("--manual-page")) { // for packages; not in the help
            print(stdout, manual(language));
            return 0;
        }
        if (word == QLatin1StringView("--version")) {
            print(stdout, QStringLiteral("Palmer " PALMER_VERSION "\n"));
            return 0;
        }
        const bool hasValue = isOneOf(qtOptions, word);
        if (!hasValue && !isOneOf(qtSwitches, word)) {
            print(stderr,
                  QStringLiteral("palmer: ") +
                      language.sentence({REPORT_TEXT("report", "unknown option %1; palmer --help lists "
                                                               "them"),
                                         {word.toStdString()}}) +
                      u'\n');
            return wrongUsage;
        }
        if (hasValue && !word.contains(u'='))
            ++i;
    }
    if (!hasDisplay(words)) {
        print(stderr, QStringLiteral("palmer: ") +
                          language.text(REPORT_TEXT("report", "no display is there to open a window on; "
                                                              "palmer-cli works without one")) +
                          u'\n');
        return noDisplay;
    }
    return {};
}

QStringList filesOf(const QStringList &words) {
    QStringList files = words;
    files.removeOne(QStringLiteral("--")); // only the first one: the rest are files
    return files;
}

} // namespace palmer
