// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/imported.h"
#include "ui/qtforward.h"

#include <QWidget>
#include <functional>
#include <optional>

namespace palmer::ui {

/// The questions to answer before an import is accepted, and what was understood, assumed or ignored: first
/// why nothing can be read, then the questions, each with its answers, then the remarks.
class RemarkList : public QWidget {
    Q_OBJECT

public:
    explicit RemarkList(QWidget *parent);

    /// `refusal`: why there is no measurement. `hasLine`: true if a line of the file can be shown.
    void showRemarks(const Imported &imported, const std::optional<QString> &refusal,
                     const std::function<bool(std::size_t line)> &hasLine);

    /// Shows only questions, e.g. those of a paste.
    void showQuestions(const std::vector<Question> &questions);
    /// Focuses the first answer. False if there is none.
    bool focusFirst();

signals:
    /// The question with this ID was answered.
    void answered(const QString &id, const QString &word);
    /// The question is to be answered elsewhere: in the box above the columns.
    void answerWanted(const QString &id);
    void lineWanted(std::size_t line);

private:
    struct Place {
        std::size_t line = 0;
        std::size_t column = 0;
        std::size_t times = 1;
    };

    void clear();
    QHBoxLayout *addRow(RemarkGrade grade, QString sentence, const Place &place, QLabel *word = nullptr);
    void addQuestion(const Question &question);
    void addAnswers(QHBoxLayout &row, const Question &question, const QString &sentence);

    std::function<bool(std::size_t)> m_hasLine;
    bool m_isNarrow = false; ///< links are below their sentence
    QVBoxLayout *m_rows;
};

/// True if the question may be answered together with others: it has a proposal, and confirming it leaves out
/// no data.
[[nodiscard]] bool canBeConfirmed(const Question &question);
/// The guess that a remark is about and that can be confirmed; null if there is none.
[[nodiscard]] const ImportChoice *guessOf(const Remark &remark, const Imported &imported);

} // namespace palmer::ui
