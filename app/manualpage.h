// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/words/text.h"
#include "language/language.h"

#include <QString>
#include <vector>

namespace palmer {

/// Writes a page for man(1): section after section.
class ManualPage {
public:
    /// `name` of the program, what it is in a few words.
    ManualPage(const char *name, const Text &whatItIs, const Language &language);

    void section(const Text &title);
    void subsection(const QString &title);
    void paragraph(const QString &text);
    /// What is typed, and what it means.
    void item(const QString &typed, const QString &meaning);

    [[nodiscard]] QString text() const { return m_text; }

private:
    const Language &m_language;
    QString m_text;
};

} // namespace palmer
