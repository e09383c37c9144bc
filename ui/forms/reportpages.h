#pragma once

#include "document/evaluateddocument.h"
#include "ui/model/page.h"

#include <QStackedWidget>

namespace palmer::ui {

class DocumentModel;
class IdentificationPage;
class InstrumentsPage;
class MachinePage;
class Selection;

/// The pages of the report that belong to no test: identification, machine, instruments.
class ReportPages : public QStackedWidget {
    Q_OBJECT

public:
    ReportPages(DocumentModel &model, Selection &selection, QWidget *parent = nullptr);

    void show(const EvaluatedDocument &evaluated);
    void showPage(Page page);
    /// What the report is called, for the head of the page; empty where it has no title.
    [[nodiscard]] QString subtitle() const;

signals:
    /// The next missing statement is asked for.
    void nextWanted();

protected:
    void changeEvent(QEvent *event) override;

private:
    EvaluatedDocument m_evaluated;
    IdentificationPage *m_identification;
    MachinePage *m_machine;
    InstrumentsPage *m_instruments;
};

} // namespace palmer::ui
