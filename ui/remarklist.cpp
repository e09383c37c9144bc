// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/remarklist.h"

#include "ui/madewidgets.h"
#include "ui/theme.h"
#include "ui/windowlanguage.h"

#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <vector>

namespace palmer::ui {

namespace {

constexpr std::size_t remarksShown = 200; ///< a file with a million broken cells has as many remarks
constexpr std::size_t mostButtons = 3;    ///< more answers go into a menu

/// Mark in front of a remark: its shape carries the same meaning as its colour.
class GradeIcon : public QWidget {
public:
    GradeIcon(RemarkGrade grade, QWidget *parent)
        : QWidget(parent)
        , m_grade(grade) {
        setFixedSize(16, 16);
    }

protected:
    void paintEvent(QPaintEvent *) override {
        QPainter painter(this);
        const auto draw = [&](const char *icon, Token colour) {
            drawLineIcon(painter, rect(), QLatin1StringView(icon), token(colour, palette()));
        };
        switch (m_grade) {
        case RemarkGrade::problem:
            draw("miss", Token::bad);
            break;
        case RemarkGrade::assumption:
            draw("warn", Token::unsure);
            break;
        case RemarkGrade::note:
            draw("info", Token::secondaryText);
            break;
        }
    }

private:
    RemarkGrade m_grade;
};

QPushButton *addLink(QHBoxLayout &row, const QString &words, const QString &sentence) {
    auto *button = made<QPushButton>(trait::link, trait::notDefault, words);
    button->setAccessibleName(QStringLiteral("%1 – %2").arg(words, sentence));
    row.addWidget(button);
    return button;
}

struct Answer {
    QString word;
    QString name;
};

/// Displayed answers to a question; none if it is typed or chosen elsewhere.
std::vector<Answer> answersTo(const Question &question) {
    std::vector<Answer> answers;
    for (const std::string &answer : question.answers)
        answers.push_back({QString::fromStdString(answer), QString::fromStdString(answer)});
    const ImportKey *key = findImportKey(question.id);
    if (!key || !answers.empty())
        return answers;
    for (const ImportWord &word : key->words)
        answers.push_back({QString::fromLatin1(word.word), windowLanguage().text(word.name)});
    return answers;
}

} // namespace

bool canBeConfirmed(const Question &question) {
    return question.canBeAssumed();
}

const ImportChoice *guessOf(const Remark &remark, const Imported &imported) {
    const auto choice = std::ranges::find(imported.choices, remark.choice, &ImportChoice::key);
    return choice != imported.choices.end() && choice->origin == Origin::guessed ? &*choice : nullptr;
}

RemarkList::RemarkList(QWidget *parent)
    : QWidget(parent)
    , m_rows(new QVBoxLayout(this)) {
    setProperty("ground", QStringLiteral("base"));
    setAttribute(Qt::WA_StyledBackground);
    m_rows->setContentsMargins(12, 0, 12, 4);
    m_rows->setSpacing(0);
}

void RemarkList::clear() {
    while (QLayoutItem *item = m_rows->takeAt(0)) {
        if (item->widget()) {
            item->widget()->hide();
            item->widget()->deleteLater(); // the sender may be one of them
        }
        delete item;
    }
}

void RemarkList::showRemarks(const Imported &imported, const std::optional<QString> &refusal,
                             const std::function<bool(std::size_t)> &hasLine) {
    m_hasLine = hasLine;
    m_isNarrow = false;
    clear();
    if (refusal) {
        auto *reason =
            made<QLabel>("importRefusal", trait::reason, trait::plainText, trait::wrapped, *refusal);
        m_rows->addWidget(reason);
    }
    for (const Question &question : imported.questions)
        addQuestion(question);
    for (std::size_t i = 0; i < std::min(imported.remarks.size(), remarksShown); ++i) {
        const Remark &remark = imported.remarks[i];
        const QString sentence = windowLanguage().sentence(remark.message);
        QHBoxLayout *row = addRow(remark.grade, sentence, {remark.line, remark.column, remark.times});
        const ImportChoice *choice = guessOf(remark, imported);
        if (!choice)
            continue;
        const QString id = QString::fromStdString(remark.choice);
        QPushButton *button = addLink(*row, tr("confirm"), sentence);
        button->setObjectName(QStringLiteral("confirm.") + id);
        connect(button, &QPushButton::clicked, this,
                [this, id, word = QString::fromStdString(choice->value)] { emit answered(id, word); });
    }
    if (imported.remarks.size() > remarksShown)
        m_rows->addWidget(new QLabel(tr("… and %n more remark(s)", nullptr,
                                        static_cast<int>(imported.remarks.size() - remarksShown))));
    m_rows->addStretch();
}

void RemarkList::showQuestions(const std::vector<Question> &questions) {
    m_hasLine = [](std::size_t) { return false; };
    m_isNarrow = true;
    clear();
    for (const Question &question : questions)
        addQuestion(question);
}

bool RemarkList::focusFirst() {
    const QList<QPushButton *> links = findChildren<QPushButton *>();
    const auto first =
        std::ranges::find_if(links, [this](QPushButton *link) { return link->isVisibleTo(this); });
    if (first != links.end())
        (*first)->setFocus();
    return first != links.end();
}

/// Returns the place of its links: behind the sentence, or below it where the list is narrow. `word`: of its
/// grade; may be null.
QHBoxLayout *RemarkList::addRow(RemarkGrade grade, QString sentence, const Place &place, QLabel *word) {
    auto *row = new QWidget;
    auto *rows = new QVBoxLayout(row);
    rows->setContentsMargins(0, 2, 0, 2);
    rows->setSpacing(0);
    auto *layout = new QHBoxLayout;
    rows->addLayout(layout);
    auto *icon = new GradeIcon(grade, row);
    if (place.times > 1)
        sentence += QStringLiteral(" (× %1)").arg(place.times);
    if (place.line > 0 && place.column > 0)
        sentence = tr("Line %1, column %2: %3").arg(place.line).arg(place.column).arg(sentence);
    else if (place.line > 0)
        sentence = tr("Line %1: %2").arg(place.line).arg(sentence);
    auto *text = made<QLabel>(trait::plainText, trait::wrapped, sentence, row);
    layout->addWidget(icon);
    if (word)
        layout->addWidget(word);
    layout->addWidget(text, 1);
    if (m_isNarrow) {
        layout = new QHBoxLayout;
        layout->addStretch();
        rows->addLayout(layout);
    }
    if (m_hasLine(place.line))
        connect(addLink(*layout, tr("go to the line"), sentence), &QPushButton::clicked, this,
                [this, line = place.line] { emit lineWanted(line); });
    m_rows->addWidget(row);
    return layout;
}

void RemarkList::addQuestion(const Question &question) {
    const QString sentence = windowLanguage().sentence(question.sentence);
    const bool isDoubtful = question.grade == QuestionGrade::doubtful;
    auto *grade = new QLabel(isDoubtful ? tr("doubtful") : tr("assumed"));
    grade->setToolTip(isDoubtful ? tr("Something speaks against it: it wants an answer of its own.")
                                 : tr("The file does not say it and the usual holds."));
    grade->setFont(themeFont(TextSize::small));
    grade->setStyleSheet(
        QStringLiteral("color: %1;").arg(token(isDoubtful ? Token::bad : Token::unsure, palette()).name()));
    QHBoxLayout *row = addRow(isDoubtful ? RemarkGrade::problem : RemarkGrade::assumption, sentence,
                              {question.line, question.column, question.further.size() + 1}, grade);
    row->parentWidget()->setObjectName(QStringLiteral("question.") + QString::fromStdString(question.id));
    addAnswers(*row, question, sentence);
}

/// Adds the proposal as a button and the other answers next to it, or a link to where they are given.
void RemarkList::addAnswers(QHBoxLayout &row, const Question &question, const QString &sentence) {
    const QString id = QString::fromStdString(question.id);
    const QString proposal = QString::fromStdString(question.proposal);
    std::vector<Answer> answers = answersTo(question);
    const auto proposed = std::ranges::find(answers, proposal, &Answer::word);
    if (!proposal.isEmpty()) {
        const QString words =
            proposed == answers.end() ? tr("confirm") : tr("confirm: %1").arg(proposed->name);
        QPushButton *button = addLink(row, words, sentence);
        button->setObjectName(QStringLiteral("confirm.") + id);
        connect(button, &QPushButton::clicked, this, [this, id, proposal] { emit answered(id, proposal); });
        if (proposed != answers.end())
            answers.erase(proposed);
        else if (answers.empty() && findImportKey(question.id)) {
            QPushButton *other = addLink(row, tr("another answer"), sentence);
            other->setObjectName(QStringLiteral("other.") + id);
            connect(other, &QPushButton::clicked, this, [this, id] { emit answerWanted(id); });
        }
    }
    if (proposal.isEmpty() && answers.size() <= mostButtons) {
        for (const Answer &answer : answers) {
            QPushButton *button = addLink(row, answer.name, sentence);
            button->setObjectName(QStringLiteral("answer.%1.%2").arg(id, answer.word));
            connect(button, &QPushButton::clicked, this,
                    [this, id, word = answer.word] { emit answered(id, word); });
        }
        if (answers.empty())
            connect(addLink(row, tr("answer"), sentence), &QPushButton::clicked, this,
                    [this, id] { emit answerWanted(id); });
    } else if (!answers.empty()) {
        QPushButton *button =
            addLink(row, proposal.isEmpty() ? tr("answer") : tr("another answer"), sentence);
        button->setProperty("opens", true); // for a menu: leaves space for its arrow
        button->setObjectName(QStringLiteral("other.") + id);
        auto *menu = made<QMenu>(QStringLiteral("answers.") + id, button);
        for (const Answer &answer : answers) {
            QAction *action = menu->addAction(answer.name);
            action->setData(answer.word);
            connect(action, &QAction::triggered, this,
                    [this, id, word = answer.word] { emit answered(id, word); });
        }
        button->setMenu(menu);
    }
}

} // namespace palmer::ui
