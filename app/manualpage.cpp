// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "manualpage.h"

namespace palmer {

namespace {

/// Escapes text for the formatter: no line is a request, and hyphens are ASCII, so that they can be copied.
QString escaped(QString text) {
    text.replace(u'\\', QStringLiteral("\\e"));
    text.replace(u'-', QStringLiteral("\\-"));
    text.replace(u'\n', u' ');
    return text.startsWith(u'.') || text.startsWith(u'\'') ? QStringLiteral("\\&") + text : text;
}

} // namespace

ManualPage::ManualPage(const char *name, const Text &whatItIs, const Language &language)
    : m_language(language) {
    const QString program = QString::fromUtf8(name);
    m_text =
        QStringLiteral(".TH %1 1 \"\" \"Palmer " PALMER_VERSION "\" \"Palmer\"\n").arg(program.toUpper());
    section(REPORT_TEXT_FOR("report", "NAME", "section of a manual page"));
    m_text += program + QStringLiteral(" \\- ") + escaped(language.text(whatItIs)) + u'\n';
}

void ManualPage::section(const Text &title) {
    m_text += QStringLiteral(".SH ") + escaped(m_language.text(title)) + u'\n';
}

void ManualPage::subsection(const QString &title) {
    m_text += QStringLiteral(".SS ") + escaped(title) + u'\n';
}

void ManualPage::paragraph(const QString &text) {
    m_text += QStringLiteral(".PP\n") + escaped(text) + u'\n';
}

void ManualPage::item(const QString &typed, const QString &meaning) {
    m_text +=
        QStringLiteral(".TP\n\\fB") + escaped(typed) + QStringLiteral("\\fR\n") + escaped(meaning) + u'\n';
}

} // namespace palmer
