// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "manualpage.h"

#include <QStringList>

namespace palmer {

namespace {

/// Escapes text for the formatter: no line is a request, and hyphens are ASCII, so that they can be copied.
QString escaped(QString text) {
    text.replace(u'\\', QStringLiteral("\\e"));
    text.replace(u'-', QStringLiteral("\\-"));
    text.replace(u'\n', u' ');
    return text.startsWith(u'.') || text.startsWith(u'\'') ? QStringLiteral("\\&") + text : text;
}

/// Length as mandoc counts it: other characters as \[u00A0].
qsizetype sizeOf(const QString &line) {
    constexpr int named = 8;
    qsizetype size = 0;
    for (const QChar c : line)
        size += c.unicode() < 0x80 ? 1 : named;
    return size;
}

/// Escaped text in lines of at most 80 bytes where it has blanks.
QString inLines(const QString &text) {
    constexpr qsizetype longest = 80;
    QStringList lines{QString()};
    for (const QString &word : text.split(u' ')) {
        if (!lines.last().isEmpty() && sizeOf(lines.last() + u' ' + escaped(word)) > longest)
            lines << QString();
        lines.last() += (lines.last().isEmpty() ? QString() : QStringLiteral(" ")) + escaped(word);
    }
    return lines.join(u'\n');
}

} // namespace

ManualPage::ManualPage(const char *name, const Text &whatItIs, const Language &language)
    : m_language(language) {
    const QString program = QString::fromUtf8(name);
    m_text = QStringLiteral(".TH %1 1 \"" PALMER_RELEASED "\" \"Palmer " PALMER_VERSION "\" \"Palmer\"\n")
                 .arg(program.toUpper());
    section(REPORT_TEXT_FOR("report", "NAME", "section of a manual page"));
    m_text += program + QStringLiteral(" \\-\n") + inLines(language.text(whatItIs)) + u'\n';
}

void ManualPage::section(const Text &title) {
    m_text += QStringLiteral(".SH ") + escaped(m_language.text(title)) + u'\n';
    m_begins = true;
}

void ManualPage::subsection(const QString &title) {
    m_text += QStringLiteral(".SS ") + escaped(title) + u'\n';
    m_begins = true;
}

void ManualPage::paragraph(const QString &text) {
    m_text += (m_begins ? QString() : QStringLiteral(".PP\n")) + inLines(text) + u'\n';
    m_begins = false;
}

void ManualPage::item(const QString &typed, const QString &meaning) {
    m_text +=
        QStringLiteral(".TP\n\\fB") + escaped(typed) + QStringLiteral("\\fR\n") + inLines(meaning) + u'\n';
    m_begins = false;
}

} // namespace palmer
