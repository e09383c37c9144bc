// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "ui/model/page.h"
#include "ui/translated.h"

#include <QStackedWidget>
#include <map>

namespace palmer::ui {

class DocumentModel;
class Form;
class Selection;

/// The report's pages outside the tests: identification, machine, instruments, acceptance sheet. Each is made
/// when first shown.
class ReportPages : public Translated<QStackedWidget> {
    Q_OBJECT

public:
    ReportPages(DocumentModel &model, Selection &selection, QWidget *parent = nullptr);

    void show(const EvaluatedDocument &evaluated);
    /// `before`: the widget before the page in the tab order.
    void showPage(Page page, QWidget *before = nullptr);
    /// The title of the report, for the head of the page; may be empty.
    [[nodiscard]] QString subtitle() const;

signals:
    /// The user asked for the next missing statement.
    void nextWanted();

private:
    [[nodiscard]] Form *make(Page page);
    void retranslate() final;

    DocumentModel &m_model;
    Selection &m_selection;
    EvaluatedDocument m_evaluated;
    std::map<Page, Form *> m_forms; ///< pages made so far
};

} // namespace palmer::ui
