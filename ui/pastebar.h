// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editing/readingblock.h"
#include "ui/qtforward.h"
#include "ui/translated.h"

#include <QFrame>
#include <optional>

namespace palmer::ui {

class RemarkList;

/// Shows above the table what a paste did and how it was interpreted, until the next action. Choosing another
/// interpretation pastes again.
class PasteBar : public Translated<QFrame> {
    Q_OBJECT

public:
    explicit PasteBar(QWidget *parent = nullptr);

    /// `summary` says what was pasted; its units can be changed, its questions are to be answered before
    /// anything is put. `motion`: of readings, whose content can be chosen.
    void say(const QString &summary, const Pasted &pasted, bool canUndo, std::optional<Motion> motion = {});

    /// Says how many readings and targets were pasted and erased.
    [[nodiscard]] static QString summaryOf(const PastedBlock &pasted);
    /// The key of the choice of their content; its words are the numbers of BlockContent.
    static constexpr const char *content = "pasteContent";

signals:
    /// Another value for a choice, or the answer to a question.
    void answered(const QString &key, const QString &word);
    void undoWanted();

private:
    void retranslate() final;
    void askFor(const QString &key);
    void nameContents(Motion motion);
    void showChoice(const ImportChoice &choice);
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
    std::vector<Question> m_asked;
    QToolButton *m_undo;
    QToolButton *m_close;
};

} // namespace palmer::ui
