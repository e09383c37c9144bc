// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/forms/reportpages.h"

#include "ui/forms/equipmentpages.h"
#include "ui/forms/identificationpage.h"
#include "ui/forms/sheetpage.h"
#include "ui/windowlanguage.h"

namespace palmer::ui {

ReportPages::ReportPages(DocumentModel &model, Selection &selection, QWidget *parent)
    : Translated(parent)
    , m_model(model)
    , m_selection(selection) {
    setObjectName(QStringLiteral("reportPages"));
}

/// Missing statements of the report are the same for all tests, but for their instruments: uses the first
/// test.
void ReportPages::show(const EvaluatedDocument &evaluated) {
    m_evaluated = evaluated;
    for (const auto &[page, form] : m_forms)
        form->show(evaluated, 0);
}

void ReportPages::showPage(Page page, QWidget *before) {
    Form *&form = m_forms[page];
    if (!form) {
        form = make(page);
        form->setLanguage(windowLanguage());
        connect(form, &Form::nextWanted, this, &ReportPages::nextWanted);
        addWidget(form);
        if (m_evaluated.document)
            form->show(m_evaluated, 0);
        if (before)
            form->chainAfter(before);
    }
    setCurrentWidget(form);
}

Form *ReportPages::make(Page page) {
    switch (page) {
    case Page::machine:
        return new MachinePage(m_model, m_selection, this);
    case Page::instruments:
        return new InstrumentsPage(m_model, m_selection, this);
    case Page::sheet:
        return new SheetPage(m_model, this);
    default:
        return new IdentificationPage(m_model, m_selection, this);
    }
}

QString ReportPages::subtitle() const {
    return m_evaluated.document ? QString::fromStdString(m_evaluated.document->report.title) : QString();
}

void ReportPages::retranslate() {
    for (const auto &[page, form] : m_forms)
        form->setLanguage(windowLanguage());
}

} // namespace palmer::ui
