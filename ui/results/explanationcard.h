// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "language/language.h"
#include "ui/model/selection.h"
#include "ui/qtforward.h"
#include "ui/translated.h"

#include <QWidget>

namespace palmer::ui {

class ExplanationView;
class TargetBarsView;

/// Explains the chosen result: formula, the numbers of this test inserted, clause, and the contribution of
/// each target. Closing it clears the selected parameter.
class ExplanationCard : public Translated<QWidget, QEvent::FontChange> {
    Q_OBJECT

public:
    explicit ExplanationCard(Selection &selection, QWidget *parent = nullptr);

    void show(const EvaluatedDocument &evaluated, std::size_t test);
    void setLanguage(const Language &language);

    /// Copies the explanation to the clipboard as text.
    void copy();

signals:
    /// Status bar message about an action without visible effect.
    void said(const QString &text);

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    void refresh();
    void retranslate() final;

    Selection &m_selection;
    EvaluatedDocument m_evaluated;
    std::size_t m_test = 0;
    Language m_language{Language::Id::english};
    QLabel *m_name;
    QLabel *m_source;
    QLabel *m_keys;
    QToolButton *m_copy;
    QToolButton *m_close;
    ExplanationView *m_view;
    TargetBarsView *m_bars;
};

} // namespace palmer::ui
