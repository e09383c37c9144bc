// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editing/readingblock.h"
#include "import/choices.h"
#include "import/question.h"
#include "language/language.h"
#include "ui/qtforward.h"
#include "ui/translated.h"

#include <QFrame>

namespace palmer::ui {

class RemarkList;

/// Shows above the table what a paste did and how it was interpreted, until the next action. Choosing another
/// interpretation pastes again.
class PasteBar : public Translated<QFrame> {
    Q_OBJECT

public:
    explicit PasteBar(QWidget *parent = nullptr);

    void show(const PastedBlock &pasted, const BlockChoices &choices, const Language &language, bool canUndo);
    /// The same for another table: `pasted` says what; `choices` can be changed (units); `questions` are to
    /// be answered before anything is put.
    void say(const QString &pasted, const QStringList &remarks, const std::vector<ImportChoice> &choices,
             const std::vector<Question> &questions, bool canUndo);

signals:
    /// Another value for a choice, or the answer to a question.
    void answered(const QString &key, const QString &word);
    void decimalMarkChosen(palmer::DecimalMark mark);
    void contentChosen(palmer::BlockContent content);
    void undoWanted();

private:
    void retranslate() final;
    void summarise(const QString &pasted, const std::vector<Question> &questions);
    void askFor(const QString &key);
    void showRemarks(const QStringList &remarks, const std::vector<Question> &questions, bool canUndo);
    void addBox(const ImportChoice &choice);

    QLabel *m_summary;
    QLabel *m_remarks;
    QLabel *m_guess;
    QButtonGroup *m_marks;
    QToolButton *m_comma;
    QToolButton *m_point;
    QComboBox *m_content;
    QHBoxLayout *m_boxes; ///< for other choices
    RemarkList *m_questions;
    QToolButton *m_undo;
    QToolButton *m_close;
};

} // namespace palmer::ui
