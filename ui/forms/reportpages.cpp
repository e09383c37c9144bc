#include "ui/forms/reportpages.h"

#include "ui/forms/identificationpage.h"
#include "ui/forms/instrumentspage.h"
#include "ui/forms/machinepage.h"
#include "ui/windowlanguage.h"

#include <QEvent>
#include <initializer_list>

namespace palmer::ui {

ReportPages::ReportPages(DocumentModel &model, Selection &selection, QWidget *parent)
    : QStackedWidget(parent)
    , m_identification(new IdentificationPage(model, selection, this))
    , m_machine(new MachinePage(model, selection, this))
    , m_instruments(new InstrumentsPage(model, selection, this)) {
    setObjectName(QStringLiteral("reportPages"));
    for (Form *page : std::initializer_list<Form *>{m_identification, m_machine, m_instruments}) {
        page->setLanguage(windowLanguage());
        addWidget(page);
        connect(page, &Form::nextWanted, this, &ReportPages::nextWanted);
    }
}

/// Which statements are missing is the same for all tests of a file, but for the instruments they name: the
/// first one is asked.
void ReportPages::show(const EvaluatedDocument &evaluated) {
    m_evaluated = evaluated;
    m_identification->show(evaluated, 0);
    m_machine->show(evaluated, 0);
    m_instruments->show(evaluated, 0);
}

void ReportPages::showPage(Page page) {
    switch (page) {
    case Page::machine:
        return setCurrentWidget(m_machine);
    case Page::instruments:
        return setCurrentWidget(m_instruments);
    default:
        return setCurrentWidget(m_identification);
    }
}

QString ReportPages::subtitle() const {
    return m_evaluated.document ? QString::fromStdString(m_evaluated.document->report.title) : QString();
}

void ReportPages::changeEvent(QEvent *event) {
    if (event->type() == QEvent::LanguageChange) {
        for (Form *page : std::initializer_list<Form *>{m_identification, m_machine, m_instruments})
            page->setLanguage(windowLanguage());
    }
    QStackedWidget::changeEvent(event);
}

} // namespace palmer::ui
