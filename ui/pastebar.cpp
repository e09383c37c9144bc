// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pastebar.h"

#include "tables/units.h"
#include "ui/madewidgets.h"
#include "ui/remarklist.h"
#include "ui/theme.h"
#include "ui/windowlanguage.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QInputDialog>
#include <QLabel>
#include <QToolButton>

namespace palmer::ui {

PasteBar::PasteBar(QWidget *parent)
    : Translated(parent)
    , m_summary(made<QLabel>("pasteSummary", this))
    , m_remarks(made<QLabel>("pasteRemarks", TextSize::small, trait::wrapped, trait::plainText, this))
    , m_guess(made<QLabel>(TextSize::small, trait::secondary, this))
    , m_marks(new QButtonGroup(this))
    , m_comma(made<QToolButton>("pasteComma", trait::checkable, trait::strongFocus, trait::segment("first"),
                                this))
    , m_point(
          made<QToolButton>("pastePoint", trait::checkable, trait::strongFocus, trait::segment("last"), this))
    , m_content(made<QComboBox>("pasteContent", trait::strongFocus, this))
    , m_boxes(new QHBoxLayout)
    , m_questions(made<RemarkList>("pasteQuestions", this))
    , m_undo(made<QToolButton>("pasteUndo", trait::strongFocus, this))
    , m_close(made<QToolButton>("pasteClose", trait::iconOnly, trait::strongFocus, this)) {
    setObjectName(QStringLiteral("pasteBar"));
    setProperty("bar", true);
    m_summary->setWordWrap(true); // in a narrow window the choices leave it little width
    for (QToolButton *button : {m_point, m_comma})
        m_marks->addButton(button);
    m_undo->setIcon(lineIcon(QStringLiteral("undo")));
    m_undo->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_close->setIcon(lineIcon(QStringLiteral("close")));
    m_content->addItems({{}, {}, {}}); // BlockContent

    auto *marks = inRow(0, {m_comma, m_point});
    auto *row = inRow(8, {{m_summary, 1}, m_guess, marks, m_content, m_boxes, m_undo, m_close});
    inColumn(this, {8, 4, 4, 4}, 2, {row, m_remarks, m_questions});

    connect(m_questions, &RemarkList::answered, this, &PasteBar::answered);
    connect(m_questions, &RemarkList::answerWanted, this, &PasteBar::askFor);
    connect(m_marks, &QButtonGroup::buttonClicked, this, [this](const QAbstractButton *mark) {
        emit answered(QStringLiteral("decimalMark"),
                      mark == m_comma ? QStringLiteral("comma") : QStringLiteral("point"));
    });
    connect(m_content, &QComboBox::activated, this,
            [this](int number) { emit answered(QString::fromLatin1(content), QString::number(number)); });
    connect(m_undo, &QToolButton::clicked, this, &PasteBar::undoWanted);
    connect(m_close, &QToolButton::clicked, this, &QWidget::hide);
    retranslate();
}

QString PasteBar::summaryOf(const PastedBlock &pasted) {
    QString summary = tr("%n reading(s) pasted", nullptr, static_cast<int>(pasted.readings));
    if (pasted.targets > 0)
        summary = tr("%1 and %n target(s)", "readings pasted", static_cast<int>(pasted.targets)).arg(summary);
    if (const std::size_t byNothing = pasted.erased - pasted.erasedByWords; byNothing > 0)
        summary =
            tr("%1, %n erased by empty cells", "readings pasted", static_cast<int>(byNothing)).arg(summary);
    if (pasted.erasedByWords > 0)
        summary = tr("%1, %n erased by cells that are no numbers", "readings pasted",
                     static_cast<int>(pasted.erasedByWords))
                      .arg(summary);
    return summary;
}

void PasteBar::say(const QString &summary, const Pasted &pasted, bool canUndo, std::optional<Motion> motion) {
    m_summary->setText(pasted.questions.empty() ? summary
                                                : tr("Nothing is put before the questions are answered."));
    for (QWidget *part : std::initializer_list<QWidget *>{m_guess, m_comma, m_point})
        part->hide();
    while (QLayoutItem *item = m_boxes->takeAt(0)) {
        item->widget()->deleteLater(); // the sender may be one of them
        delete item;
    }
    m_content->setVisible(motion.has_value());
    if (motion)
        nameContents(*motion);
    for (const ImportChoice &choice : pasted.units)
        showChoice(choice);
    QStringList remarks;
    for (const Message &remark : pasted.remarks)
        remarks << windowLanguage().sentence(remark);
    m_undo->setVisible(canUndo);
    m_remarks->setText(remarks.join(QStringLiteral(" · ")));
    m_remarks->setVisible(!remarks.isEmpty());
    m_asked = pasted.questions;
    m_questions->showQuestions(m_asked);
    m_questions->setVisible(!pasted.questions.empty());
    setAccessibleDescription(m_summary->text() + QStringLiteral(". ") + m_remarks->text());
    show();
}

void PasteBar::nameContents(Motion motion) {
    const bool linear = motion == Motion::linear;
    const QString small = windowLanguage().unit(linear ? Quantity::deviation : Quantity::angularDeviation);
    const QString large = windowLanguage().unit(linear ? Quantity::position : Quantity::angle);
    m_content->setItemText(0, tr("Deviations %1", "unit").arg(small));
    m_content->setItemText(1, tr("Deviations %1", "unit").arg(large));
    m_content->setItemText(2, tr("Positions %1", "unit").arg(large));
}

void PasteBar::showChoice(const ImportChoice &choice) {
    if (choice.key == content) {
        m_content->setCurrentIndex(std::stoi(choice.value)); // −1: a unit that is none of the choices
    } else if (choice.key == "decimalMark") {
        m_guess->setVisible(choice.origin == Origin::guessed);
        m_comma->show();
        m_point->show();
        (choice.value == "comma" ? m_comma : m_point)->setChecked(true);
    } else {
        addBox(choice);
    }
}

/// A box with the units of one kind.
void PasteBar::addBox(const ImportChoice &choice) {
    const ImportKey &key = *findImportKey(choice.key);
    const Unit *now = unitOf(choice.value);
    auto *box = made<QComboBox>(QStringLiteral("paste.") + QString::fromStdString(choice.key), this);
    box->setAccessibleName(windowLanguage().text(key.name));
    box->setToolTip(box->accessibleName());
    box->setFocusPolicy(Qt::StrongFocus);
    for (const ImportWord &word : key.words) {
        if (const Unit *unit = unitOf(word.word); unit && now && unit->kind == now->kind)
            box->addItem(windowLanguage().text(word.name), QString::fromLatin1(word.word));
    }
    box->setCurrentIndex(box->findData(QString::fromStdString(choice.value))); // −1: a unit that is no choice
    connect(box, &QComboBox::activated, this, [this, box, name = box->objectName().mid(6)] {
        emit answered(name, box->currentData().toString());
    });
    m_boxes->addWidget(box);
}

/// Asks for an answer that no list contains.
void PasteBar::askFor(const QString &key) {
    const ImportKey *found = findImportKey(key.toStdString());
    auto *dialog = made<QInputDialog>("answerDialog", this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Answer"));
    dialog->setLabelText(found ? windowLanguage().text(found->name) : key);
    const auto asked = std::ranges::find(m_asked, key.toStdString(), &Question::id);
    if (asked != m_asked.end())
        dialog->setTextValue(QString::fromStdString(asked->proposal)); // shows the form of an answer
    connect(dialog, &QInputDialog::textValueSelected, this,
            [this, key](const QString &word) { emit answered(key, word.trimmed()); });
    dialog->open();
}

void PasteBar::retranslate() {
    setAccessibleName(tr("What was pasted"));
    m_guess->setText(tr("guessed:"));
    m_comma->setText(tr("Comma"));
    m_point->setText(tr("Point"));
    m_comma->setToolTip(tr("The decimal mark of the block is the comma: 5,4"));
    m_point->setToolTip(tr("The decimal mark of the block is the point: 5.4"));
    m_content->setAccessibleName(tr("What the numbers are"));
    m_content->setToolTip(tr("What the numbers are, and in which unit"));
    m_undo->setText(tr("Undo"));
    m_undo->setAccessibleName(tr("Undo the paste"));
    m_undo->setToolTip(tr("Takes back what was pasted, also what it has erased"));
    nameWidget(*m_close, tr("Close"));
    hide(); // its sentences are in the language before
}

} // namespace palmer::ui
