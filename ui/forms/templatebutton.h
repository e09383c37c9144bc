// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/templatefile.h"
#include "ui/translated.h"

#include <QToolButton>

namespace palmer::ui {

class DocumentModel;
class Selection;

/// A form's button with a menu to fill the form from a user template, store its content as one, and import or
/// export templates as files.
class TemplateButton : public Translated<QToolButton> {
    Q_OBJECT

public:
    enum class Kind { machine, instrument, laboratory, limits, conditions };

    TemplateButton(Kind kind, DocumentModel &model, Selection &selection, QWidget *parent = nullptr);

    /// Applies a template to the document as one undo step. False if it does not fit.
    bool apply(const Template &content);
    /// The content of the form as a template of that name; the last one of several instruments.
    [[nodiscard]] Template current(const QString &name) const;

private:
    void fill();
    void keep();
    void applyFile();
    void save();
    [[nodiscard]] bool fits(const Template &content) const;
    [[nodiscard]] QString suggestedName() const;
    void retranslate() final;

    Kind m_kind;
    DocumentModel &m_model;
    Selection &m_selection;
};

} // namespace palmer::ui
