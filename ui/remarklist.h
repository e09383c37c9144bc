// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/imported.h"

#include <QWidget>
#include <functional>
#include <optional>

class QHBoxLayout;
class QVBoxLayout;

namespace palmer::ui {

/// What has to be answered before a measurement comes in, and what was understood, assumed or ignored: first
/// why nothing can be read, then the questions, each with its answers, then the remarks.
class RemarkList : public QWidget {
    Q_OBJECT

public:
    explicit RemarkList(QWidget *parent);

    /// `refusal`: why there is no measurement. `hasLine`: whether a line of the file can be shown.
    void showRemarks(const Imported &imported, const std::optional<QString> &refusal,
                     const std::function<bool(std::size_t line)> &hasLine);

    /// Questions alone, as those of a paste.
    void showQuestions(const std::vector<Question> &questions);

signals:
    /// An answer to the question of that id.
    void answered(const QString &id, const QString &word);
    /// The question is answered elsewhere: in the box of the choice, above the columns.
    void answerWanted(const QString &id);
    void lineWanted(std::size_t line);

private:
    struct Place {
        std::size_t line = 0;
        std::size_t column = 0;
        std::size_t times = 1;
    };

    void clear();
    QHBoxLayout *addRow(RemarkGrade grade, QString sentence, const Place &place);
    void addQuestion(const Question &question);
    void addAnswers(QHBoxLayout &row, const Question &question, const QString &sentence);

    std::function<bool(std::size_t)> m_hasLine;
    QVBoxLayout *m_rows;
};

/// Whether the question may be answered together with others: something is proposed, and no data would be
/// left out unseen.
[[nodiscard]] bool canBeConfirmed(const Question &question);

} // namespace palmer::ui
