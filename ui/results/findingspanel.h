// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "language/language.h"
#include "ui/model/page.h"
#include "ui/model/selection.h"
#include "ui/qtforward.h"
#include "ui/results/findingsmodel.h"
#include "ui/translated.h"

#include <QWidget>

namespace palmer::ui {

class ElidedLabel;

/// Requirements of the edition that the test does not meet. Never blocks anything.
class FindingsPanel : public Translated<QWidget, QEvent::FontChange> {
    Q_OBJECT

public:
    explicit FindingsPanel(Selection &selection, QWidget *parent = nullptr);

    void show(const EvaluatedDocument &evaluated, std::size_t test);
    void setLanguage(const Language &language);
    /// The page in view, whose findings come first.
    void setPage(Page page);
    /// Folds or unfolds the list; the header stays.
    void setFolded(bool folded);
    [[nodiscard]] QString lack() const { return m_model.lack(); }
    void setRows(int rows); ///< visible at once
    [[nodiscard]] bool isFolded() const { return m_folded; }

signals:
    /// A finding was chosen: show the page and focus the field of `id` (empty: only the page).
    void activated(palmer::ui::Page page, const QString &id);
    void foldedChanged(bool folded);

private:
    void refresh();
    void retranslate() final;
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
    QAction *m_go = nullptr; ///< of the context menu
    QAction *m_copy = nullptr;
};

} // namespace palmer::ui
