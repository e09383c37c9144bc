// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "language/language.h"
#include "ui/model/page.h"
#include "ui/model/selection.h"
#include "ui/results/findingsmodel.h"

#include <QWidget>

class QLabel;
class QListView;
class QToolButton;

namespace palmer::ui {

class ElidedLabel;

/// What the edition asks for and the test does not have. Never in the way of anything.
class FindingsPanel : public QWidget {
    Q_OBJECT

public:
    explicit FindingsPanel(Selection &selection, QWidget *parent = nullptr);

    void show(const EvaluatedDocument &evaluated, std::size_t test);
    void setLanguage(const Language &language);
    /// The page in view, whose findings stand first.
    void setPage(Page page);
    /// Folds the list away, or opens it again; the head stays.
    void setFolded(bool folded);
    void setRows(int rows); ///< that are in sight at once
    [[nodiscard]] bool isFolded() const { return m_folded; }

signals:
    /// A finding was chosen: go to the page, and to the field of `id` (empty: the page alone).
    void activated(palmer::ui::Page page, const QString &id);
    void foldedChanged(bool folded);

protected:
    void changeEvent(QEvent *event) override;

private:
    void refresh();
    void retranslate();
    void activate(const QModelIndex &index);

    FindingsModel m_model;
    EvaluatedDocument m_evaluated;
    std::size_t m_test = 0;
    Page m_page = Page::readings;
    Language m_language{Language::Id::english};
    bool m_folded = false;
    QLabel *m_title;
    ElidedLabel *m_summary;
    QToolButton *m_fold;
    QListView *m_list;
};

} // namespace palmer::ui
