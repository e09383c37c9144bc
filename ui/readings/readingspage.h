#pragma once

#include "document/evaluateddocument.h"
#include "language/language.h"
#include "ui/model/selection.h"
#include "ui/readings/readingsmodel.h"

#include <QWidget>

class QButtonGroup;
class QToolButton;

namespace palmer::ui {

class ReadingsView;

/// The page "Readings" of a positioning test: what is shown and how it is grouped, and the table.
class ReadingsPage : public QWidget {
    Q_OBJECT

public:
    explicit ReadingsPage(Selection &selection, QWidget *parent = nullptr);
    ~ReadingsPage() override; ///< the table goes before the model it looks at

    void show(const EvaluatedDocument &evaluated, std::size_t test);
    void setLanguage(const Language &language);

signals:
    /// Mean and range of the readings selected, for the status bar; empty: nothing selected.
    void summaryChanged(const QString &text);

protected:
    void changeEvent(QEvent *event) override;

private:
    void retranslate();
    void markRuling();
    QToolButton *addSegment(QButtonGroup *group, const char *name, int id);

    Selection &m_selection;
    ReadingsModel m_model;
    ReadingsView *m_view;
    EvaluatedDocument m_evaluated;
    std::size_t m_test = 0;
    QToolButton *m_deviations;
    QToolButton *m_positions;
    QToolButton *m_byRun;
    QToolButton *m_byDirection;
};

} // namespace palmer::ui
