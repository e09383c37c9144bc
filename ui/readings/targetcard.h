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

class TargetStripView;
class TargetStatisticsView;

/// The detail card of the current target (by default the first): its readings in the order of the runs, with
/// bands and means of both directions, and x̄ s R B.
class TargetCard : public Translated<QWidget, QEvent::FontChange> {
    Q_OBJECT

public:
    explicit TargetCard(Selection &selection, QWidget *parent = nullptr);

    void show(const EvaluatedDocument &evaluated, std::size_t test);
    void setLanguage(const Language &language);
    /// For the context menu of the strip, whose readings are chosen in the table by a click.
    void addStripActions(const QList<QAction *> &actions);

private:
    void refresh();
    void step(int by);
    void retranslate() final;
    [[nodiscard]] std::size_t current() const;
    [[nodiscard]] std::size_t count() const;

    Selection &m_selection;
    EvaluatedDocument m_evaluated;
    std::size_t m_test = 0;
    Language m_language{Language::Id::english};
    QLabel *m_title;
    QLabel *m_position;
    QToolButton *m_previous;
    QToolButton *m_next;
    TargetStripView *m_strip;
    TargetStatisticsView *m_statistics;
};

} // namespace palmer::ui
