// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editing/newtest.h"
#include "language/language.h"
#include "ui/qtforward.h"

#include <QDialog>

namespace palmer::ui {

class StatementsBox;

/// Asks for the parameters of a new circular test; its arcs are typed or pasted on the page.
class NewCircleDialog : public QDialog {
    Q_OBJECT

public:
    /// `like`: a test whose values are proposed if it is circular; may be null.
    explicit NewCircleDialog(Language language, const Test *like = nullptr, QWidget *parent = nullptr);

    /// The values entered; complete once the dialog is accepted.
    [[nodiscard]] NewCircularTest wanted() const;

    /// Offers to copy the statements of a test of the same file; initially checked.
    void offerStatementsOf(const Test &test);
    [[nodiscard]] bool takesStatements() const;

private:
    void check();

    Language m_language;
    QComboBox *m_plane;
    QLineEdit *m_radius;
    QLineEdit *m_feed;
    QComboBox *m_source;
    QComboBox *m_edition;
    StatementsBox *m_statements;
    QLabel *m_problem;
    QPushButton *m_create;
};

} // namespace palmer::ui
