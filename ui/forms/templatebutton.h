// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/templatefile.h"

#include <QToolButton>

namespace palmer::ui {

class DocumentModel;
class Selection;

/// The button of a form whose menu fills the form from a template of the user's, keeps what the form says as
/// one, and exchanges them as files.
class TemplateButton : public QToolButton {
    Q_OBJECT

public:
    enum class Kind { machine, instrument, laboratory, limits, conditions };

    TemplateButton(Kind kind, DocumentModel &model, Selection &selection, QWidget *parent = nullptr);

    /// Puts a template into the document, as one step to undo; false where it does not fit.
    bool apply(const Template &content);
    /// What the form says, as a template of that name; of several instruments the last one.
    [[nodiscard]] Template current(const QString &name) const;

protected:
    void changeEvent(QEvent *event) override;

private:
    void fill();
    void keep();
    void take();
    void save();
    [[nodiscard]] bool fits(const Template &content) const;
    [[nodiscard]] QString suggestedName() const;
    void retranslate();

    Kind m_kind;
    DocumentModel &m_model;
    Selection &m_selection;
};

} // namespace palmer::ui
