// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "ui/model/page.h"

#include <QStackedWidget>
#include <map>

namespace palmer::ui {

class DocumentModel;
class Form;
class Selection;

/// The pages of the report that belong to no test: identification, machine, instruments. Each
/// is made when it is first shown.
class ReportPages : public QStackedWidget {
    Q_OBJECT

public:
    ReportPages(DocumentModel &model, Selection &selection, QWidget *parent = nullptr);

    void show(const EvaluatedDocument &evaluated);
    /// `before`: what comes before the page in the order of Tab.
    void showPage(Page page, QWidget *before = nullptr);
    /// What the report is called, for the head of the page; empty where it has no title.
    [[nodiscard]] QString subtitle() const;

signals:
    /// The next missing statement is asked for.
    void nextWanted();

protected:
    void changeEvent(QEvent *event) override;

private:
    [[nodiscard]] Form *make(Page page);

    DocumentModel &m_model;
    Selection &m_selection;
    EvaluatedDocument m_evaluated;
    std::map<Page, Form *> m_forms; ///< those that were shown
};

} // namespace palmer::ui
