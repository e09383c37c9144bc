// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "language/language.h"
#include "ui/model/selection.h"
#include "ui/qtforward.h"
#include "ui/results/resultsmodel.h"
#include "ui/translated.h"

#include <QWidget>

namespace palmer::ui {

class ElidedLabel;
class ResultsDelegate;
class Chip;
class LinkChip;

/// The results of the test in view: numbers, decision scale, verdicts; if measured before and after an
/// adjustment, both side by side instead of the scale. Arrows move, Enter or a click explains.
class ResultsPanel : public Translated<QWidget, QEvent::FontChange> {
    Q_OBJECT

public:
    explicit ResultsPanel(Selection &selection, QWidget *parent = nullptr);

    void show(const EvaluatedDocument &evaluated, std::size_t test);
    void setLanguage(const Language &language);
    /// Hides the decision scale in narrow windows.
    void setNarrow(bool narrow);

    /// Copies the table to the clipboard: tab-separated for spreadsheets, HTML for texts.
    void copy();

signals:
    /// Status bar message about an action without visible effect.
    void said(const QString &text);
    /// The number of requirements that are not met or declared was clicked.
    void findingsWanted();

protected:
    void resizeEvent(QResizeEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void makeTable();
    void copyLine(int row);
    void followSelection();
    void arrange();
    void refresh();
    void explain(const QModelIndex &index);
    void showExplained();
    void fitColumns();
    void fitColumn(int place, int symbols, const QFontMetrics &metrics);
    void fitNames();
    void showVerdict();
    [[nodiscard]] QString rolesNote() const;
    void retranslate() final;

    Selection &m_selection;
    ResultsModel m_model;
    EvaluatedDocument m_evaluated;
    std::size_t m_test = 0;
    Language m_language{Language::Id::english};
    bool m_narrow = false;
    QLabel *m_title;
    ElidedLabel *m_rule;
    QLabel *m_viewNote;
    Chip *m_chip;           ///< the verdict
    Chip *m_limits;         ///< the first statement of the verdict
    LinkChip *m_accordance; ///< the second; leads to the findings
    QToolButton *m_copy;
    QTableView *m_table;
    ResultsDelegate *m_delegate;
};

} // namespace palmer::ui
