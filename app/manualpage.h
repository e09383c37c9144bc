// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/words/text.h"
#include "language/language.h"

#include <QString>
#include <vector>

namespace palmer {

/// Writes a page for man(1), section by section.
class ManualPage {
public:
    /// `name` of the program, and a short description.
    ManualPage(const char *name, const Text &whatItIs, const Language &language);

    void section(const Text &title);
    void subsection(const QString &title);
    void paragraph(const QString &text);
    /// Adds what is typed, and its meaning.
    void item(const QString &typed, const QString &meaning);

    [[nodiscard]] QString text() const { return m_text; }

private:
    const Language &m_language;
    QString m_text;
    bool m_begins = false; ///< a section or subsection: its first paragraph needs no mark
};

} // namespace palmer
